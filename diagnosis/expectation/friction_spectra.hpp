#pragma once
// What dry friction adds to the expected spectra beyond its equivalent damping.

#include <vector>

#include "diagnosis/expectation/inner_forces.hpp"
#include "pem/coupling/excitation.hpp"

namespace railpem::diagnosis {

bool has_friction(const pem::CaseParameters& parameters);

/// The excitation, the rail on the lines on which velocities are asked for, and the power of the forces over that of a
/// constant friction force.
struct LevelLines {
    const std::vector<pem::Source>& sources;
    const std::vector<pem::RailGroup>& rails;  ///< pem::linearisation_rails()
    double power = 1.0;
    const StageFriction* realised = nullptr;  ///< none: velocities are Gaussian
};

/// Adds the responses to the forces of friction (pem::friction_distortion), stage by stage.
void add_friction(const pem::CaseParameters& parameters, const SolvedLines& solved, const LevelLines& level,
                  const std::vector<ObservedChannel>& channels, double bin_hz, ExpectedSpectra& expected);

/// What constant friction does beyond its linearisation, of a solved and linearised case; `level.sources` and
/// `level.rails` as above.
StageFriction realised_friction(const pem::CaseParameters& parameters, const pem::CoupledModel& model,
                                const LevelLines& level);

/// Adds to the transfers from the wheels, on the lines of `solved` and with what their sensors do, what comes of
/// friction's damping beyond its linearisation.
void follow_damping(const pem::CaseParameters& parameters, const SolvedLines& solved, const StageFriction& realised,
                    const std::vector<ObservedChannel>& channels, pem::WheelTransfers& transfers);

}  // namespace railpem::diagnosis
