#include "diagnosis/friction_spectra.hpp"

#include "pem/friction_distortion.hpp"
#include "pem/linearise.hpp"

namespace railpem::diagnosis {

namespace {

void add_stage(const pem::CaseParameters& parameters, const SolvedLines& solved, const LevelLines& level, vehicle::Law law, double force, const std::vector<ObservedChannel>& channels,
               double bin_hz, ExpectedSpectra& expected) {
    const pem::VelocitySpectra velocity = pem::velocity_spectra(parameters, level.sources, solved.model, law, level.rails);
    std::vector<std::complex<double>> power = pem::friction_distortion(velocity, force);
    for (std::complex<double>& own : power) own *= level.power;
    const long elements = static_cast<long>(velocity.elements);
    const LineTable psd{power.data(), elements, elements, velocity.from_hz, velocity.step_hz, velocity.lines};
    add_inner_forces(parameters, solved, law, [&](double f) { return psd.at(f); }, channels, bin_hz, expected);
}

}  // namespace

bool has_friction(const pem::CaseParameters& parameters) {
    return parameters.vehicle.primary.friction_force_n > 0.0 || parameters.vehicle.secondary.friction_force_n > 0.0;
}

void add_friction(const pem::CaseParameters& parameters, const SolvedLines& solved, const LevelLines& level, const std::vector<ObservedChannel>& channels, double bin_hz,
                  ExpectedSpectra& expected) {
    const vehicle::VehicleParameters& car = parameters.vehicle;
    if (car.primary.friction_force_n > 0.0) add_stage(parameters, solved, level, vehicle::Law::primary, car.primary.friction_force_n, channels, bin_hz, expected);
    if (car.secondary.friction_force_n > 0.0) add_stage(parameters, solved, level, vehicle::Law::secondary, car.secondary.friction_force_n, channels, bin_hz, expected);
}

}  // namespace railpem::diagnosis
