#include "simulate/vehicle/vehicle_model.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace railpem::simulate {

namespace {

/// Collects degrees of freedom first (mass by mass), then the elements between them.
struct Assembly {
    const vehicle::VehicleParameters& car;
    const OnlyHereParameters& only_here;
    VehicleModel model;
    std::vector<double> masses;
    Eigen::Index body_mode = -1, wheel_mode = -1, neighbour = -1;
    std::array<Eigen::Index, 4> absorber{-1, -1, -1, -1};
    std::vector<std::array<Eigen::Index, 2>> hung;

    Eigen::Index add_mass(double whole) {
        masses.push_back(0.5 * whole);  // half the vehicle on one rail
        return static_cast<Eigen::Index>(masses.size()) - 1;
    }
    Eigen::VectorXd zero() const { return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(masses.size())); }
    Eigen::VectorXd unit(Eigen::Index i) const {
        return Eigen::VectorXd::Unit(static_cast<Eigen::Index>(masses.size()), i);
    }

    Eigen::VectorXd body_at(double x) const {
        Eigen::VectorXd row = zero();
        row[0] = 1.0;
        row[1] = x;
        if (body_mode >= 0) {
            const double relative = x / (0.5 * car.bogie_distance_m);
            row[body_mode] = 1.0 + (car.body_bending.front().shape_at_pivots - 1.0) * relative * relative;
        }
        return row;
    }
    Eigen::VectorXd bogie_at(int bogie, double x) const {
        Eigen::VectorXd row = zero();
        row[2 + 2 * bogie] = 1.0;
        row[3 + 2 * bogie] = x;
        return row;
    }
    Eigen::VectorXd wheel(int j) const {
        Eigen::VectorXd row = unit(6 + j);
        if (wheel_mode >= 0) row[wheel_mode + j] = 1.0;
        return row;
    }
    void spring(const Eigen::VectorXd& direction, double k, double c) {
        model.stiffness += k * direction * direction.transpose();
        model.damping += c * direction * direction.transpose();
    }
    /// Spring and dashpot that give a mass its frequency and damping ratio: of the halved mass at `i`.
    void resonator(const Eigen::VectorXd& direction, Eigen::Index i, double frequency_hz, double damping_ratio) {
        const double omega = 2.0 * std::numbers::pi * frequency_hz;
        const double m = masses[static_cast<std::size_t>(i)];
        spring(direction, m * omega * omega, 2.0 * damping_ratio * m * omega);
    }
};

/// Mass of the body with its payload, which is spread like the body's own, by that without.
double loaded(const vehicle::VehicleParameters& car) {
    return 1.0 + car.payload_kg / car.body_mass_kg;
}

void add_masses(Assembly& a) {
    const vehicle::VehicleParameters& car = a.car;
    a.add_mass(car.body_mass_kg * loaded(car));
    a.add_mass(car.body_pitch_inertia_kg_m2 * loaded(car));
    for (int bogie = 0; bogie < 2; ++bogie) {
        a.add_mass(car.bogie_mass_kg);
        a.add_mass(car.bogie_pitch_inertia_kg_m2);
    }
    for (int j = 0; j < 4; ++j) a.add_mass(car.wheelset_mass_kg);
    if (!car.body_bending.empty()) a.body_mode = a.add_mass(car.body_bending.front().modal_mass_kg * loaded(car));
    if (!car.wheelset_bending.empty())
        for (int j = 0; j < 4; ++j) {
            const Eigen::Index i = a.add_mass(car.wheelset_bending.front().modal_mass_kg);
            if (j == 0) a.wheel_mode = i;
        }
    for (const vehicle::BogieMountedMass& mounted : car.bogie_mounted_masses) {
        const Eigen::Index first = a.add_mass(mounted.mass_kg);
        a.hung.push_back({first, a.add_mass(mounted.mass_kg)});
    }
    const AxleAbsorber& absorber = a.only_here.axle_absorber;
    for (int j = 0; j < 4; ++j)
        if (absorber.mass_kg > 0.0 && (absorber.wheel == 0 || absorber.wheel == j + 1))
            a.absorber[static_cast<std::size_t>(j)] = a.add_mass(absorber.mass_kg);
    if (a.only_here.body_coupling.stiffness_n_per_m > 0.0)
        a.neighbour = a.add_mass(a.only_here.body_coupling.neighbour_mass_kg);
}

