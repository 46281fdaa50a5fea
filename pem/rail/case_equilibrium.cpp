#include "pem/rail/case_equilibrium.hpp"

#include "track/pads/pad_positions.hpp"
#include "track/statics/equilibria_abreast.hpp"

namespace railpem::pem {

std::vector<double> case_pads(const CaseParameters& parameters, const std::vector<double>& wheels) {
    return track::pad_positions(parameters.track, wheels,
                                parameters.solver.rail == RailSolution::modal ? parameters.solver.pads : 0);
}

track::StaticEquilibrium case_equilibrium(const CaseParameters& parameters) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    return track::static_equilibrium(parameters.track, wheels, wheel_load_n(parameters), case_pads(parameters, wheels));
}

track::StaticEquilibrium dynamic_equilibrium(const CaseParameters& parameters, const track::StaticEquilibrium* start) {
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    const std::vector<double> pads = case_pads(parameters, wheels);
    if (parameters.track.pads.preload_strength == 0.0) return track::load_independent_pads(parameters.track, pads);
    return track::static_equilibrium(parameters.track, wheels, wheel_load_n(parameters), pads, start);
}

std::vector<track::StaticEquilibrium> dynamic_equilibria(const CaseParameters& parameters,
                                                         const std::vector<int>& first_seats,
                                                         const std::vector<track::StaticEquilibrium>& start) {
    const bool alike = parameters.track.failed_fasteners.empty() || parameters.track.pads.preload_strength == 0.0;
    if (alike)
        return std::vector(first_seats.size(),
                           dynamic_equilibrium(parameters, start.empty() ? nullptr : &start.front()));
    const std::vector<double> wheels = vehicle::wheel_positions(parameters.vehicle);
    return track::equilibria_abreast(parameters.track, wheels, wheel_load_n(parameters), case_pads(parameters, wheels),
                                     first_seats, start);
}

}  // namespace railpem::pem
