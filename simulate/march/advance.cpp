#include "simulate/march/world.hpp"

#include <algorithm>
#include <cmath>

#include "simulate/track/footing.hpp"
#include "simulate/track/solve_track.hpp"

namespace railpem::simulate {

namespace {

/// Places and first guess of the loads: forces go on as they went over the last step.
void predict_loads(World& world, const Travel& travel, double time_s) {
    const double h = world.step.step_s;
    for (std::size_t j = 0; j < 4; ++j) {
        const std::array<double, 2> at_s{time_s + RadauStep::first_stage * h, time_s + h};
        const double first = world.junction.force[2 * static_cast<Eigen::Index>(j)];
        const double last = world.junction.force[2 * static_cast<Eigen::Index>(j) + 1];
        const double rise = last - first;  // over two thirds of a step
        for (std::size_t stage = 0; stage < 2; ++stage) {
            const double distance = world.mode == Mode::moving ? travel.distance(at_s[stage]) : 0.0;
            world.loads[j].position_m[stage] = world.wheel_offset_m + distance - world.behind_m[j];
            world.loads[j].force_n[stage] =
                std::max(0.0, last + (stage == 0 ? 0.5 : 1.5) * rise) - world.rail_reference_n;
        }
    }
}

/// What the rail adds to the junction's coupling under each wheel, and the approach that does not depend on the step's
/// forces.
struct UnderWheels {
    std::array<std::array<double, 4>, 4> rail;   ///< per wheel, 2×2 by stages
    std::array<std::array<double, 2>, 4> local;  ///< compliance of the element under its load
    std::array<std::array<double, 2>, 4> height;
};

UnderWheels prepare_contacts(World& world, const Excitation& excitation, const Travel& travel, double time_s) {
    UnderWheels under{};
    const std::array<double, 2> at_s{time_s + RadauStep::first_stage * world.step.step_s, time_s + world.step.step_s};
    world.junction.coupling = world.junction.vehicle_coupling;
    for (std::size_t j = 0; j < 4; ++j) {
        const auto row = 2 * static_cast<Eigen::Index>(j);
        under.rail[j] = world.compliance.at(world.step, world.loads[j].position_m[0]);
        if (world.track.variation.scatter.any())
            for (double& entry : under.rail[j]) entry *= world.compliance_ratio[j];
        for (std::size_t stage = 0; stage < 2; ++stage) {
            under.local[j][stage] = footing(world.track, world.loads[j], stage).local_compliance_m_per_n;
            under.height[j][stage] = excitation.at(j, at_s[stage], travel.distance(at_s[stage]));
            for (std::size_t other = 0; other < 2; ++other)
                world.junction.coupling(row + Eigen::Index(stage), row + Eigen::Index(other)) -=
                    under.rail[j][2 * stage + other];
            world.junction.coupling(row + Eigen::Index(stage), row + Eigen::Index(stage)) -= under.local[j][stage];
        }
        world.irregularity_m[j] = under.height[j][1];
        world.local_compliance[j] = under.local[j][1];
    }
    return under;
}

/// y_free of the contacts for the rail's present solution: what they would see if their forces were nothing.
void set_free_contacts(World& world, const UnderWheels& under, const Junction::Vector& free_vehicle) {
    Junction& junction = world.junction;
    junction.free = free_vehicle;
    const double approach = static_approach(junction.contact);
    for (std::size_t j = 0; j < 4; ++j) {
        const std::array<double, 2> rail = rail_displacement(world.track, world.step, world.loads[j]);
        for (std::size_t stage = 0; stage < 2; ++stage) {
            double back = under.local[j][stage] * world.rail_reference_n;
            for (std::size_t other = 0; other < 2; ++other)
                back += under.rail[j][2 * stage + other] * (world.loads[j].force_n[other] + world.rail_reference_n);
            junction.free[2 * static_cast<Eigen::Index>(j) + static_cast<Eigen::Index>(stage)] +=
                approach + rail[stage] + under.height[j][stage] + back;
        }
        world.rail_displacement_m[j] = rail[1] - under.local[j][1] * world.loads[j].force_n[1];
    }
}

/// Rail and forces under the wheels in one solve of a step.
struct Solve {
    std::array<std::array<double, 2>, 4> rail_m{}, force_n{};
};

Solve last_solve(const World& world) {
    Solve solve;
    for (std::size_t j = 0; j < 4; ++j) {
        solve.rail_m[j] = rail_displacement(world.track, world.step, world.loads[j]);
        solve.force_n[j] = world.loads[j].force_n;
    }
    return solve;
}

/// From two solves of a step: how far the rail gave for the change of the forces, over what was expected (least squares
/// over the stages). A wheel moves by a hundredth of a bay in a step, so the next one finds nearly the same.
void learn_compliance(World& world, const UnderWheels& under, const Solve& before, const Solve& now) {
    for (std::size_t j = 0; j < 4; ++j) {
        double found = 0.0, expected = 0.0;
        for (std::size_t stage = 0; stage < 2; ++stage) {
            double change = 0.0;
            for (std::size_t other = 0; other < 2; ++other)
                change -= under.rail[j][2 * stage + other] * (now.force_n[j][other] - before.force_n[j][other]);
            found += change * (now.rail_m[j][stage] - before.rail_m[j][stage]);
            expected += change * change;
        }
        if (expected > 0.0) world.compliance_ratio[j] *= std::clamp(found / expected, 0.5, 2.0);
    }
}

/// Puts the junction's forces on the rail; returns how far they are from those the rail was solved with.
double update_loads(World& world) {
    double moved = 0.0;
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t stage = 0; stage < 2; ++stage) {
            const double force =
                world.junction.force[2 * static_cast<Eigen::Index>(j) + static_cast<Eigen::Index>(stage)] -
                world.rail_reference_n;
            moved = std::max(moved, std::abs(force - world.loads[j].force_n[stage]));
            world.loads[j].force_n[stage] = force;
        }
    return moved;
}

}  // namespace