void add_suspension(Assembly& a, const Eigen::VectorXd& direction, const vehicle::SuspensionParameters& stage) {
    const double series = stage.damper_series_stiffness_n_per_m;
    const bool is_maxwell = std::isfinite(series) && stage.damping_n_s_per_m > 0.0;
    a.spring(direction, stage.stiffness_n_per_m, is_maxwell ? 0.0 : stage.damping_n_s_per_m);
    if (is_maxwell) a.model.maxwell.push_back({direction, series, stage.damping_n_s_per_m / series});
    if (stage.friction_force_n > 0.0)
        a.model.nonlinear.push_back({.direction = direction, .force_n = stage.friction_force_n});
}

void add_suspensions(Assembly& a) {
    const double pivot = 0.5 * a.car.bogie_distance_m;
    const double axle = 0.5 * a.car.wheelbase_m;
    const GuidanceStickSlip& guidance = a.only_here.guidance_stick_slip;
    const SecondaryBumpStop& stop = a.only_here.secondary_bump_stop;
    for (int bogie = 0; bogie < 2; ++bogie) {
        const Eigen::VectorXd secondary = a.body_at(bogie == 0 ? pivot : -pivot) - a.bogie_at(bogie, 0.0);
        add_suspension(a, secondary, a.car.secondary);
        if (stop.stiffness_n_per_m > 0.0)
            a.model.nonlinear.push_back({.direction = secondary,
                                         .law = NonlinearElement::Law::bump_stop,
                                         .stiffness_n_per_m = stop.stiffness_n_per_m,
                                         .gap_m = stop.gap_m});
        for (int of = 0; of < 2; ++of) {
            const Eigen::VectorXd primary = a.bogie_at(bogie, of == 0 ? axle : -axle) - a.wheel(2 * bogie + of);
            add_suspension(a, primary, a.car.primary);
            if (guidance.force_n > 0.0)
                a.model.nonlinear.push_back({.direction = primary,
                                             .force_n = guidance.force_n,
                                             .static_excess = guidance.static_to_kinetic - 1.0,
                                             .stribeck_velocity_m_per_s = guidance.stribeck_velocity_m_per_s});
        }
    }
}

void add_attachments(Assembly& a) {
    if (a.body_mode >= 0)
        // Bends with the payload, too; as stiff as empty.
        a.resonator(a.unit(a.body_mode), a.body_mode,
                    a.car.body_bending.front().frequency_hz / std::sqrt(loaded(a.car)),
                    a.car.body_bending.front().damping_ratio);
    if (a.wheel_mode >= 0)
        for (int j = 0; j < 4; ++j)
            a.resonator(a.unit(a.wheel_mode + j), a.wheel_mode + j, a.car.wheelset_bending.front().frequency_hz,
                        a.car.wheelset_bending.front().damping_ratio);
    for (std::size_t i = 0; i < a.hung.size(); ++i) {
        const vehicle::BogieMountedMass& mounted = a.car.bogie_mounted_masses[i];
        for (int bogie = 0; bogie < 2; ++bogie) {
            const Eigen::Index at = a.hung[i][static_cast<std::size_t>(bogie)];
            a.resonator(a.unit(at) - a.bogie_at(bogie, mounted.position_m), at, mounted.frequency_hz,
                        mounted.damping_ratio);
        }
    }
    for (int j = 0; j < 4; ++j) {
        const Eigen::Index at = a.absorber[static_cast<std::size_t>(j)];
        if (at >= 0)
            a.resonator(a.unit(at) - a.wheel(j), at, a.only_here.axle_absorber.frequency_hz,
                        a.only_here.axle_absorber.damping_ratio);
    }
    const BogieCoupling& link = a.only_here.bogie_coupling;
    if (link.stiffness_n_per_m > 0.0)
        a.spring(a.bogie_at(0, -link.arm_m) - a.bogie_at(1, link.arm_m), link.stiffness_n_per_m,
                 link.damping_n_s_per_m);
    const BodyCoupling& buffer = a.only_here.body_coupling;
    if (a.neighbour < 0) return;
    a.resonator(a.unit(a.neighbour), a.neighbour, buffer.neighbour_frequency_hz, buffer.neighbour_damping_ratio);
    a.spring(a.body_at(buffer.position_m) - a.unit(a.neighbour), buffer.stiffness_n_per_m, buffer.damping_n_s_per_m);
}

}  // namespace

