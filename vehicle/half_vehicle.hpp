#pragma once
// The half vehicle on one rail: masses and inertias halved here, once, and nowhere else.

#include <array>
#include <complex>
#include <vector>

#include "lanes/symmetric_solve.hpp"
#include "vehicle/vehicle_modifiers.hpp"
#include "vehicle/vehicle_parameters.hpp"

namespace railpem::vehicle {

/// Where the vehicle is observed.
enum class Place { body, body_front, body_rear, bogie_1, bogie_2, wheel_1, wheel_2, wheel_3, wheel_4, count };

/// Which law of force an element of the structure obeys.
enum class Law { secondary, primary, inertia, mode, attached };

/// Whose rigid mass an element of Law::inertia carries, and with it whose factor; hung masses belong to none.
enum class Carrier { none, body, bogie, wheel };

/// A degree of freedom and its share in an elongation or a displacement.
struct Share {
    int degree;
    double weight;
};

/// One element: elongation e = Σ weight·q, force = stiffness(ω)·e. For Law::inertia the "stiffness" is
/// −ω²·mass·factor, for Law::attached −ω²·mass·attached[index]; for Law::mode mass·(ω_n² − ω² + 2iζω_nω) when it
/// carries a mass, or its spring part only where `mass_moves` is false.
struct Element {
    std::vector<Share> shares;
    Law law = Law::inertia;
    Carrier carrier = Carrier::none;  ///< inertia
    /// primary, inertia of a wheel: wheel 0…3; secondary, inertia of a bogie: bogie 0…1; attached: its curve
    int index = 0;
    double mass_kg = 0.0;        ///< inertia, attached and mode (kg, or kg·m² for a rotation)
    double frequency_hz = 0.0;   ///< mode
    double damping_ratio = 0.0;  ///< mode
    bool mass_moves = true;  ///< mode: its own mass is on this coordinate (false: a spring and dashpot of that mass)
};

/// Equivalent viscous damping of dry friction, N·s/m, per element; zero without friction.
struct FrictionDamping {
    std::array<double, 4> primary{};
    std::array<double, 2> secondary{};
};

/// The structure: elements over degrees of freedom in the order of elimination; wheels come last.
struct HalfVehicle {
    int degrees = 0;
    std::vector<Element> elements;
    std::array<std::vector<Share>, static_cast<int>(Place::count)> places;
    std::array<std::vector<Share>, 4> primary_elongation;
    std::array<std::vector<Share>, 2> secondary_elongation;
    SuspensionParameters primary, secondary;
    VehicleModifiers modifiers;
    std::vector<lanes::FactorCurve> attached;  ///< the attachments that there are
    FrictionDamping friction;

    int first_wheel() const { return degrees - 4; }
};

/// Builds the half vehicle: 10 degrees of freedom (body heave and pitch, two bogies' heave and pitch, four wheels) plus
/// one for each mode and hung mass. `vehicle` must have passed check().
HalfVehicle half_vehicle(const VehicleParameters& vehicle, const VehicleModifiers& modifiers = {});

/// Dynamic stiffness of a suspension element, N/m: k + c·iω·k_s/(k_s + c·iω) + iω·c_f with c_f the friction's
/// equivalent damping (Maxwell element; Bruni et al. 2011), all of it times `factor`.
lanes::Complex suspension_stiffness(const SuspensionParameters& law, double friction_damping, lanes::Real omega,
                                    const lanes::FactorCurve& factor = {});

/// Receptances of the free half vehicle for unit forces at the wheels (upwards): displacement at every place and
/// elongation of every suspension element.
struct WheelReceptance {
    std::array<std::array<lanes::Complex, 4>, static_cast<int>(Place::count)> at;  ///< [place][wheel], m/N
    std::array<std::array<lanes::Complex, 4>, 4> primary;    ///< elongation of each primary element
    std::array<std::array<lanes::Complex, 4>, 2> secondary;  ///< and of each secondary
    const lanes::Complex& wheel(int observed, int forced) const {
        return at[static_cast<int>(Place::wheel_1) + observed][forced];
    }
};

/// Memory that one thread needs to evaluate a vehicle.
struct Workspace {
    explicit Workspace(const HalfVehicle& car)
        : stiffness(car.degrees), displacement(static_cast<std::size_t>(car.degrees)) {}
    lanes::SymmetricMatrix stiffness;
    std::vector<lanes::Complex> displacement;
};

/// Dynamic stiffness matrix D(ω) of the half vehicle into `workspace.stiffness`, in the order of its degrees of
/// freedom.
void assemble(const HalfVehicle& car, lanes::Real omega, Workspace& workspace);

/// Solves D(ω)·q = e_wheel for the four wheels. ω > 0 in rad/s, one per lane.
WheelReceptance wheel_receptance(const HalfVehicle& car, lanes::Real omega, Workspace& workspace);

/// Displacements at every place for a unit force that elongates one suspension element: upwards on its upper end,
/// downwards on its lower one, m/N, [place]. `workspace` holds D(ω) factorised, as wheel_receptance() leaves it. `law`:
/// primary or secondary.
std::array<lanes::Complex, static_cast<int>(Place::count)> element_receptance(const HalfVehicle& car, Law law,
                                                                              int index, Workspace& workspace);

}  // namespace railpem::vehicle
