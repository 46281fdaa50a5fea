#include "vehicle/half_vehicle.hpp"

#include <cmath>
#include <numbers>

namespace railpem::vehicle {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Degrees of freedom in the order of elimination: hung masses and modes first, then body, bogies, wheels.
struct Degrees {
    int next = 0;
    std::vector<int> hung;              ///< per bogie and mass
    std::array<int, 4> axle_bending{};  ///< per wheelset
    int body_bending = -1;
    int body_heave, body_pitch;
    std::array<int, 2> bogie_heave, bogie_pitch;
    std::array<int, 4> wheel;
};

Degrees number_degrees(const VehicleParameters& vehicle) {
    Degrees d;
    for (std::size_t i = 0; i < 2 * vehicle.bogie_mounted_masses.size(); ++i) d.hung.push_back(d.next++);
    if (!vehicle.wheelset_bending.empty())
        for (int& degree : d.axle_bending) degree = d.next++;
    if (!vehicle.body_bending.empty()) d.body_bending = d.next++;
    d.body_heave = d.next++;
    d.body_pitch = d.next++;
    for (int bogie = 0; bogie < 2; ++bogie) {
        d.bogie_heave[bogie] = d.next++;
        d.bogie_pitch[bogie] = d.next++;
    }
    for (int& degree : d.wheel) degree = d.next++;
    return d;
}

/// Displacement of the body at x from its centre.
std::vector<Share> body_at(const Degrees& d, double x, double bending_shape) {
    std::vector<Share> shares{{d.body_heave, 1.0}, {d.body_pitch, x}};
    if (d.body_bending >= 0) shares.push_back({d.body_bending, bending_shape});
    return shares;
}

std::vector<Share> minus(std::vector<Share> shares, int degree) {
    shares.push_back({degree, -1.0});
    return shares;
}

void add_body(HalfVehicle& car, const VehicleParameters& vehicle, const Degrees& d) {
    const double loaded = (vehicle.body_mass_kg + vehicle.payload_kg) / vehicle.body_mass_kg;
    car.elements.push_back(
        {.shares = {{d.body_heave, 1.0}}, .carrier = Carrier::body, .mass_kg = loaded * vehicle.body_mass_kg / 2.0});
    car.elements.push_back({.shares = {{d.body_pitch, 1.0}},
                            .carrier = Carrier::body,
                            .mass_kg = loaded * vehicle.body_pitch_inertia_kg_m2 / 2.0});
    const double b = vehicle.bogie_distance_m / 2.0;
    double shape = 0.0;
    for (const BodyBendingMode& mode : vehicle.body_bending) {
        shape = mode.shape_at_pivots;
        car.elements.push_back({.shares = {{d.body_bending, 1.0}},
                                .law = Law::mode,
                                .mass_kg = loaded * mode.modal_mass_kg / 2.0,
                                .frequency_hz = mode.frequency_hz / std::sqrt(loaded),
                                .damping_ratio = mode.damping_ratio});
    }
    car.places[static_cast<int>(Place::body)] = body_at(d, 0.0, 1.0);
    car.places[static_cast<int>(Place::body_front)] = body_at(d, b, shape);
    car.places[static_cast<int>(Place::body_rear)] = body_at(d, -b, shape);
}

void add_bogie(HalfVehicle& car, const VehicleParameters& vehicle, const Degrees& d, int bogie) {
    const int heave = d.bogie_heave[bogie];
    const int pitch = d.bogie_pitch[bogie];
    car.elements.push_back(
        {.shares = {{heave, 1.0}}, .carrier = Carrier::bogie, .index = bogie, .mass_kg = vehicle.bogie_mass_kg / 2.0});
    car.elements.push_back({.shares = {{pitch, 1.0}},
                            .carrier = Carrier::bogie,
                            .index = bogie,
                            .mass_kg = vehicle.bogie_pitch_inertia_kg_m2 / 2.0});
    const Place pivot = bogie == 0 ? Place::body_front : Place::body_rear;
    car.secondary_elongation[bogie] = minus(car.places[static_cast<int>(pivot)], heave);
    car.elements.push_back({.shares = car.secondary_elongation[bogie], .law = Law::secondary, .index = bogie});
    car.places[static_cast<int>(bogie == 0 ? Place::bogie_1 : Place::bogie_2)] = {{heave, 1.0}};
    for (std::size_t i = 0; i < vehicle.bogie_mounted_masses.size(); ++i) {
        const BogieMountedMass& hung = vehicle.bogie_mounted_masses[i];
        const int degree = d.hung[2 * i + static_cast<std::size_t>(bogie)];
        car.elements.push_back({.shares = {{degree, 1.0}}, .mass_kg = hung.mass_kg / 2.0});
        car.elements.push_back({.shares = {{heave, 1.0}, {pitch, hung.position_m}, {degree, -1.0}},
                                .law = Law::mode,
                                .mass_kg = hung.mass_kg / 2.0,
                                .frequency_hz = hung.frequency_hz,
                                .damping_ratio = hung.damping_ratio,
                                .mass_moves = false});
    }
}

void add_wheel(HalfVehicle& car, const VehicleParameters& vehicle, const Degrees& d, int wheel) {
    const int bogie = wheel / 2;
    const double arm = (wheel % 2 == 0 ? 0.5 : -0.5) * vehicle.wheelbase_m;
    const int degree = d.wheel[wheel];
    car.primary_elongation[wheel] = {{d.bogie_heave[bogie], 1.0}, {d.bogie_pitch[bogie], arm}, {degree, -1.0}};
    car.elements.push_back({.shares = car.primary_elongation[wheel], .law = Law::primary, .index = wheel});
    // The degree of freedom is the wheel's total displacement; with bending the rigid part is total − q.
    std::vector<Share> rigid{{degree, 1.0}};
    for (const WheelsetBendingMode& mode : vehicle.wheelset_bending) {
        rigid.push_back({d.axle_bending[wheel], -1.0});
        car.elements.push_back({.shares = {{d.axle_bending[wheel], 1.0}},
                                .law = Law::mode,
                                .mass_kg = mode.modal_mass_kg / 2.0,
                                .frequency_hz = mode.frequency_hz,
                                .damping_ratio = mode.damping_ratio});
    }
    car.elements.push_back({.shares = std::move(rigid),
                            .carrier = Carrier::wheel,
                            .index = wheel,
                            .mass_kg = vehicle.wheelset_mass_kg / 2.0});
    car.places[static_cast<int>(Place::wheel_1) + wheel] = {{degree, 1.0}};
}

/// Elements of what is attached to two motions of a body: heave, and pitch with this radius of gyration.
void attach(HalfVehicle& car, const Attachments& attachments, double mass_kg, double radius_m,
            const std::vector<Share>& heave, const std::vector<Share>& pitch) {
    const auto add = [&](const lanes::FactorCurve& curve, double arm) {
        if (curve.empty()) return;
        std::vector<Share> shares = heave;
        if (arm != 0.0)
            for (const Share& share : pitch) shares.push_back({share.degree, arm * share.weight});
        car.elements.push_back({.shares = std::move(shares),
                                .law = Law::attached,
                                .index = static_cast<int>(car.attached.size()),
                                .mass_kg = mass_kg});
        car.attached.push_back(curve);
    };
    add(attachments.centre, 0.0);
    add(attachments.front, radius_m);
    add(attachments.rear, -radius_m);
}

void add_attachments(HalfVehicle& car, const VehicleParameters& vehicle, const VehicleModifiers& modifiers,
                     const Degrees& d) {
    const double body_radius = std::sqrt(vehicle.body_pitch_inertia_kg_m2 / vehicle.body_mass_kg);
    attach(car, modifiers.body_attachments, (vehicle.body_mass_kg + vehicle.payload_kg) / 2.0, body_radius,
           {{d.body_heave, 1.0}}, {{d.body_pitch, 1.0}});
    const double mass = vehicle.bogie_mass_kg / 2.0,
                 radius = std::sqrt(vehicle.bogie_pitch_inertia_kg_m2 / vehicle.bogie_mass_kg);
    attach(car, modifiers.between_bogies, mass, radius, {{d.bogie_heave[0], 1.0}, {d.bogie_heave[1], -1.0}},
           {{d.bogie_pitch[0], 1.0}, {d.bogie_pitch[1], 1.0}});
}

/// −ω²·mass, with the factors of whatever carries it.
lanes::Complex inertia_of(const HalfVehicle& car, const Element& element, lanes::Real omega) {
    const lanes::Complex inertia{-element.mass_kg * omega * omega, lanes::Real{}};
    const VehicleModifiers& modifiers = car.modifiers;
    const auto corrected = [&](const lanes::Complex& own, const lanes::FactorCurve& factor) {
        return factor.empty() ? own : own * factor.at(omega);
    };
    switch (element.carrier) {
        case Carrier::body:
            return corrected(inertia, modifiers.body);
        case Carrier::bogie:
            return corrected(corrected(inertia, modifiers.bogies),
                             modifiers.one_bogie[static_cast<std::size_t>(element.index)]);
        case Carrier::wheel:
            return corrected(corrected(inertia, modifiers.wheelsets),
                             modifiers.one_wheelset[static_cast<std::size_t>(element.index)]);
        case Carrier::none:
            break;
    }
    return inertia;
}

lanes::Complex stiffness_of(const HalfVehicle& car, const Element& element, lanes::Real omega) {
    switch (element.law) {
        case Law::secondary:
            return suspension_stiffness(car.secondary, car.friction.secondary[element.index], omega,
                                        car.modifiers.secondary);
        case Law::primary:
            return suspension_stiffness(car.primary, car.friction.primary[element.index], omega, car.modifiers.primary);
        case Law::inertia:
            return inertia_of(car, element, omega);
        case Law::attached:
            return car.attached[static_cast<std::size_t>(element.index)].at(omega) * (-element.mass_kg * omega * omega);
        case Law::mode:
            break;
    }
    const double natural = kTwoPi * element.frequency_hz;
    lanes::Complex result{lanes::broadcast(element.mass_kg * natural * natural),
                          2.0 * element.damping_ratio * natural * element.mass_kg * omega};
    if (element.mass_moves) result.re -= element.mass_kg * omega * omega;
    return result;
}

}  // namespace

