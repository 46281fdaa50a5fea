#include "diagnosis/model/predict_scalars.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/observations/reference_band.hpp"
#include "pem/coupling/excitation.hpp"
#include "pem/coupling/excite.hpp"
#include "pem/coupling/linearise.hpp"
#include "pem/coupling/sensor_chain.hpp"
#include "pem/coupling/track_response.hpp"
#include "pem/response_names.hpp"
#include "spectra/third_octaves.hpp"
#include "vehicle/half_vehicle.hpp"

namespace railpem::diagnosis {

namespace {

using Complex = std::complex<double>;
using recordings::RecordingKind;

constexpr int kLinesPerBand = 9;        ///< of a third-octave of a decay rate
constexpr double kLineReachBins = 4.0;  ///< of the Hann kernel that spreads a line

double wrapped(double phase) {
    return std::remainder(phase, 2.0 * std::numbers::pi);
}

/// PSD of the channels at any frequency.
class ChannelPsd {
  public:
    ChannelPsd(const pem::CaseParameters& parameters, double speed, const Observation& observation,
               const pem::WheelTransfers& transfers)
        : parameters_(parameters),
          speed_(speed),
          observation_(observation),
          transfers_(transfers),
          wheels_(vehicle::wheel_positions(parameters.vehicle)),
          excitation_(pem::excitation(parameters, wheels_, speed)) {}

    double operator()(std::size_t channel, double frequency) const {
        const Complex* at = response_at(channel, frequency);
        double sum = 0.0;
        for (const pem::DelayedSpectrum& source : excitation_.broadband) {
            Complex y = 0.0;
            for (std::size_t j = 0; j < 4; ++j) y += at[j] * pem::delay_phase(wheels_, j, frequency, speed_);
            sum += std::norm(y) * source.psd_m2_per_hz(frequency);
        }
        if (observation_.scalar->resolution_hz > 0.0) sum += lines(channel, frequency);
        const ObservedChannel& own = observation_.channels[channel];
        sum *= std::norm(channel_factor(parameters_, own, frequency));
        for (const pem::SensorParameters& sensor : parameters_.sensors)
            if (sensor.noise_rms_m_per_s2 > 0.0 &&
                pem::measured_response(sensor.channel) == pem::response_names()[own.response].where)
                sum += pem::sensor_noise_psd(sensor, frequency);
        return sum;
    }

  private:
    const Complex* response_at(std::size_t channel, double frequency) const {
        buffer_.resize(transfers_.responses.size() * 4);
        pem::interpolate(transfers_, frequency, buffer_.data());
        return &buffer_[channel * 4];
    }

    double lines(std::size_t channel, double frequency) const {
        const double width = observation_.scalar->resolution_hz;
        double sum = 0.0;
        for (const pem::LineSet& set : excitation_.lines)
            for (const pem::SpectralLine& line : set.lines) {
                const double distance = frequency - line.frequency_hz;
                if (std::abs(distance) > kLineReachBins * width) continue;
                const Complex* at = response_at(channel, line.frequency_hz);
                Complex response = 0.0;
                for (std::size_t j = 0; j < 4; ++j) response += at[j] * line.amplitude_m[j];
                sum += 0.5 * std::norm(response) * hann_kernel(distance / width) / width;
            }
        return sum;
    }

    /// |W|² of a Hann window of unit length over its sum of squares; its area is 1.
    static double hann_kernel(double x) {
        const double near = std::abs(std::abs(x) - 1.0);
        if (near < 1e-6) return 1.0 / 6.0;
        const double sinc = std::abs(x) < 1e-9 ? 1.0 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
        const double amplitude = sinc / (1.0 - x * x);
        return amplitude * amplitude * 2.0 / 3.0;
    }

