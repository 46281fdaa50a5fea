#include "pem/lines/resonances.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "pem/angular_frequency.hpp"
#include "pem/coupling/track_response.hpp"
#include "vehicle/natural_frequencies.hpp"

namespace railpem::pem {

namespace {

constexpr double kQuasiStatic_hz = 1.0;       ///< the track is stiff and light: what it gives way by at 1 Hz is static
constexpr double kDeviationsAtHalf = 2.3548;  ///< √(8·ln 2): a Gaussian between its half-power points
/// The wheel on the track resonates at 30 Hz on soft pads and at 100 Hz on ballast (Thompson 2009).
constexpr double kWheelFrom_hz = 10.0, kWheelTo_hz = 500.0;
constexpr int kWheelLines = 400;
constexpr double kNoPeak = 1.05;  ///< of a transmissibility: damped beyond 1/√2 there is no peak above 1

/// |displacement of wheel 1 over the irregularity under it| = |V/(1/K_h + V + R)|, the other wheels at rest.
double transmissibility(const PreparedCase& prepared, CoupledWorkspace& workspace, double frequency_hz) {
    const lanes::Real omega = lanes::broadcast(kTwoPi * frequency_hz);
    const GroupSolution& solved = solve_group(prepared.model, omega, workspace);
    const std::complex<double> wheel = solved.car.wheel(0, 0)[0];
    return std::abs(wheel / (wheel + solved.rail[0][0][0] + prepared.model.contact_compliance[0]));
}

double ground_stiffness(const PreparedCase& prepared, CoupledWorkspace& workspace) {
    const RailGroup rail = rail_group(lanes::broadcast(kTwoPi * kQuasiStatic_hz), workspace);
    return 1.0 / (rail.rail[0][0][0].real() + prepared.model.contact_compliance[0]);
}

/// Twice the frequency of a wheel on its primary spring: below it bogies have a part in what the wheel does.
double above_the_bogies(const vehicle::HalfVehicle& car) {
    double frequency = kWheelFrom_hz;
    for (const vehicle::Element& element : car.elements)
        if (element.carrier == vehicle::Carrier::wheel)
            frequency = std::max(frequency, 2.0 * std::sqrt(car.primary.stiffness_n_per_m / element.mass_kg) / kTwoPi);
    return std::min(frequency, 0.5 * kWheelTo_hz);
}

/// Where the wheel moves most; of one degree of freedom the height of that peak is 1/(2ζ).
std::optional<Resonance> wheel_on_track(const PreparedCase& prepared, CoupledWorkspace& workspace) {
    double highest = 0.0, frequency = 0.0;
    const std::vector<double> lines = geometric_lines(above_the_bogies(prepared.model.car), kWheelTo_hz, kWheelLines);
    for (const double line : lines) {
        const double now = transmissibility(prepared, workspace, line);
        if (now > highest) highest = now, frequency = line;
    }
    if (highest <= kNoPeak || frequency == lines.front()) return std::nullopt;
    const double damping = 0.5 / highest;
    return Resonance{"wheel on the track", frequency, 2.0 * damping * frequency, damping};
}

void sort_by_frequency(std::vector<Resonance>& all) {
    std::stable_sort(all.begin(), all.end(),
                     [](const Resonance& a, const Resonance& b) { return a.frequency_hz < b.frequency_hz; });
}

}  // namespace

std::vector<Resonance> natural_resonances(const PreparedCase& prepared) {
    CoupledWorkspace workspace(prepared.model);
    std::vector<Resonance> all;
    for (const vehicle::NaturalFrequency& natural :
         vehicle::natural_frequencies(prepared.model.car, ground_stiffness(prepared, workspace)))
        if (natural.motion != vehicle::Motion::wheels)
            all.push_back({vehicle::motion_name(natural.motion), natural.frequency_hz,
                           2.0 * natural.damping_ratio * natural.frequency_hz, natural.damping_ratio});
    if (const auto wheel = wheel_on_track(prepared, workspace)) all.push_back(*wheel);
    sort_by_frequency(all);
    return all;
}

std::vector<Resonance> excitation_teeth(const CaseParameters& parameters, const PreparedCase& prepared) {
    std::vector<Resonance> all;
    const auto add = [&](const std::string& name, double frequency, double share) {
        all.push_back({name, frequency, kDeviationsAtHalf * share * frequency, 0.5 * kDeviationsAtHalf * share});
    };
    for (const PreparedSource& own : prepared.sources)
        for (const double tooth : own.teeth_hz)
            add("line of " + own.source.name, tooth, parameters.running.speed_fluctuation);
    for (const spectra::Corrugation& corrugation : parameters.irregularity.corrugation)
        add("corrugation", prepared.speed_m_per_s / corrugation.wavelength_m, corrugation.relative_bandwidth);
    sort_by_frequency(all);
    return all;
}

}  // namespace railpem::pem
