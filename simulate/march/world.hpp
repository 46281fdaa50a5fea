#pragma once

#include <array>
#include <vector>

#include "pem/case_parameters.hpp"
#include "simulate/march/excitation.hpp"
#include "simulate/march/options.hpp"
#include "simulate/track/track_window.hpp"
#include "simulate/vehicle/contact_compliance.hpp"
#include "simulate/vehicle/junction.hpp"
#include "simulate/vehicle/vehicle_model.hpp"

namespace railpem::simulate {

/// Vehicle on track, marched in time.
struct World {
    RadauStep step;
    Mode mode;
    TrackWindow track;
    VehicleModel vehicle;
    VehicleStep vehicle_numbers;
    VehicleState vehicle_state;
    Junction junction;
    ContactCompliance compliance;
    std::vector<StageLoad> loads;    ///< of the four wheels on the rail
    std::array<double, 4> behind_m;  ///< of wheel j behind wheel 1
    double wheel_offset_m = 0.0;     ///< of wheel 1 from seat 0 at distance 0
    double rail_reference_n = 0.0;   ///< contact force that the rail's origin already carries

    // Of the last step.
    std::array<double, 4> rail_displacement_m{};
    std::array<double, 4> irregularity_m{};
    std::array<double, 4> local_compliance{};
    int solves = 0;
    /// Seats that scatter: what the rail really gives under each wheel over what the table of equal ones says, as the
    /// last step found it. Part of the Jacobian only.
    std::array<double, 4> compliance_ratio{1.0, 1.0, 1.0, 1.0};
};

/// Sets up the world at rest; the case must have passed check(). `start_distance_m`: where the vehicle stands first.
World make_world(const pem::CaseParameters& parameters, const Options& options, double speed_m_per_s, double step_s,
                 double start_distance_m);

/// One step, from time t to t + step. Returns the number of track solves it took.
int advance(World& world, const Excitation& excitation, const Travel& travel, double time_s);

/// What can be seen at the end of the last step.
Glimpse look(const World& world, double time_s);

/// Deflection under wheel 1 to 4 (downwards positive) of the quasi-static track, at `places` phases of one bay.
std::array<std::vector<double>, 4> quasi_static_deflection(const World& world, int places);

}  // namespace railpem::simulate
