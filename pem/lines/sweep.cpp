#include "pem/lines/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "pem/lines/judged_case.hpp"
#include "pem/response_names.hpp"
#include "pem/threads.hpp"
#include "spectra/comfort.hpp"
#include "spectra/integrate_psd.hpp"

namespace railpem::pem {

namespace {

/// SplitMix64 (Steele, Lea & Flood 2014).
std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

double unit_interval(std::uint64_t key, std::uint64_t counter) {
    return static_cast<double>(mix(mix(key) ^ counter) >> 11) * 0x1p-53;
}

/// A keyed bijection of 0 … size − 1: a four-round Feistel network on the next even number of bits, walked until it
/// lands inside.
std::size_t permuted(std::size_t index, std::size_t size, std::uint64_t key) {
    int half = 1;
    while ((std::size_t{1} << (2 * half)) < size) ++half;
    const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
    std::uint64_t x = index;
    do {
        std::uint64_t left = x >> half, right = x & mask;
        for (std::uint64_t round = 0; round < 4; ++round) {
            const std::uint64_t next = left ^ (mix(key ^ mix(right + (round << 48))) & mask);
            left = right;
            right = next;
        }
        x = (left << half) | right;
    } while (x >= size);
    return static_cast<std::size_t>(x);
}

double hypercube_value(const SweepPlan& plan, std::size_t axis, std::size_t index) {
    const std::uint64_t key = mix(plan.seed * 0x100 + axis);
    const double stratum = static_cast<double>(permuted(index, plan.samples, key)) + unit_interval(key ^ 0x5eed, index);
    const double share = stratum / static_cast<double>(plan.samples);
    const SweepAxis& a = plan.axes[axis];
    if (a.logarithmic) return a.low * std::pow(a.high / a.low, share);
    return a.low + share * (a.high - a.low);
}

const char* quantity_unit(QuantityKind kind, Quantity quantity) {
    const bool force = quantity == Quantity::force;
    switch (kind) {
        case QuantityKind::rms:
            return force ? "rms_n" : "rms_m_per_s2";
        case QuantityKind::peak_level:
            return force ? "peak_level_n2_per_hz" : "peak_level_m2_per_s4_per_hz";
        case QuantityKind::peak_frequency:
            return "peak_frequency_hz";
        case QuantityKind::bands:
            return force ? "level_db_re_1_n" : "level_db";
        case QuantityKind::spectrum:
            return force ? "psd_n2_per_hz" : "psd_m2_per_s4_per_hz";
        case QuantityKind::weighted_rms_iso2631:
            return "weighted_rms_iso2631_m_per_s2";
        case QuantityKind::mean_comfort_en12299:
            return "mean_comfort_en12299";
        case QuantityKind::sperling_index:
            return "sperling_index";
    }
    return "";
}

double comfort_of(QuantityKind kind, const std::vector<double>& lines, const std::vector<double>& psd) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    if (kind == QuantityKind::weighted_rms_iso2631) return spectra::weighted_rms_iso2631(lines, psd).value_or(kUnknown);
    if (kind == QuantityKind::sperling_index) return spectra::sperling_index_vertical(lines, psd).value_or(kUnknown);
    const auto vertical = spectra::vertical_comfort_en12299(lines, psd);
    return vertical ? vertical->mean_comfort : kUnknown;
}

void append_quantity(const SweepPlan& plan, const SweepQuantity& wanted, const JudgedCase& judged,
                     std::vector<double>& out) {
    const std::size_t response = response_index(wanted.response);
    const std::vector<double> psd = judged.psd(response);
    switch (wanted.kind) {
        case QuantityKind::rms:
            out.push_back(spectra::root_mean_square(judged.lines(), psd));
            break;
        case QuantityKind::peak_level:
            out.push_back(*std::max_element(psd.begin(), psd.end()));
            break;
        case QuantityKind::peak_frequency:
            out.push_back(
                judged.lines()[static_cast<std::size_t>(std::max_element(psd.begin(), psd.end()) - psd.begin())]);
            break;
        case QuantityKind::bands: {
            const std::vector<double> levels = plan.bands.levels(judged.lines(), psd);
            out.insert(out.end(), levels.begin(), levels.end());
            break;
        }
        case QuantityKind::spectrum: {
            const std::vector<double> table = response_psd(judged.solution, response);
            out.insert(out.end(), table.begin(), table.end());
            break;
        }
        case QuantityKind::weighted_rms_iso2631:
        case QuantityKind::mean_comfort_en12299:
        case QuantityKind::sperling_index:
            out.push_back(comfort_of(wanted.kind, judged.lines(), psd));
            break;
    }
}

std::vector<double> evaluate(const SweepPlan& plan, std::size_t index, int threads, const SweepObserver& observer) {
    const CaseParameters parameters = sweep_case(plan, index);
    std::vector<double> values;
    for (const double speed : parameters.running.speeds_m_per_s) {
        const JudgedCase judged = solve_judged(parameters, speed, {.threads = threads});
        if (const auto warnings = warnings_beside_validity(parameters, judged.solution.warnings);
            observer.warned && !warnings.empty())
            observer.warned(index, speed, warnings);
        for (const SweepQuantity& quantity : plan.quantities) append_quantity(plan, quantity, judged, values);
    }
    return values;
}

}  // namespace