HalfVehicle half_vehicle(const VehicleParameters& vehicle, const VehicleModifiers& modifiers) {
    const Degrees d = number_degrees(vehicle);
    HalfVehicle car;
    car.degrees = d.next;
    car.primary = vehicle.primary;
    car.secondary = vehicle.secondary;
    car.modifiers = modifiers;
    add_body(car, vehicle, d);
    for (int bogie = 0; bogie < 2; ++bogie) add_bogie(car, vehicle, d, bogie);
    for (int wheel = 0; wheel < 4; ++wheel) add_wheel(car, vehicle, d, wheel);
    add_attachments(car, vehicle, modifiers, d);
    return car;
}

lanes::Complex suspension_stiffness(const SuspensionParameters& law, double friction_damping, lanes::Real omega,
                                    const lanes::FactorCurve& factor) {
    lanes::Complex damper{lanes::Real{}, law.damping_n_s_per_m * omega};
    if (std::isfinite(law.damper_series_stiffness_n_per_m)) {
        const lanes::Complex series(law.damper_series_stiffness_n_per_m);
        damper = damper * series / (damper + series);
    }
    damper.re += law.stiffness_n_per_m;
    damper.im += friction_damping * omega;
    return factor.empty() ? damper : damper * factor.at(omega);
}

void assemble(const HalfVehicle& car, lanes::Real omega, Workspace& workspace) {
    lanes::SymmetricMatrix& matrix = workspace.stiffness;
    matrix.clear();
    for (const Element& element : car.elements) {
        const lanes::Complex stiffness = stiffness_of(car, element, omega);
        for (const Share& row : element.shares)
            for (const Share& column : element.shares)
                if (row.degree >= column.degree)
                    matrix(row.degree, column.degree) += stiffness * (row.weight * column.weight);
    }
}

