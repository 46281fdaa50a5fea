#pragma once
// What dry friction adds to the expected spectra beyond its equivalent damping.

#include <vector>

#include "diagnosis/expected_spectra.hpp"
#include "pem/excitation.hpp"

namespace railpem::diagnosis {

bool has_friction(const pem::CaseParameters& parameters);

/// A linearised case and the lines on which it is known.
struct LinearisedCase {
    const pem::CoupledModel& model;
    const std::vector<pem::Source>& sources;
    const std::vector<pem::RailGroup>& level_rails;  ///< pem::linearisation_rails()
    const std::vector<pem::RailGroup>& rails;        ///< at from_hz + i·step_hz
    double from_hz, step_hz;
    std::size_t lines;
};

/// Adds the responses to the forces of friction (pem::friction_distortion), stage by stage. Evaluated in the middle of every bin: their
/// spectra are broad, and so are the modes of a suspension beside a window of seconds.
void add_friction(const pem::CaseParameters& parameters, const LinearisedCase& linearised, const std::vector<ObservedChannel>& channels, double bin_hz,
                  ExpectedSpectra& expected);

}  // namespace railpem::diagnosis
