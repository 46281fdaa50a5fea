#include "app/verbs/inspection_beliefs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "app/schema/read_table.hpp"
#include "pem/coupling/solution.hpp"
#include "pem/coupling/track_response.hpp"
#include "pem/lines/judged_case.hpp"
#include "pem/response_names.hpp"
#include "spectra/third_octaves.hpp"

namespace railpem::app {

using recordings::ChannelDescription;
using recordings::ChannelQuantity;
using recordings::Location;

namespace {

using Complex = std::complex<double>;

recordings::VehicleGeometry geometry_of(const vehicle::VehicleParameters& vehicle) {
    const double pivot = 0.5 * vehicle.bogie_distance_m, half = 0.5 * vehicle.wheelbase_m;
    return {.wheels_m = {pivot + half, pivot - half, -pivot + half, -pivot - half}, .bogies_m = {pivot, -pivot}};
}

std::string numbered_response(const ChannelDescription& channel) {
    const char* where = channel.location == Location::wheel   ? "wheel"
                        : channel.location == Location::bogie ? "bogie"
                                                              : "rail";
    return fmt::format("{}_{}", where, channel.index);
}

/// Weights of the responses whose sum is the acceleration at the channel; empty: the case cannot predict it.
std::vector<std::pair<std::size_t, double>> weights_of(const ChannelDescription& channel,
                                                       const pem::CaseParameters& parameters) {
    if (channel.location == Location::none) return {};
    if (channel.location != Location::body) return {{pem::response_index(numbered_response(channel)), 1.0}};
    const double share = channel.position_m / (0.5 * parameters.vehicle.bogie_distance_m);
    constexpr double kSamePlace = 1e-3;  // a millimetre and a half at a pivot: nobody places a sensor better
    const bool rigid = parameters.vehicle.body_bending.empty();
    if (!rigid && std::abs(share) > kSamePlace && std::abs(std::abs(share) - 1.0) > kSamePlace) return {};
    const double front = 0.5 * (std::abs(share) + share), rear = 0.5 * (std::abs(share) - share);
    return {{pem::response_index("body"), 1.0 - std::abs(share)},
            {pem::response_index("body_front"), front},
            {pem::response_index("body_rear"), rear}};
}

/// From acceleration to the quantity of the channel, as a factor of the PSD.
double psd_factor(ChannelQuantity quantity, double frequency_hz) {
    const double omega = 2.0 * std::numbers::pi * frequency_hz;
    return quantity == ChannelQuantity::velocity       ? 1.0 / (omega * omega)
           : quantity == ChannelQuantity::displacement ? 1.0 / std::pow(omega, 4)
                                                       : 1.0;
}

std::optional<recordings::PredictedSpectrum> predict(const pem::Solution& solution, const ChannelDescription& channel,
                                                     const pem::CaseParameters& parameters) {
    const auto weights = weights_of(channel, parameters);
    if (weights.empty() || channel.quantity == ChannelQuantity::speed || channel.quantity == ChannelQuantity::mileage)
        return std::nullopt;
    recordings::PredictedSpectrum predicted{.channel = channel.name,
                                            .frequency_hz = solution.frequency_hz,
                                            .psd = std::vector<double>(solution.frequency_hz.size(), 0.0)};
    for (std::size_t source = 0; source < solution.source_names.size(); ++source)
        for (std::size_t line = 0; line < predicted.psd.size(); ++line) {
            Complex sum = 0.0;
            for (const auto& [response, weight] : weights) sum += weight * solution.at(source, response)[line];
            predicted.psd[line] += std::norm(sum) * psd_factor(channel.quantity, predicted.frequency_hz[line]);
        }
    return predicted;
}

/// Receptance where the recording's rail was struck, or decay rates: of the kinds that need no vehicle.
recordings::PredictedTrack predicted_track(const pem::CaseParameters& parameters,
                                           const recordings::RecordingDescription& description) {
    constexpr double kFrom_hz = 20.0, kTo_hz = 6000.0;  // what hammers reach
    constexpr int kLines = 500;                         // twenty in a third-octave: decay_bands() asks for three
    const bool decays = description.kind == recordings::RecordingKind::decay_rate;
    const pem::TrackResponse response =
        pem::track_response(parameters, pem::geometric_lines(kFrom_hz, kTo_hz, kLines), decays);
    recordings::PredictedTrack track;
    track.frequency_hz = response.frequency_hz;
    for (const Complex value : description.place == recordings::Place::over_pad ? response.over_pad : response.mid_bay)
        track.receptance_m_per_n.push_back(std::abs(value));
    if (!decays) return track;
    std::vector<double> centres;
    for (const spectra::ThirdOctaveBand& band : spectra::third_octave_bands(kFrom_hz, kTo_hz))
        centres.push_back(band.centre_hz);
    for (const pem::DecayBand& band : pem::decay_bands(response, centres, parameters.track.spacing_m)) {
        track.centre_hz.push_back(band.centre_hz);
        track.decay_rate_db_per_m.push_back(band.decay_rate_db_per_m);
    }
    return track;
}

bool is_of_track(recordings::RecordingKind kind) {
    return kind == recordings::RecordingKind::receptance || kind == recordings::RecordingKind::decay_rate;
}

}  // namespace

recordings::InspectionContext inspection_beliefs(const CaseFile& believed, const RecordingFile& recording) {
    pem::CaseParameters parameters = believed.parameters;
    if (recording.states("payload_kg")) parameters.vehicle.payload_kg = recording.description.payload_kg;
    const double stated = recording.description.speed_m_per_s;
    recordings::InspectionContext context{.geometry = geometry_of(parameters.vehicle),
                                          .wheel_radius_m = parameters.vehicle.wheel_radius_m,
                                          .sleeper_spacing_m = parameters.track.spacing_m,
                                          .predicted = {},
                                          .track = {}};
    try {
        pem::check(parameters);
        if (is_of_track(recording.description.kind)) {
            context.track = predicted_track(parameters, recording.description);
            return context;
        }
        const pem::Solution solution =
            pem::solve_judged(parameters, stated > 0.0 ? stated : parameters.running.speeds_m_per_s.front()).solution;
        for (const ChannelDescription& channel : recording.description.channels)
            if (auto predicted = predict(solution, channel, parameters))
                context.predicted.push_back(std::move(*predicted));
    } catch (const parameters::ParameterError& error) {
        throw refused(believed.document, error);
    }
    return context;
}

}  // namespace railpem::app
