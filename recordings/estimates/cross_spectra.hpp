#pragma once

#include <Eigen/Core>
#include <complex>
#include <string>
#include <vector>

#include "recordings/estimates/averages.hpp"
#include "recordings/recording.hpp"

namespace railpem::recordings {

/// How segments are cut and weighted. No mean or trend is taken from single segments, so that the window's kernel is
/// exact.
struct SegmentOptions {
    Window window = Window::hann;
    double window_s = 2.0;     ///< the next length without a prime factor above 5 is used
    double overlap = 0.5;      ///< share of a segment that the next one repeats, 0 … 0.9
    bool remove_trend = true;  ///< mean and linear trend of the whole record
    double from_s = 0.0;       ///< part of the record to use, from its first sample
    double to_s = 1e300;
};

/// Averaged cross-spectral matrices of all vibration channels: S_ij(f) = 2/(f_s Σw² K) Σ_k X_i X_j*, one-sided,
/// unit_i·unit_j/Hz. With e^{+iωt}, channel i later than j by τ has the phase −ωτ.
struct CrossSpectra {
    std::vector<double> frequency_hz;  ///< bins 0 … f_s/2
    std::vector<ChannelDescription> channels;
    std::vector<std::complex<double>> matrices;  ///< [bin][column][row]: one Hermitian matrix after the other
    Segmentation segments;                       ///< window, length, hop; count is the number of segments used
    double sampling_rate_hz = 0.0;
    std::size_t segments_skipped = 0;  ///< because a sample was missing
    double averages = 0.0;             ///< independent averages of one bin
    double averages_per_bin = 0.0;     ///< the same when all bins are used together (averages.hpp)

    std::size_t bins() const { return frequency_hz.size(); }
    std::size_t size() const { return channels.size(); }
    WindowKernel kernel() const { return {segments.window, segments.length, sampling_rate_hz}; }
    Eigen::Map<const Eigen::MatrixXcd> matrix(std::size_t bin) const {
        const auto n = static_cast<Eigen::Index>(size());
        return {matrices.data() + bin * size() * size(), n, n};
    }
    std::complex<double> at(std::size_t bin, std::size_t row, std::size_t column) const {
        return matrices[(bin * size() + column) * size() + row];
    }
    double psd(std::size_t bin, std::size_t channel) const { return at(bin, channel, channel).real(); }
    /// γ² = |S_ij|²/(S_ii S_jj); 0 where a channel has no power.
    double coherence(std::size_t bin, std::size_t i, std::size_t j) const;
};

/// Estimates the cross-spectra of a time series. Segments with a missing sample in any channel are left out and
/// counted. Throws parameters::ParameterError when the record is shorter than one segment.
CrossSpectra estimate_cross_spectra(const TimeSeries& series, const SegmentOptions& options = {});

/// Estimates of parts of a record, or of several records, as one: weighted with their segments. Asserts that channels,
/// window and sampling rate agree.
CrossSpectra merged(const std::vector<CrossSpectra>& parts);

/// Velocity and displacement channels turned into accelerations, each by iω per derivative. Leakage of the original
/// quantity stays in the estimate: for a comparison with a model, smooth the model in the measured quantity and convert
/// after.
CrossSpectra to_acceleration(const CrossSpectra& spectra);

/// Segments of `options` in samples, for a sampling rate.
Segmentation segmentation_of(const SegmentOptions& options, double sampling_rate_hz, std::size_t samples);

/// The samples without mean and linear trend (least squares over the finite ones); missing samples stay missing.
std::vector<double> without_trend(const std::vector<double>& samples);

}  // namespace railpem::recordings
