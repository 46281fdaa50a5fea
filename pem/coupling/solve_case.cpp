#include "pem/coupling/solve_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <optional>

#include "pem/angular_frequency.hpp"
#include "pem/coupling/coupled_model.hpp"
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

/// Pseudo-responses of one group of lines for every source.
void store_group(const GroupSolution& group, const std::vector<Source>& sources, double step_hz, std::size_t first_line,
                 Solution& solution) {
    const std::size_t lines = solution.frequency_hz.size();
    const std::size_t count = std::min<std::size_t>(lanes::width, lines - first_line);
    const std::size_t responses_count = response_names().size();
    std::array<lanes::Complex, 32> response;
    assert(responses_count <= response.size());
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const WheelVector irregularity = sources[s].amplitude({group.omega, step_hz});
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

void warn_of_linearisation(Solution& solution) {
    const Linearisation& l = solution.linearisation;
    const double open = *std::max_element(l.loss_of_contact_probability.begin(), l.loss_of_contact_probability.end());
    if (open > kDoubtfulLoss)
        solution.warnings.push_back(fmt::format(
            "a wheel loses contact in {:.1f} % of the time; the linearised contact is not reliable", 100.0 * open));
    if (l.change > 1e-6)
        solution.warnings.push_back(
            fmt::format("the linearisation still changes by {:.1e} after {} iterations", l.change, l.iterations));
}

}  // namespace

Solution solve_case(const CaseParameters& parameters, double speed_m_per_s, const SolveOptions& options) {
    CoupledModel model = coupled_model(parameters, speed_m_per_s);
    const std::vector<Source> sources = excitation_sources(parameters, model.wheels_m, speed_m_per_s, &model);
    Solution solution;
    solution.linearisation = linearise(parameters, sources, model);
    solution.speed_m_per_s = speed_m_per_s;
    solution.frequency_hz = frequency_lines(parameters.frequency);
    solution.warnings = model.warnings;
    for (std::string& warning : spectra::validity_warnings(parameters.irregularity))
        solution.warnings.push_back(std::move(warning));
    warn_of_linearisation(solution);
    for (const Source& source : sources) solution.source_names.push_back(source.name);
    const std::size_t lines = solution.frequency_hz.size();
    solution.pseudo_response.resize(sources.size() * response_names().size() * lines);

    const std::size_t groups = (lines + lanes::width - 1) / lanes::width;
    std::atomic<std::size_t> done{0};
    TeamFailure failure;
#pragma omp parallel num_threads(thread_count(options.threads))
    {
        std::optional<CoupledWorkspace> workspace;
        failure.guard([&] { workspace.emplace(model); });
#pragma omp for schedule(dynamic, 4)
        for (std::size_t group = 0; group < groups; ++group)
            failure.guard([&] {
                if (options.interrupted && options.interrupted()) throw Interrupted{};
                const GroupSolution& solved = solve_group(model, group_omega(solution.frequency_hz, group), *workspace);
                store_group(solved, sources, parameters.frequency.step_hz, group * lanes::width, solution);
                const std::size_t now = done += lanes::width;
                if (options.progress && thread_number() == 0) options.progress(std::min(now, lines), lines);
            });
    }
    failure.rethrow();
    apply_sensors(parameters, solution);
    return solution;
}

}  // namespace railpem::pem
