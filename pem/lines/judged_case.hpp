#pragma once
// A case solved on the lines that its user asked for, and whether these show what is there.

#include <optional>
#include <string>
#include <vector>

#include "pem/coupling/solution.hpp"
#include "pem/lines/refine_lines.hpp"

namespace railpem::pem {

/// What is known of the lines of a solution.
struct LineJudgement {
    std::vector<Resonance> resonances;  ///< natural_resonances(), also those beyond the band
    /// The narrowest peak of the band, tooth or resonance, that is excited; nothing where there is none.
    std::optional<Resonance> narrowest;
    std::size_t integrated_lines = 0;  ///< over which rms and levels are integrated
    bool converged = true;             ///< rms and levels do not depend on the lines
    double doubtful_hz = 0.0;          ///< where they do
};

/// `solution` has the lines of the table: those of the grid, or, where the case states no step, lines that resolve what
/// is there. Mean squares are integrated over `integrated` where it has lines, else over those of the table.
struct JudgedCase {
    Solution solution;
    std::vector<double> integrated_hz;
    std::vector<std::vector<double>> integrated_psd;  ///< [response of response_names()][line]
    LineJudgement judgement;

    /// Lines and PSD of a response that mean squares are integrated over.
    const std::vector<double>& lines() const { return integrated_hz.empty() ? solution.frequency_hz : integrated_hz; }
    std::vector<double> psd(std::size_t response) const {
        return integrated_hz.empty() ? response_psd(solution, response) : integrated_psd[response];
    }
};

/// Solves the case at one speed and looks at the lines: mean squares are right within 1 % in every third-octave, or the
/// warnings say that they are not. Warnings also name peaks that a stated step does not resolve (less than two steps
/// between the half-power points), and by how much the lines of the table alone would be off. Dry friction and contact
/// are linearised on lines of their own (linearise.hpp). `parameters` must have passed check(). Throws as
/// prepare_case().
JudgedCase solve_judged(const CaseParameters& parameters, double speed_m_per_s, const SolveOptions& options = {});

/// Of what a solution warns, without the notes on the wavelengths that the families of its irregularity were measured
/// for: those are of the case, and the same at every speed.
std::vector<std::string> warnings_beside_validity(const CaseParameters& parameters,
                                                  const std::vector<std::string>& warnings);

}  // namespace railpem::pem
