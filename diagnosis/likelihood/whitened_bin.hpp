#pragma once
// One bin of an observation seen through a trial.

#include <array>

#include "diagnosis/likelihood/likelihood_context.hpp"
#include "diagnosis/likelihood/split_matrix.hpp"

namespace railpem::diagnosis {

/// A bin, whitened with the trial's S(s) = e^s·(prediction + floor) + noise.
///
/// The irregularity that excites a bin is one process, whose power averages over n windows know to 1/√n. Channels
/// behind different wheels hear it at different times, so that within a window S has r > 1 eigenvalues above the noise;
/// to the Wishart distribution they are r processes, whose power it would know to 1/√(r·n). The excess is shared with
/// the neighbouring bins, which count it again. The logarithm s of the bin's power is therefore unknown by the variance
/// v = (r − 1)/(r·n) that leaves n: 1/(1/(r·n) + v) = n. s is at its most probable value; `projection` takes what it
/// explains out of the information.
struct WhitenedBin {
    SplitMatrix inverse_factor;  ///< L⁻¹ of S(s) = LLᴴ
    SplitMatrix residual;        ///< L⁻¹ŜL⁻ᴴ − 1, lower triangle
    SplitMatrix scale;           ///< L⁻¹ ∂S/∂s L⁻ᴴ, lower triangle
    double amplification = 1.0;  ///< e^s
    double processes = 1.0;      ///< r where s = 0, or what was known of it
    double bend = 0.0;           ///< how the slope of the log-likelihood with s falls, per average; 0 without excess
    double projection = 0.0;  ///< c in 1 − c·aaᵀ, a the packed `scale`: (r − 1)/r², r = tr(scale²); 0 without excess
    /// per average, relative to the saturated model, −s²/(2vn) included; −∞ where S is not definite
    double log_likelihood = 0.0;
};

/// Whitens into `result`, which may be used again for the next bin: some kilobytes that need not be moved. `known`: r,
/// and where the search for s begins, from another trial; none: the trial's own.
void whiten(const Trial& trial, const Observation& observation, std::size_t index, const ExpectedSpectra& prediction,
            const MeasuredSpectra& data, std::size_t bin, double least_floor, const BinPower* known,
            WhitenedBin& result);

/// Square of the relative amplitude of a trial's floor, by floor_group() of a response.
std::array<double, kFloorGroups> fitted_floors_at(const Trial& trial, double frequency_hz);

/// Square of the floor's relative amplitude, of `least` and of the sensors' error added, by floor_group() of a
/// response.
std::array<double, kFloorGroups> floors_at(const Trial& trial, double frequency_hz, double least);

}  // namespace railpem::diagnosis