std::size_t sweep_size(const SweepPlan& plan) {
    if (plan.design == Design::latin_hypercube) return plan.samples;
    if (plan.axes.empty()) return 1;
    if (plan.design == Design::list) return plan.axes.front().values.size();
    std::size_t size = 1;
    for (const SweepAxis& axis : plan.axes) size *= axis.values.size();
    return size;
}

std::vector<double> sweep_values(const SweepPlan& plan, std::size_t index) {
    std::vector<double> values(plan.axes.size());
    for (std::size_t axis = plan.axes.size(); axis-- > 0;) {
        const std::vector<double>& choices = plan.axes[axis].values;
        switch (plan.design) {
            case Design::latin_hypercube:
                values[axis] = hypercube_value(plan, axis, index);
                break;
            case Design::list:
                values[axis] = choices[index];
                break;
            case Design::grid:
                values[axis] = choices[index % choices.size()];
                index /= choices.size();
                break;
        }
    }
    return values;
}

CaseParameters sweep_case(const SweepPlan& plan, std::size_t index) {
    CaseParameters parameters = plan.base;
    const std::vector<double> values = sweep_values(plan, index);
    for (std::size_t axis = 0; axis < values.size(); ++axis) plan.axes[axis].set(parameters, values[axis]);
    return parameters;
}

std::vector<SweepRow> sweep_rows(const SweepPlan& plan) {
    const std::vector<double> lines = frequency_lines(plan.base.frequency);
    std::vector<SweepRow> rows;
    for (const double speed : plan.base.running.speeds_m_per_s)
        for (const SweepQuantity& wanted : plan.quantities) {
            const ResponseName& name = response_names()[response_index(wanted.response)];
            const std::string quantity = quantity_unit(wanted.kind, name.quantity);
            if (wanted.kind == QuantityKind::bands)
                for (const double centre : plan.bands.centre_hz)
                    rows.push_back({speed, quantity, wanted.response, centre});
            else if (wanted.kind == QuantityKind::spectrum)
                for (const double line : lines) rows.push_back({speed, quantity, wanted.response, line});
            else
                rows.push_back({speed, quantity, wanted.response, std::numeric_limits<double>::quiet_NaN()});
        }
    return rows;
}

void run_sweep(const SweepPlan& plan, int threads, const SweepObserver& observer) {
    const std::size_t cases = sweep_size(plan);
    const int available = thread_count(threads);
    const bool few = cases < static_cast<std::size_t>(available);
    std::atomic<std::size_t> counter{0};
    const auto in_order = [&]() -> std::optional<std::size_t> {
        const std::size_t index = counter++;
        return index < cases ? std::optional(index) : std::nullopt;
    };
    const std::function<std::optional<std::size_t>()> next = observer.next ? observer.next : in_order;
    TeamFailure failure;
#pragma omp parallel num_threads(few ? 1 : available)
    for (bool more = true; more;) {
        more = false;
        failure.guard([&] {
            const std::optional<std::size_t> index = next();
            if (!index) return;
            if (!observer.finished(*index))
                observer.done(*index, evaluate(plan, *index, few ? available : 1, observer));
            more = true;
        });
    }
    failure.rethrow();
}

}  // namespace railpem::pem
