#include "pem/lines/judged_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "spectra/integrate_psd.hpp"
#include "spectra/validity.hpp"

namespace railpem::pem {

namespace {

constexpr double kStepsPerPeak = 2.0;  ///< between half-power points: the highest line is then within 20 % of the peak
constexpr double kNoteworthy = 0.02;   ///< of an rms: what two steps may differ by
constexpr double kNarrowestWidth = 2e-5;  ///< width over frequency that refine_lines() still resolves

/// The narrowest peak between these lines.
std::optional<Resonance> narrowest_peak(const LineJudgement& judgement, const std::vector<Resonance>& teeth,
                                        const std::vector<double>& lines) {
    std::optional<Resonance> narrowest;
    for (const auto* list : {&judgement.resonances, &teeth})
        for (const Resonance& peak : *list)
            if (peak.frequency_hz >= lines.front() && peak.frequency_hz <= lines.back() &&
                (!narrowest || peak.width_hz < narrowest->width_hz))
                narrowest = peak;
    return narrowest;
}

struct LargestError {
    std::size_t response = 0;
    double relative = 0.0, table = 0.0, integrated = 0.0;
};

/// The response whose rms the lines of the table alone would miss by most.
LargestError largest_error(const JudgedCase& judged) {
    LargestError largest;
    if (judged.integrated_hz.empty()) return largest;
    for (std::size_t response = 0; response < response_names().size(); ++response) {
        const double table =
            spectra::root_mean_square(judged.solution.frequency_hz, response_psd(judged.solution, response));
        const double integrated = spectra::root_mean_square(judged.integrated_hz, judged.integrated_psd[response]);
        const double relative = integrated > 0.0 ? std::abs(table / integrated - 1.0) : 0.0;
        if (relative > largest.relative) largest = {response, relative, table, integrated};
    }
    return largest;
}

std::string not_converged_text(const JudgedCase& judged) {
    const double f = judged.judgement.doubtful_hz;
    std::string text = fmt::format(
        "rms and third-octave levels are not converged: at {:.4g} Hz a peak is narrower than any line distance that "
        "was "
        "tried, as without damping; they depend on the frequency step",
        f);
    std::set<std::string> named;
    for (const Resonance& natural : judged.judgement.resonances)
        if (natural.width_hz < kNarrowestWidth * natural.frequency_hz && named.insert(natural.name).second)
            text += fmt::format("; {} at {:.3g} Hz has {} damping", natural.name, natural.frequency_hz,
                                natural.damping_ratio == 0.0 ? "no" : "next to no");
    return text;
}

void warn_of_lines(const FrequencyParameters& grid, JudgedCase& judged) {
    std::vector<std::string>& warnings = judged.solution.warnings;
    const LineJudgement& judgement = judged.judgement;
    if (!judgement.converged) warnings.push_back(not_converged_text(judged));
    if (grid.step_hz == 0.0) return;
    const bool peak_hidden = judgement.narrowest && judgement.narrowest->width_hz < kStepsPerPeak * grid.step_hz;
    const LargestError error = largest_error(judged);
    const bool rms_hidden = error.relative > kNoteworthy;
    if (!peak_hidden && !rms_hidden) return;
    std::string text = fmt::format("lines {:g} Hz apart", grid.step_hz);
    if (peak_hidden)
        text +=
            fmt::format(" do not resolve the peak of '{}' at {:.4g} Hz, {:.2g} Hz wide between its half-power points",
                        judgement.narrowest->name, judgement.narrowest->frequency_hz, judgement.narrowest->width_hz);
    else
        text += " are too far apart";
    text += ": peaks in the table depend on where the lines fall";
    if (!judged.integrated_hz.empty())
        text += fmt::format("; rms and levels are integrated over {} lines", judged.integrated_hz.size());
    if (rms_hidden)
        text += fmt::format(" (from the lines of the table alone the rms of {} would be {:.3g} instead of {:.3g})",
                            response_names()[error.response].where, error.table, error.integrated);
    warnings.push_back(text + "; without frequency.step_hz the program chooses lines that resolve it");
}

/// On lines of the program's own choice.
void solve_without_step(const CaseParameters& parameters, const PreparedCase& prepared, const SolveOptions& options,
                        JudgedCase& judged) {
    const Solution coarse =
        solve_lines(parameters, prepared, with_bins(frequency_lines(parameters.frequency)), options);
    RefinedSpectra refined = refine_lines(parameters, prepared, coarse, options);
    judged.judgement.converged = refined.converged;
    judged.judgement.doubtful_hz = refined.doubtful_hz;
    judged.solution = solve_lines(parameters, prepared, with_bins(std::move(refined.frequency_hz)), options);
}

}  // namespace

std::vector<std::string> warnings_beside_validity(const CaseParameters& parameters,
                                                  const std::vector<std::string>& warnings) {
    const std::vector<std::string> validity = spectra::validity_warnings(parameters.irregularity);
    std::vector<std::string> others;
    for (const std::string& warning : warnings)
        if (std::find(validity.begin(), validity.end(), warning) == validity.end()) others.push_back(warning);
    return others;
}

JudgedCase solve_judged(const CaseParameters& parameters, double speed_m_per_s, const SolveOptions& options) {
    const PreparedCase prepared = prepare_case(parameters, speed_m_per_s);
    JudgedCase judged;
    judged.judgement.resonances = natural_resonances(prepared);
    if (parameters.frequency.step_hz == 0.0) {
        solve_without_step(parameters, prepared, options, judged);
    } else {
        judged.solution = solve_lines(parameters, prepared, with_bins(frequency_lines(parameters.frequency)), options);
        RefinedSpectra refined = refine_lines(parameters, prepared, judged.solution, options);
        judged.judgement.converged = refined.converged;
        judged.judgement.doubtful_hz = refined.doubtful_hz;
        // What has no limit is left as the table has it.
        if (refined.converged && refined.frequency_hz.size() > judged.solution.frequency_hz.size()) {
            judged.integrated_hz = std::move(refined.frequency_hz);
            judged.integrated_psd = std::move(refined.psd);
        }
    }
    judged.judgement.narrowest =
        narrowest_peak(judged.judgement, excitation_teeth(parameters, prepared), judged.solution.frequency_hz);
    judged.judgement.integrated_lines = judged.lines().size();
    warn_of_lines(parameters.frequency, judged);
    return judged;
}

}  // namespace railpem::pem
