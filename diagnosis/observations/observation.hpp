#pragma once
// A recording as the likelihood sees it.

#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/expectation/expected_spectra.hpp"
#include "diagnosis/observations/observation_options.hpp"
#include "diagnosis/observations/scalar_data.hpp"
#include "recordings/estimates/window.hpp"

namespace railpem::diagnosis {

/// Averaged cross-spectral matrices of the observed channels from one part of a recording.
struct MeasuredSpectra {
    std::vector<std::complex<double>> values;  ///< as in ExpectedSpectra
    std::vector<double> log_determinant;       ///< per bin; 0 where the averages are too few for one
    double averages = 0.0;                     ///< effective number per bin when all bins are used together
    double seconds = 0.0;
    std::shared_ptr<const SpeedMixture> speeds;  ///< of its windows; none: one speed
};

/// Where a speed was read from, and between which values it ran.
struct ObservedSpeed {
    std::string read_from = "the description";  ///< or "the speed channel", "delays between channels"
    double lowest_m_per_s = 0.0, highest_m_per_s = 0.0;
};

/// One recording: a vehicle at one speed and load (time series and spectra), or the track alone.
struct Observation {
    std::string name;
    double speed_m_per_s = 0.0;
    double speed_tolerance = 0.0;  ///< relative standard deviation
    ObservedSpeed observed_speed;
    double payload_kg = 0.0;
    std::vector<ObservedChannel> channels;
    std::vector<std::string> channel_names;  ///< as the recording calls them
    std::vector<bool> unknown_scale;         ///< per channel
    /// per channel, or none: first guess of the log power of a scale that is unknown; 0 where it is known
    std::vector<double> log_scale;
    /// per channel of a time series: relative standard deviation of its sensitivity; 0: exact
    std::vector<double> calibration;
    std::vector<double> noise_psd;  ///< per channel: first guess, squared unit per Hz
    recordings::WindowKernel kernel;
    ExpectationOptions expectation;
    MeasuredSpectra fitted;    ///< what fits may see
    MeasuredSpectra held_out;  ///< what no fit sees
    MeasuredSpectra all;
    std::optional<ScalarData> scalar;  ///< a recording without time series: the three parts above are then empty
    /// the same recording in short windows: what a blunt likelihood needs, for half the work; none without time series
    std::shared_ptr<const Observation> coarse;

    std::size_t first_bin() const;
    std::size_t bins() const { return all.log_determinant.size(); }
    double frequency(std::size_t bin) const { return static_cast<double>(first_bin() + bin) * kernel.bin_hz(); }
};

/// of a recording that the likelihood takes: its matrices live in registers and on the stack
inline constexpr int kMostChannels = 16;

/// Kernel and band of an observation at its speed: what the options ask for, cut to where the believed irregularity
/// excites. Throws parameters::ParameterError when no usable band is left.
void set_band(Observation& observation, const recordings::WindowKernel& kernel, const pem::CaseParameters& believed,
              const ObservationOptions& options);

/// Bins of the band that set_band() has set.
std::size_t band_bins(const Observation& observation);

/// log det of every matrix of `values`; 0 everywhere when `averages`, the independent ones of a single bin, are fewer
/// than the channels and the matrices are singular.
void set_log_determinants(MeasuredSpectra& measured, std::size_t channels, double averages);

/// The observations in short windows; those that have none as they are.
std::vector<Observation> coarse_observations(const std::vector<Observation>& observations);

}  // namespace railpem::diagnosis
