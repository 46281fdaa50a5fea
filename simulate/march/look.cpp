#include "simulate/march/world.hpp"

namespace railpem::simulate {

namespace {

struct Balance {
    double energy = 0.0, dissipation = 0.0;
};

Balance of_vehicle(const World& world) {
    const VehicleState& state = world.vehicle_state;
    const VehicleModel& model = world.vehicle;
    Balance balance;
    balance.energy = 0.5 * state.velocity.dot(model.mass.cwiseProduct(state.velocity)) +
                     0.5 * state.displacement.dot(model.stiffness * state.displacement);
    balance.dissipation = state.velocity.dot(model.damping * state.velocity);
    for (std::size_t i = 0; i < model.maxwell.size(); ++i) {
        const MaxwellElement& element = model.maxwell[i];
        const double stretch = element.direction.dot(state.displacement) - state.maxwell_m[i];
        balance.energy += 0.5 * element.stiffness_n_per_m * stretch * stretch;
        balance.dissipation += element.stiffness_n_per_m * stretch * stretch / element.time_s;
    }
    return balance;
}

Balance of_rail(const TrackWindow& track) {
    Balance balance;
    for (std::size_t k = 0; k < track.nodes(); ++k)
        balance.dissipation += track.absorber_n_s_per_m[k] * track.velocity_w[k] * track.velocity_w[k];
    const std::size_t n = track.nodes();
    for (std::size_t e = 0; e <= n; ++e) {  // element e ends at node e; beyond the last node the rail is clamped
        Eigen::Vector4d u = Eigen::Vector4d::Zero();
        Eigen::Vector4d v = Eigen::Vector4d::Zero();
        if (e > 0) {
            u.head<2>() << track.w[e - 1], track.theta[e - 1];
            v.head<2>() << track.velocity_w[e - 1], track.velocity_theta[e - 1];
        }
        if (e < n) {
            u.tail<2>() << track.w[e], track.theta[e];
            v.tail<2>() << track.velocity_w[e], track.velocity_theta[e];
        }
        balance.energy += 0.5 * (u.dot(track.stiffness * u) + v.dot(track.mass * v));
        balance.dissipation += track.rail_loss_s * v.dot(track.stiffness * v);
    }
    return balance;
}

Balance of_seat(const TrackWindow& track, const Seat& seat, double rail_velocity) {
    Balance balance;
    double foot_velocity = 0.0;
    for (std::size_t r = 0; r < track.law.oscillators.size(); ++r) {
        const Oscillator& o = track.law.oscillators[r];
        const Motion& y = seat.oscillators[r];
        const double scale = seat.oscillator_scale[r];
        balance.energy += 0.5 * o.mass_kg * y.velocity_m_per_s * y.velocity_m_per_s +
                          0.5 * scale * o.stiffness_n_per_m * y.displacement_m * y.displacement_m;
        balance.dissipation += o.damping_n_s_per_m * y.velocity_m_per_s * y.velocity_m_per_s;
        foot_velocity += y.velocity_m_per_s;
    }
    const double elastic = seat.reference_stiffness_n_per_m * seat.compression_m;
    const double relative = foot_velocity - rail_velocity;
    const RelaxationChain& chain = track.law.chain;
    balance.energy += seat.share * 0.5 * chain.equilibrium * elastic * seat.compression_m;
    balance.dissipation += seat.share * seat.dashpot_scale * track.law.dashpot_n_s_per_m * relative * relative;
    for (std::size_t b = 0; b < chain.strength.size(); ++b) {
        const double spring = elastic - seat.branch_force_n[b];  // of a branch of unit strength
        const double power = seat.share * chain.strength[b] * spring * spring / seat.reference_stiffness_n_per_m;
        balance.energy += 0.5 * power;
        balance.dissipation += power / chain.time_s[b];
    }
    return balance;
}

}  // namespace

Glimpse look(const World& world, double time_s) {
    Glimpse glimpse{
        .time_s = time_s, .rail_displacement_m = world.rail_displacement_m, .irregularity_m = world.irregularity_m};
    const Balance vehicle = of_vehicle(world);
    const Balance rail = of_rail(world.track);
    glimpse.energy_j = vehicle.energy + rail.energy;
    glimpse.dissipation_w = vehicle.dissipation + rail.dissipation;
    for (std::size_t i = 0; i < world.track.seats.size(); ++i) {
        const Seat& seat = world.track.seats[i];
        const Balance balance = of_seat(
            world.track, seat, world.track.velocity_w[i * static_cast<std::size_t>(world.track.elements_per_bay)]);
        glimpse.energy_j += balance.energy;
        glimpse.dissipation_w += balance.dissipation;
        glimpse.trackbed_force_n += RadauStep::at_end(seat.force);
    }
    for (std::size_t j = 0; j < 4; ++j) {
        const auto at = 2 * static_cast<Eigen::Index>(j) + 1;
        glimpse.contact_force_n[j] = world.junction.force[at];
        glimpse.approach_m[j] = world.junction.value[at];
        const double change = world.junction.force[at] - world.rail_reference_n;
        glimpse.energy_j +=
            0.5 * change * change * (1.0 / contact_stiffness(world.junction.contact) + world.local_compliance[j]);
    }
    return glimpse;
}

}  // namespace railpem::simulate
