#pragma once
// What follows from a case before any spectrum: what an engineer would work out to see whether it is right.

#include <string>
#include <vector>

#include "app/schema/case_file.hpp"
#include "pem/lines/resonances.hpp"

namespace railpem::app {

/// Figures of a case at rest, and at each of its speeds.
struct CaseFigures {
    double wheel_load_n = 0.0;
    double secondary_deflection_m = 0.0, primary_deflection_m = 0.0;  ///< under the standing car
    double largest_pad_compression_m = 0.0;                           ///< clips and rail weight included
    std::vector<pem::Resonance> resonances;                           ///< at the first speed
    /// At one speed: from where to where the irregularity excites, within the frequencies of the case.
    struct Excited {
        double speed_m_per_s, from_hz, to_hz, rms_m;
    };
    std::vector<Excited> excited;
    std::vector<std::string> warnings;  ///< of the static equilibrium
};

/// Throws InputError at the value without which there would be a static equilibrium.
CaseFigures case_figures(const CaseFile& file);

/// The same for the eye, several lines, each indented by two blanks.
std::string figures_text(const CaseFigures& figures);

}  // namespace railpem::app
