#include "pem/coupling/prepared_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <optional>

#include "pem/angular_frequency.hpp"
#include "pem/coupling/excite.hpp"
#include "pem/coupling/linearise.hpp"
#include "pem/coupling/sensor_chain.hpp"
#include "pem/threads.hpp"
#include "spectra/validity.hpp"

namespace railpem::pem {

namespace {

bool is_zero(const WheelVector& irregularity) {
    for (const lanes::Complex& e : irregularity)
        for (int lane = 0; lane < lanes::width; ++lane)
            if (e.re[lane] != 0.0 || e.im[lane] != 0.0) return false;
    return true;
}

/// Broadband sources as spectra with the delays of the wheels, lines as sources that look at the bins of a grid.
std::vector<PreparedSource> sources_of(const CaseParameters& parameters, const CoupledModel& model, double speed) {
    Excitation all = excitation(parameters, model.wheels_m, speed, nullptr, &model);
    std::vector<PreparedSource> sources;
    for (DelayedSpectrum& spectrum : all.broadband)
        sources.push_back({delayed_source(std::move(spectrum), model.wheels_m, speed), {}});
    for (LineSet& set : all.lines) {
        std::vector<double> teeth;
        for (const SpectralLine& line : set.lines)
            if (std::any_of(line.amplitude_m.begin(), line.amplitude_m.end(),
                            [](const std::complex<double>& amplitude) { return amplitude != 0.0; }))
                teeth.push_back(line.frequency_hz);
        std::sort(teeth.begin(), teeth.end());
        sources.push_back(
            {line_source(set.name, std::move(set.lines), parameters.running.speed_fluctuation), std::move(teeth)});
    }
    return sources;
}

/// What the wheels meet of a source on one group of lines. A line source looks at nothing but its bin, so that a bin
/// which is not symmetric about its line is asked for by its middle.
WheelVector amplitude(const PreparedSource& own, lanes::Real omega, const FrequencyLines& all, std::size_t first) {
    if (own.teeth_hz.empty()) return own.source.amplitude({omega, 1.0});
    WheelVector result;
    for (int lane = 0; lane < lanes::width; ++lane) {
        const std::size_t line = std::min(first + static_cast<std::size_t>(lane), all.frequency_hz.size() - 1);
        const double below = all.below_hz[line], above = all.above_hz[line];
        const double middle = omega[lane] / kTwoPi + 0.5 * (above - below);
        const WheelVector one = own.source.amplitude({lanes::broadcast(kTwoPi * middle), below + above});
        for (std::size_t wheel = 0; wheel < result.size(); ++wheel) result[wheel].set(lane, one[wheel][0]);
    }
    return result;
}

/// Pseudo-responses of one group of lines for every source.
void store_group(const GroupSolution& group, const std::vector<PreparedSource>& sources, const FrequencyLines& all,
                 std::size_t first_line, Solution& solution) {
    const std::size_t lines = solution.frequency_hz.size();
    const std::size_t count = std::min<std::size_t>(lanes::width, lines - first_line);
    const std::size_t responses_count = response_names().size();
    std::array<lanes::Complex, 32> response;
    assert(responses_count <= response.size());
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const WheelVector irregularity = amplitude(sources[s], group.omega, all, first_line);
        if (is_zero(irregularity)) continue;  // between spectral lines; the rows are zero already
        responses(group, irregularity, response.data());
        for (std::size_t r = 0; r < responses_count; ++r) {
            std::complex<double>* row =
                solution.pseudo_response.data() + (s * responses_count + r) * lines + first_line;
            for (std::size_t lane = 0; lane < count; ++lane) row[lane] = response[r][static_cast<int>(lane)];
        }
    }
}

/// Above this share of open contact the Gaussian closure is not to be trusted (Roberts & Spanos: mild nonlinearity).
constexpr double kDoubtfulLoss = 0.01;

void warn_of_linearisation(PreparedCase& prepared) {
    const Linearisation& l = prepared.linearisation;
    const double open = *std::max_element(l.loss_of_contact_probability.begin(), l.loss_of_contact_probability.end());
    if (open > kDoubtfulLoss)
        prepared.warnings.push_back(fmt::format(
            "a wheel loses contact in {:.1f} % of the time; the linearised contact is not reliable", 100.0 * open));
    if (l.change > 1e-6)
        prepared.warnings.push_back(
            fmt::format("the linearisation still changes by {:.1e} after {} iterations", l.change, l.iterations));
}

}  // namespace

PreparedCase prepare_case(const CaseParameters& parameters, double speed_m_per_s) {
    PreparedCase prepared{.speed_m_per_s = speed_m_per_s, .model = coupled_model(parameters, speed_m_per_s)};
    std::vector<Source> sources;
    for (PreparedSource& own : sources_of(parameters, prepared.model, speed_m_per_s)) {
        sources.push_back(own.source);
        prepared.sources.push_back(std::move(own));
    }
    prepared.linearisation = linearise(parameters, sources, prepared.model);
    prepared.warnings = prepared.model.warnings;
    for (std::string& warning : spectra::validity_warnings(parameters.irregularity))
        prepared.warnings.push_back(std::move(warning));
    warn_of_linearisation(prepared);
    return prepared;
}

FrequencyLines with_bins(std::vector<double> frequency_hz) {
    const std::size_t count = frequency_hz.size();
    assert(count >= 2);
    FrequencyLines lines{.frequency_hz = std::move(frequency_hz),
                         .below_hz = std::vector<double>(count),
                         .above_hz = std::vector<double>(count)};
    for (std::size_t i = 0; i + 1 < count; ++i)
        lines.above_hz[i] = lines.below_hz[i + 1] = 0.5 * (lines.frequency_hz[i + 1] - lines.frequency_hz[i]);
    lines.below_hz.front() = lines.above_hz.front();
    lines.above_hz.back() = lines.below_hz.back();
    return lines;
}

Solution solve_lines(const CaseParameters& parameters, const PreparedCase& prepared, const FrequencyLines& all,
                     const SolveOptions& options) {
    Solution solution{.speed_m_per_s = prepared.speed_m_per_s,
                      .frequency_hz = all.frequency_hz,
                      .warnings = prepared.warnings,
                      .linearisation = prepared.linearisation};
    for (const PreparedSource& own : prepared.sources) solution.source_names.push_back(own.source.name);
    const std::size_t lines = solution.frequency_hz.size();
    solution.pseudo_response.resize(prepared.sources.size() * response_names().size() * lines);

    const std::size_t groups = (lines + lanes::width - 1) / lanes::width;
    std::atomic<std::size_t> done{0};
    TeamFailure failure;
#pragma omp parallel num_threads(thread_count(options.threads))
    {
        std::optional<CoupledWorkspace> workspace;
        failure.guard([&] { workspace.emplace(prepared.model); });
#pragma omp for schedule(dynamic, 4)
        for (std::size_t group = 0; group < groups; ++group)
            failure.guard([&] {
                if (options.interrupted && options.interrupted()) throw Interrupted{};
                const GroupSolution& solved =
                    solve_group(prepared.model, group_omega(solution.frequency_hz, group), *workspace);
                store_group(solved, prepared.sources, all, group * lanes::width, solution);
                const std::size_t now = done += lanes::width;
                if (options.progress && thread_number() == 0) options.progress(std::min(now, lines), lines);
            });
    }
    failure.rethrow();
    apply_sensors(parameters, solution);
    return solution;
}

}  // namespace railpem::pem