    const pem::CaseParameters& parameters_;
    double speed_;
    const Observation& observation_;
    const pem::WheelTransfers& transfers_;
    std::vector<double> wheels_;
    pem::Excitation excitation_;
    mutable std::vector<Complex> buffer_;
};

/// Transfers from the wheels to the channels over the band, without sensors.
pem::WheelTransfers transfers_of(const pem::CaseParameters& parameters, double speed, const Observation& observation,
                                 std::vector<pem::RailGroup>& rails) {
    pem::CoupledModel model = pem::coupled_model(parameters, speed);
    if (pem::is_nonlinear(parameters))
        pem::linearise(parameters,
                       pem::excitation_sources(parameters, vehicle::wheel_positions(parameters.vehicle), speed), model);
    std::vector<std::size_t> responses;
    for (const ObservedChannel& channel : observation.channels) responses.push_back(channel.response);
    const double step = observation.expectation.transfer_step_hz;
    const double from = std::max(step, observation.expectation.low_hz - 4.0 * step);
    const std::size_t lines = static_cast<std::size_t>((observation.expectation.high_hz - from) / step) + 6;
    return pem::wheel_transfers(model, from, step, lines, responses, observation.expectation.threads, &rails);
}

std::vector<Complex> channel_levels(pem::CaseParameters parameters, double speed, const Observation& observation,
                                    const ExpectationCache* known, Reuse reuse, ExpectationCache* filled) {
    parameters.sleeper_passing.amplitude_factor = 0.0;
    pem::WheelTransfers own;
    if (reuse < Reuse::transfers) {
        std::vector<pem::RailGroup> rails;
        if (reuse == Reuse::rail || reuse == Reuse::motion) rails = known->rails;
        own = transfers_of(parameters, speed, observation, rails);
        if (filled) *filled = {.rails = std::move(rails), .transfers = own};
    }
    const ChannelPsd psd(parameters, speed, observation, reuse >= Reuse::transfers ? known->transfers : own);
    const std::vector<ScalarValue>& values = observation.scalar->values;
    std::vector<double> powers;
    for (const ScalarValue& value : values) powers.push_back(psd(value.channel, value.frequency_hz));
    const std::vector<double> means = third_octave_means(values, powers);
    std::vector<Complex> levels;
    for (std::size_t i = 0; i < values.size(); ++i)
        levels.emplace_back(std::log(powers[i] + values[i].pedestal_share * means[i]), 0.0);
    return levels;
}

std::vector<Complex> receptance_levels(const pem::CaseParameters& parameters, const ScalarData& data, int threads) {
    std::vector<double> frequencies;
    for (const ScalarValue& value : data.values) frequencies.push_back(value.frequency_hz);
    const pem::TrackResponse response = pem::track_response(parameters, frequencies, false, threads);
    std::vector<Complex> levels;
    for (const Complex value : data.place == recordings::Place::over_pad ? response.over_pad : response.mid_bay)
        levels.emplace_back(std::log(std::abs(value)), data.has_phase ? std::arg(value) : 0.0);
    return levels;
}

std::vector<Complex> decay_levels(const pem::CaseParameters& parameters, const ScalarData& data, int threads) {
    std::vector<double> frequencies, centres;
    for (const ScalarValue& value : data.values) {
        const spectra::ThirdOctaveBand band =
            spectra::third_octave_band(static_cast<int>(std::lround(10.0 * std::log10(value.frequency_hz))));
        centres.push_back(band.centre_hz);
        for (int i = 0; i < kLinesPerBand; ++i)
            frequencies.push_back(band.low_hz * std::pow(band.high_hz / band.low_hz, (i + 0.5) / kLinesPerBand));
    }
    const pem::TrackResponse response = pem::track_response(parameters, frequencies, true, threads);
    std::vector<Complex> levels;
    for (const pem::DecayBand& band : pem::decay_bands(response, centres, parameters.track.spacing_m))
        levels.emplace_back(std::log(band.decay_rate_db_per_m), 0.0);
    const pem::DecayRateReference& reference = parameters.decay_rate_reference;
    for (std::size_t i = 0; i < levels.size(); ++i)
        if (const int band = reference_band(reference, data.values[i].frequency_hz); band >= 0)
            levels[i] += std::log(reference.ratio[static_cast<std::size_t>(band)]);
    return levels;
}

}  // namespace

std::vector<Complex> predict_scalars(const pem::CaseParameters& parameters, double speed,
                                     const Observation& observation, const ExpectationCache* known, Reuse reuse,
                                     ExpectationCache* filled) {
    const ScalarData& data = *observation.scalar;
    const int threads = observation.expectation.threads;
    std::vector<Complex> levels = data.kind == RecordingKind::receptance ? receptance_levels(parameters, data, threads)
                                  : data.kind == RecordingKind::decay_rate
                                      ? decay_levels(parameters, data, threads)
                                      : channel_levels(parameters, speed, observation, known, reuse, filled);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        levels[i] -= data.values[i].log_value;
        levels[i] = {levels[i].real(), data.has_phase ? wrapped(levels[i].imag()) : 0.0};
    }
    return levels;
}

}  // namespace railpem::diagnosis