VehicleModel vehicle_model(const vehicle::VehicleParameters& vehicle, const OnlyHereParameters& only_here) {
    Assembly a{.car = vehicle, .only_here = only_here};
    add_masses(a);
    const auto n = static_cast<Eigen::Index>(a.masses.size());
    a.model.mass = Eigen::Map<const Eigen::VectorXd>(a.masses.data(), n);
    a.model.stiffness = Eigen::MatrixXd::Zero(n, n);
    a.model.damping = Eigen::MatrixXd::Zero(n, n);
    add_suspensions(a);
    add_attachments(a);
    for (int j = 0; j < 4; ++j) a.model.wheel[static_cast<std::size_t>(j)] = a.wheel(j);
    // Channels in the order of channel_names().
    for (int j = 0; j < 4; ++j) a.model.channels.push_back(a.wheel(j));
    for (int bogie = 0; bogie < 2; ++bogie) a.model.channels.push_back(a.bogie_at(bogie, 0.0));
    for (const double x : {0.5, -0.5, 0.0}) a.model.channels.push_back(a.body_at(x * vehicle.bogie_distance_m));
    return a.model;
}

ForceAndSlope force_of(const NonlinearElement& element, double value) {
    if (element.law == NonlinearElement::Law::bump_stop) {
        const double beyond = std::abs(value) - element.gap_m;
        if (beyond <= 0.0) return {0.0, 0.0};
        return {std::copysign(element.stiffness_n_per_m * beyond, value), element.stiffness_n_per_m};
    }
    const double sign = std::tanh(value / friction_velocity_m_per_s);
    const double relative = value / element.stribeck_velocity_m_per_s;
    const double excess = element.static_excess * std::exp(-relative * relative);
    const double level = element.force_n * (1.0 + excess);
    const double slope = level * (1.0 - sign * sign) / friction_velocity_m_per_s -
                         element.force_n * excess * 2.0 * relative / element.stribeck_velocity_m_per_s * sign;
    return {level * sign, slope};
}

VehicleStep vehicle_step(const VehicleModel& model, const RadauStep& step) {
    VehicleStep numbers;
    Eigen::MatrixXcd dynamic = model.stiffness + step.s * model.damping;
    dynamic.diagonal() += step.s * step.s * model.mass;
    for (const MaxwellElement& element : model.maxwell) {
        const Complex st = step.s * element.time_s;
        const Complex kept = st / (1.0 + st);
        dynamic += element.stiffness_n_per_m * kept * element.direction * element.direction.transpose();
        numbers.maxwell_weight.push_back(element.stiffness_n_per_m * kept * step.one);
        numbers.maxwell_old.push_back(kept * step.one);
        numbers.maxwell_new.push_back(1.0 / (1.0 + st));
    }
    numbers.receptance = dynamic.inverse();
    return numbers;
}

VehicleState vehicle_at_rest(const VehicleModel& model) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(model.mass.size());
    return {.displacement = zero,
            .velocity = zero,
            .acceleration = zero,
            .maxwell_m = std::vector<double>(model.maxwell.size(), 0.0),
            .solution = zero.cast<Complex>()};
}

void begin_step(const VehicleModel& model, const VehicleStep& numbers, const RadauStep& step, VehicleState& state) {
    // 1̂·s·(M·(s·u + u̇) + C·u) and the history of the Maxwell elements.
    const Complex scale = product(step.one, step.s);
    const Eigen::VectorXd inertia = model.mass.cwiseProduct(state.displacement);
    const Eigen::VectorXd rest = model.mass.cwiseProduct(state.velocity) + model.damping * state.displacement;
    Eigen::VectorXcd history = (scale * step.s) * inertia + scale * rest;
    for (std::size_t i = 0; i < model.maxwell.size(); ++i)
        history += numbers.maxwell_weight[i] * state.maxwell_m[i] * model.maxwell[i].direction;
    state.solution.noalias() = numbers.receptance * history;
}

void finish_step(const VehicleModel& model, const VehicleStep& numbers, const RadauStep& step, VehicleState& state) {
    for (std::size_t i = 0; i < model.maxwell.size(); ++i) {
        const Complex u = model.maxwell[i].direction.dot(state.solution);
        state.maxwell_m[i] =
            RadauStep::at_end(numbers.maxwell_old[i] * state.maxwell_m[i] + numbers.maxwell_new[i] * u);
    }
    for (Eigen::Index i = 0; i < state.solution.size(); ++i) {
        const Complex velocity = step.derivative(state.solution[i], state.displacement[i]);
        state.acceleration[i] = RadauStep::at_end(step.derivative(velocity, state.velocity[i]));
        state.displacement[i] = RadauStep::at_end(state.solution[i]);
        state.velocity[i] = RadauStep::at_end(velocity);
    }
}

}  // namespace railpem::simulate
