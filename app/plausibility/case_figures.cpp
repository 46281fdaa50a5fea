#include "app/plausibility/case_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plausibility/excited_band.hpp"
#include "app/schema/read_table.hpp"
#include "pem/rail/case_equilibrium.hpp"

namespace railpem::app {

namespace {

/// Springs of one stage under the weight that they carry.
void add_deflections(const pem::CaseParameters& parameters, CaseFigures& figures) {
    const vehicle::VehicleParameters& car = parameters.vehicle;
    const double body = car.body_mass_kg + car.payload_kg, gravity = parameters.track.statics.gravity_m_per_s2;
    figures.secondary_deflection_m = body * gravity / (4.0 * car.secondary.stiffness_n_per_m);
    figures.primary_deflection_m = (body + 2.0 * car.bogie_mass_kg) * gravity / (8.0 * car.primary.stiffness_n_per_m);
}

std::string percent_text(double damping_ratio) {
    return damping_ratio < 5e-4 ? "no damping" : fmt::format("damping {:.2g} %", 100.0 * damping_ratio);
}

CaseFigures figures_of(const pem::CaseParameters& parameters) {
    CaseFigures figures{.wheel_load_n = pem::wheel_load_n(parameters)};
    add_deflections(parameters, figures);
    const track::StaticEquilibrium equilibrium = pem::case_equilibrium(parameters);
    figures.largest_pad_compression_m =
        *std::max_element(equilibrium.compression_m.begin(), equilibrium.compression_m.end());
    figures.warnings = equilibrium.warnings;
    const pem::PreparedCase prepared = pem::prepare_case(parameters, parameters.running.speeds_m_per_s.front());
    figures.resonances = pem::natural_resonances(prepared);
    for (const double speed : parameters.running.speeds_m_per_s) {
        const ExcitedBand band =
            excited_band(parameters, speed, parameters.frequency.from_hz, parameters.frequency.to_hz);
        figures.excited.push_back({speed, band.from_hz, band.to_hz, band.rms_m});
    }
    return figures;
}

}  // namespace

CaseFigures case_figures(const CaseFile& file) {
    try {
        return figures_of(file.parameters);
    } catch (const parameters::ParameterError& error) {
        throw refused(file.document, error);
    }
}

std::string figures_text(const CaseFigures& figures) {
    std::string text = fmt::format(
        "  wheel load {:.1f} kN; springs settle by {:.3g} mm (secondary) and {:.3g} mm (primary), pads by {:.2g} mm\n",
        1e-3 * figures.wheel_load_n, 1e3 * figures.secondary_deflection_m, 1e3 * figures.primary_deflection_m,
        1e3 * figures.largest_pad_compression_m);
    for (const pem::Resonance& resonance : figures.resonances)
        text += fmt::format("  {:<20} {:>7.3g} Hz, {}\n", resonance.name, resonance.frequency_hz,
                            percent_text(resonance.damping_ratio));
    for (const CaseFigures::Excited& excited : figures.excited)
        text += std::isfinite(excited.from_hz)
                    ? fmt::format("  at {:.3g} m/s the irregularity excites {:.3g} to {:.3g} Hz, rms {:.2g} mm\n",
                                  excited.speed_m_per_s, excited.from_hz, excited.to_hz, 1e3 * excited.rms_m)
                    : fmt::format("  at {:.3g} m/s the irregularity excites nothing\n", excited.speed_m_per_s);
    return text;
}

}  // namespace railpem::app