int advance(World& world, const Excitation& excitation, const Travel& travel, double time_s) {
    constexpr int most = 40;
    // 0.2 N for 80 kN: the contact then misses its law by 1.3e-10 m, 80 dB below the shortest waves of the
    // irregularity.
    const double tolerance_n = 2.5e-6 * world.junction.contact.static_load_n;
    if (world.mode == Mode::moving)
        while (world.wheel_offset_m + travel.distance(time_s) >=
               static_cast<double>(world.track.first_seat + world.track.wheel_1_bay + 1) * world.track.spacing_m)
            shift(world.track, world.step);
    begin_step(world.track, world.step);
    begin_step(world.vehicle, world.vehicle_numbers, world.step, world.vehicle_state);
    set_free_vehicle(world.junction, world.step, world.vehicle_state);
    const Junction::Vector free_vehicle = world.junction.free;
    predict_loads(world, travel, time_s);
    const UnderWheels under = prepare_contacts(world, excitation, travel, time_s);
    const bool scattered = world.track.variation.scatter.any();
    Solve before;
    int solves = 0;
    while (solves < most) {
        const double pads_moved = solve_track(world.track, world.step, world.loads);
        ++solves;
        if (scattered && solves == 1) before = last_solve(world);
        if (scattered && solves == 2) learn_compliance(world, under, before, last_solve(world));
        set_free_contacts(world, under, free_vehicle);
        solve_junction(world.junction);
        const double loads_moved = update_loads(world);
        if (loads_moved < tolerance_n && pads_moved < tolerance_n) break;
    }
    apply_to_vehicle(world.junction, world.step, world.vehicle_state);
    finish_step(world.vehicle, world.vehicle_numbers, world.step, world.vehicle_state);
    finish_step(world.track, world.step);
    world.solves += solves;
    return solves;
}

}  // namespace railpem::simulate