namespace {

lanes::Complex displacement_at(const std::vector<Share>& shares, const std::vector<lanes::Complex>& q) {
    lanes::Complex displacement;
    for (const Share& share : shares) displacement += q[static_cast<std::size_t>(share.degree)] * share.weight;
    return displacement;
}

}  // namespace

WheelReceptance wheel_receptance(const HalfVehicle& car, lanes::Real omega, Workspace& workspace) {
    assemble(car, omega, workspace);
    workspace.stiffness.factorise();
    WheelReceptance result;
    std::vector<lanes::Complex>& q = workspace.displacement;
    for (int wheel = 0; wheel < 4; ++wheel) {
        for (lanes::Complex& value : q) value = lanes::Complex{};
        const int degree = car.first_wheel() + wheel;
        q[static_cast<std::size_t>(degree)] = lanes::Complex(1.0);
        workspace.stiffness.solve(q.data(), degree);
        const std::size_t w = static_cast<std::size_t>(wheel);
        for (std::size_t place = 0; place < car.places.size(); ++place)
            result.at[place][w] = displacement_at(car.places[place], q);
        for (std::size_t e = 0; e < 4; ++e) result.primary[e][w] = displacement_at(car.primary_elongation[e], q);
        for (std::size_t e = 0; e < 2; ++e) result.secondary[e][w] = displacement_at(car.secondary_elongation[e], q);
    }
    return result;
}

std::array<lanes::Complex, static_cast<int>(Place::count)> element_receptance(const HalfVehicle& car, Law law,
                                                                              int index, Workspace& workspace) {
    std::vector<lanes::Complex>& q = workspace.displacement;
    for (lanes::Complex& value : q) value = lanes::Complex{};
    const std::size_t own = static_cast<std::size_t>(index);
    for (const Share& share : law == Law::primary ? car.primary_elongation[own] : car.secondary_elongation[own])
        q[static_cast<std::size_t>(share.degree)] += lanes::Complex(share.weight);
    workspace.stiffness.solve(q.data());
    std::array<lanes::Complex, static_cast<int>(Place::count)> result;
    for (std::size_t place = 0; place < car.places.size(); ++place)
        result[place] = displacement_at(car.places[place], q);
    return result;
}

}  // namespace railpem::vehicle
