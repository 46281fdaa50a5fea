#include "diagnosis/fit/synthesis.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "diagnosis/fit/fit_settings.hpp"
#include "diagnosis/observations/channel_scales.hpp"
#include "parameters/parameter_error.hpp"
#include "pem/response_names.hpp"
#include "recordings/estimates/averages.hpp"
#include "spectra/complex_normal.hpp"

namespace railpem::diagnosis {

namespace {

/// Averages of a part of `seconds`.
MeasuredSpectra empty_part(double seconds, const ObservationOptions& options, std::size_t bins) {
    const recordings::SegmentOptions segments{.window_s = options.window_s};
    const auto samples = static_cast<std::size_t>(seconds * kFitSettings.drawn_rate_hz);
    const recordings::Segmentation own = recordings::segmentation_of(segments, kFitSettings.drawn_rate_hz, samples);
    if (own.count == 0)
        throw parameters::ParameterError("window_s", "a part of the record is shorter than one window",
                                         "a shorter window or a longer record");
    return {.values = {},
            .log_determinant = std::vector<double>(bins, 0.0),
            .averages = recordings::averages_per_bin(own),
            .seconds = seconds};
}

/// The expectation of a bin, taken apart.
struct BinExpectation {
    Eigen::MatrixXcd excited;
    Eigen::VectorXd noise;
};

/// Cholesky factor of the bin with its power drawn: r eigenvalues above the noise are not r independent samples of one
/// irregularity (whitened_bin.hpp).
Eigen::MatrixXcd factor_of(const BinExpectation& bin, double averages, double standard_normal) {
    Eigen::MatrixXcd model = bin.excited;
    model.diagonal() += bin.noise.cast<std::complex<double>>();
    const Eigen::LLT<Eigen::MatrixXcd> factor(model);
    Eigen::MatrixXcd scale = factor.matrixL().solve(bin.excited);
    scale = factor.matrixL().solve(scale.adjoint().eval());
    const double processes = scale.squaredNorm(),
                 variance = processes > 1.0 ? (processes - 1.0) / (processes * averages) : 0.0;
    model = std::exp(std::sqrt(variance) * standard_normal) * bin.excited;
    model.diagonal() += bin.noise.cast<std::complex<double>>();
    return model.llt().matrixL();
}

/// Draws all bins of a part about their expectations.
void draw(const std::vector<BinExpectation>& expectations, spectra::ComplexNormal& normal, MeasuredSpectra& part) {
    const long freedom = std::max(1L, std::lround(part.averages)), size = expectations.front().excited.rows();
    part.averages = static_cast<double>(freedom);
    part.values.clear();
    Eigen::MatrixXcd white(size, freedom);
    for (const BinExpectation& expectation : expectations) {
        const Eigen::MatrixXcd factor = factor_of(expectation, part.averages, std::numbers::sqrt2 * normal().real());
        for (long i = 0; i < white.size(); ++i) white.data()[i] = normal();
        const Eigen::MatrixXcd vectors = factor.triangularView<Eigen::Lower>() * white;
        const Eigen::MatrixXcd matrix = vectors * vectors.adjoint() / static_cast<double>(freedom);
        part.values.insert(part.values.end(), matrix.data(), matrix.data() + matrix.size());
    }
    set_log_determinants(part, static_cast<std::size_t>(size), part.averages);
}

MeasuredSpectra mean_of(const MeasuredSpectra& first, const MeasuredSpectra& second, std::size_t channels) {
    MeasuredSpectra mean{.values = first.values,
                         .log_determinant = {},
                         .averages = first.averages + second.averages,
                         .seconds = first.seconds + second.seconds};
    const double share = first.averages / mean.averages;
    for (std::size_t i = 0; i < mean.values.size(); ++i)
        mean.values[i] = share * first.values[i] + (1.0 - share) * second.values[i];
    set_log_determinants(mean, channels, mean.averages);
    return mean;
}

}  // namespace

Observation observation_shape(double speed_m_per_s, double payload_kg, double seconds,
                              const std::vector<std::string>& responses, const pem::CaseParameters& believed,
                              const ObservationOptions& options) {
    Observation shape{.name = "synthesised",
                      .speed_m_per_s = speed_m_per_s,
                      .speed_tolerance = kObservationSettings.speed_tolerance,
                      .payload_kg = payload_kg};
    for (const std::string& response : responses) {
        shape.channels.push_back({shape.channels.size(), pem::response_index(response)});
        shape.channel_names.push_back(response);
    }
    shape.unknown_scale.assign(responses.size(), false);
    const double noise = kFitSettings.drawn_noise_rms_m_per_s2, rate = kFitSettings.drawn_rate_hz;
    shape.noise_psd.assign(responses.size(), noise * noise / (0.5 * rate));
    const recordings::SegmentOptions segments{.window_s = options.window_s};
    const recordings::Segmentation cut = recordings::segmentation_of(segments, rate, 0);
    set_band(shape, {cut.window, cut.length, rate}, believed, options);
    const std::size_t bins = band_bins(shape);
    shape.fitted = empty_part(seconds * (1.0 - options.held_out_share), options, bins);
    shape.held_out = empty_part(seconds * options.held_out_share, options, bins);
    shape.all = empty_part(seconds, options, bins);
    return shape;
}

Observation synthesise(const Observation& shape, std::size_t index, const Trial& truth, const BelievedCase& believed,
                       std::uint64_t seed) {
    ExpectedSpectra expected = expected_spectra(case_of(truth, believed, shape), truth.speed_m_per_s[index],
                                                shape.kernel, shape.channels, {}, shape.expectation);
    scale_channels(truth.log_gain[index], expected.values);
    Trial sound = truth;
    std::fill(sound.floor.begin(), sound.floor.end(), 0.0);
    std::vector<BinExpectation> expectations;
    for (std::size_t bin = 0; bin < expected.bins(); ++bin) {
        const Eigen::VectorXd noise = noise_powers(truth, shape, index, bin);
        expectations.push_back({complete_prediction(sound, shape, index, expected, bin), noise});
        expectations.back().excited.diagonal() -= noise.cast<std::complex<double>>();
    }
    Observation drawn = shape;
    spectra::ComplexNormal normal(
        {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32), static_cast<std::uint32_t>(index)});
    draw(expectations, normal, drawn.fitted);
    draw(expectations, normal, drawn.held_out);
    drawn.all = mean_of(drawn.fitted, drawn.held_out, shape.channels.size());
    return drawn;
}

}  // namespace railpem::diagnosis
