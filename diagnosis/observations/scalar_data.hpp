#pragma once
// Recordings that are levels over frequency: spectra without phases between channels, quoted points, receptances, decay
// rates.

#include <complex>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recordings/recording_description.hpp"

namespace railpem::diagnosis {

/// One measured value as its logarithm.
struct ScalarValue {
    std::size_t channel = 0;         ///< index into Observation::channels; 0 for what is measured on the track
    double frequency_hz = 0.0;       ///< > 0
    std::complex<double> log_value;  ///< natural logarithm; the imaginary part is the phase, where it is known
    double deviation = 0.1;          ///< standard deviation of the logarithm (and of the phase, rad)
    double sharing = 1.0;            ///< values within the same twelfth of an octave: they share their discrepancy
    /// of what the prediction is held against (pem::DecayRateReference): shared like the discrepancy
    double shared_deviation = 0.0;
    /// psd: added to the measured value before the logarithm, so that zeros of the comb of the wheels do not count for
    /// what no window could resolve
    double pedestal = 0.0;
    /// and to the model's: this share of the mean of its values in the third-octave, as the pedestal is of the measured
    /// ones. Each has its own, or a model far below what was recorded would be as near as its pedestal
    double pedestal_share = 0.0;
    bool held_out = false;  ///< no fit sees it
};

/// The third-octave of a value: ten to a decade.
long third_octave_of(double frequency_hz);

/// Mean of levels, one per value, over the values of the same channel and third-octave, for every value.
std::vector<double> third_octave_means(const std::vector<ScalarValue>& values, const std::vector<double>& levels);

/// The twelfth of an octave in which values share their discrepancy.
long discrepancy_cell(double frequency_hz);

/// The values of one recording. Measured and predicted are compared in the logarithm, which is Gaussian for an average
/// of many and makes a factor the same error at every level.
struct ScalarData {
    recordings::RecordingKind kind = recordings::RecordingKind::psd;
    recordings::Place place = recordings::Place::over_pad;  ///< receptance
    bool has_phase = false;
    double resolution_hz = 0.0;  ///< psd: spacing of the lines; 0: not known, and lines cannot be predicted
    std::vector<ScalarValue> values;
    std::optional<std::size_t> leader;  ///< the observation whose discrepancy is this one's, too; none: its own
    std::vector<std::string> lacks;     ///< what this recording cannot tell, in words

    /// The track without a vehicle: receptance and decay rate.
    bool of_track() const {
        return kind == recordings::RecordingKind::receptance || kind == recordings::RecordingKind::decay_rate;
    }
};

}  // namespace railpem::diagnosis
