#include "pem/coupling/excite.hpp"

#include <algorithm>
#include <cmath>

#include "pem/angular_frequency.hpp"
#include "pem/contact.hpp"
#include "pem/coupling/passing_feedback.hpp"
#include "pem/coupling/passing_lines.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "spectra/rail_joint_lines.hpp"

namespace railpem::pem {

namespace {

DelayedSpectrum irregularity_spectrum(const CaseParameters& parameters, double speed) {
    return {"irregularity",
            [irregularity = parameters.irregularity, patch = parameters.contact.patch_half_length_m, speed](double f) {
                const double filter = contact_filter(patch, kTwoPi * f / speed);
                return filter * filter * spectra::irregularity_psd_m2_per_hz(irregularity, f, speed);
            }};
}

/// Lines of dips at a regular distance, up to the end of the frequency grid.
std::vector<SpectralLine> joint_lines(const CaseParameters& parameters, const spectra::RailJoints& joints,
                                      const std::vector<double>& wheels_m, double speed) {
    std::vector<SpectralLine> lines;
    for (int order = 1; order * speed / joints.spacing_m <= parameters.frequency.to_hz; ++order) {
        SpectralLine line{.frequency_hz = order * speed / joints.spacing_m};
        const double wavenumber = kTwoPi * order / joints.spacing_m;
        const double amplitude = spectra::joint_line_amplitude_m(joints, order) *
                                 contact_filter(parameters.contact.patch_half_length_m, wavenumber);
        for (std::size_t j = 0; j < 4; ++j)
            line.amplitude_m[j] = amplitude * std::polar(1.0, -wavenumber * (wheels_m[0] - wheels_m[j]));
        lines.push_back(line);
    }
    return lines;
}

void add_wheel_lines(const CaseParameters& parameters, double speed, std::vector<LineSet>& sets) {
    for (int wheel = 1; wheel <= 4; ++wheel) {
        std::vector<SpectralLine> lines;
        for (const WheelOutOfRoundness& defect : parameters.wheel_out_of_roundness) {
            if (defect.wheel != wheel) continue;
            const double wavenumber = defect.order / parameters.vehicle.wheel_radius_m;
            SpectralLine line{.frequency_hz = speed * wavenumber / kTwoPi};
            line.amplitude_m[static_cast<std::size_t>(wheel - 1)] =
                defect.amplitude_m * contact_filter(parameters.contact.patch_half_length_m, wavenumber);
            lines.push_back(line);
        }
        if (!lines.empty()) sets.push_back({"wheel_" + std::to_string(wheel), std::move(lines)});
    }
}

}  // namespace

TrackExcitation track_excitation(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                 double speed_m_per_s, const CoupledModel* model, bool fed_back) {
    TrackExcitation track{.deflection = passing_lines(parameters, wheels_m, speed_m_per_s,
                                                      model ? model->rail->constant_loads() : nullptr),
                          .passing = {},
                          .failed = failed_fastener_amplitudes(parameters, wheels_m, speed_m_per_s),
                          .wheel_load_n = wheel_load_n(parameters),
                          .amplitude_factor = own_passing(parameters)};
    track.passing = track.deflection;
    if (excess_passing(parameters) > 0.0) track.excess = unit_excess_lines(parameters, wheels_m, speed_m_per_s);
    if (model && fed_back && parameters.track.failed_fasteners.empty())
        for (auto* lines : {&track.passing, &track.excess}) feed_back(parameters, *model, speed_m_per_s, *lines);
    return track;
}

TrackExcitation with_other_vehicle(const TrackExcitation& known, const CaseParameters& parameters,
                                   const CoupledModel& model, double speed_m_per_s, bool fed_back) {
    TrackExcitation own = rescaled(known, parameters);
    own.passing = own.deflection;
    if (excess_passing(parameters) > 0.0) own.excess = unit_excess_lines(parameters, model.wheels_m, speed_m_per_s);
    if (fed_back && parameters.track.failed_fasteners.empty())
        for (auto* lines : {&own.passing, &own.excess}) feed_back(parameters, model, speed_m_per_s, *lines);
    return own;
}

TrackExcitation rescaled(const TrackExcitation& known, const CaseParameters& parameters) {
    TrackExcitation own = known;
    own.wheel_load_n = wheel_load_n(parameters);
    own.amplitude_factor = own_passing(parameters);
    const double load = own.wheel_load_n / known.wheel_load_n;
    const auto& failed = parameters.track.failed_fasteners;
    const std::size_t period = failed.empty() ? 1 : static_cast<std::size_t>(std::max(1, failed.front().every));
    for (std::size_t i = 0; i < own.passing.size(); ++i) {
        const bool whole_bay = (i + 1) % period == 0;
        const double scale =
            load * (whole_bay && known.amplitude_factor != 0.0 ? own.amplitude_factor / known.amplitude_factor : 1.0);
        for (auto* lines : {&own.passing, &own.deflection})
            for (auto& amplitude : (*lines)[i].amplitude_m) amplitude *= scale;
    }
    for (SpectralLine& line : own.excess)
        for (auto& amplitude : line.amplitude_m) amplitude *= load;
    if (known.failed)
        own.failed = [amplitudes = known.failed, load](double f) {
            std::array<std::complex<double>, 4> own_amplitudes = amplitudes(f);
            for (std::complex<double>& amplitude : own_amplitudes) amplitude *= load;
            return own_amplitudes;
        };
    return own;
}

namespace {

/// The lines of a case's passing supports with what is in excess of them, in phase.
std::vector<SpectralLine> all_passing(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                      double speed_m_per_s, const TrackExcitation& track) {
    std::vector<SpectralLine> lines = track.passing;
    const double excess = excess_passing(parameters);
    if (excess <= 0.0) return lines;
    const std::vector<SpectralLine> more =
        track.excess.empty() ? unit_excess_lines(parameters, wheels_m, speed_m_per_s) : track.excess;
    for (std::size_t i = 0; i < std::min(lines.size(), more.size()); ++i)
        for (std::size_t j = 0; j < 4; ++j) lines[i].amplitude_m[j] += excess * more[i].amplitude_m[j];
    return lines;
}

}  // namespace

Excitation excitation(const CaseParameters& parameters, const std::vector<double>& wheels_m, double speed_m_per_s,
                      const TrackExcitation* known, const CoupledModel* model) {
    const bool usable = known && (known->amplitude_factor != 0.0 || parameters.sleeper_passing.amplitude_factor == 0.0);
    TrackExcitation track =
        usable ? rescaled(*known, parameters) : track_excitation(parameters, wheels_m, speed_m_per_s, model);
    Excitation all;
    all.broadband.push_back(irregularity_spectrum(parameters, speed_m_per_s));
    if (track.failed)
        all.broadband.push_back({.name = "failed_fasteners",
                                 .psd_m2_per_hz = [failed = track.failed](double f) { return std::norm(failed(f)[0]); },
                                 .under_wheels = track.failed});
    for (const spectra::RailJoints& joints : parameters.irregularity.joints)
        all.lines.push_back({"joints", joint_lines(parameters, joints, wheels_m, speed_m_per_s)});
    add_wheel_lines(parameters, speed_m_per_s, all.lines);
    if (!track.passing.empty())
        all.lines.push_back({"sleeper_passing", all_passing(parameters, wheels_m, speed_m_per_s, track)});
    return all;
}

std::vector<Source> excitation_sources(const CaseParameters& parameters, const std::vector<double>& wheels_m,
                                       double speed_m_per_s, const CoupledModel* model) {
    Excitation all = excitation(parameters, wheels_m, speed_m_per_s, nullptr, model);
    std::vector<Source> sources;
    for (DelayedSpectrum& spectrum : all.broadband)
        sources.push_back(delayed_source(std::move(spectrum), wheels_m, speed_m_per_s));
    for (LineSet& set : all.lines)
        sources.push_back(line_source(set.name, std::move(set.lines), parameters.running.speed_fluctuation));
    return sources;
}

}  // namespace railpem::pem
