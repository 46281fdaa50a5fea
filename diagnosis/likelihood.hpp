#pragma once
// How well a trial explains the cross-spectral matrices, and how that changes with every unknown.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "diagnosis/reuse.hpp"
#include "diagnosis/trial.hpp"

namespace railpem::diagnosis {

/// Which part of the recordings speaks.
enum class Part { fitted, held_out, all };

/// Predictions of a trial for every observation, without noise and floor, and what makes similar ones cheap. Of a
/// scalar recording ExpectedSpectra::values are its predict_scalars() with the gains of the trial, without channels.
struct Predictions {
    std::vector<ExpectedSpectra> spectra;
    /// what predictions of similar trials may reuse; none where it was let go (ten megabytes for a recording)
    std::vector<ExpectationCache> caches;
    const ExpectedSpectra& operator[](std::size_t observation) const { return spectra[observation]; }
};

/// The derivative of the prediction of one observation with one unknown, or nothing when it does not move it.
struct PredictionDerivative {
    int observation = 0;
    int unknown = 0;
    std::vector<std::complex<double>> values;  ///< as ExpectedSpectra::values
    /// of the values, within ExpectedSpectra; before and behind them it is zero
    std::size_t first_bin = 0;
};

/// Second-order picture of the log-likelihood around a trial.
struct LikelihoodSlope {
    double log_likelihood = 0.0;  ///< relative to the saturated model
    Eigen::VectorXd gradient;     ///< Σ n tr(A_i R), R = L⁻¹ŜL⁻ᴴ − 1, A_i = L⁻¹ ∂_iS L⁻ᴴ
    Eigen::MatrixXd information;  ///< Σ n tr(A_i A_j) (Fisher)
};

/// What one trial's bin leaves for those of similar trials.
struct BinPower {
    double processes = 1.0;          ///< that it looks like (WhitenedBin::processes)
    double log_amplification = 0.0;  ///< its most probable s (WhitenedBin), where the search for another's begins,
    double bend = 0.0;               ///< and how the slope falls there; 0: not known
};

/// Those of a trial, [observation][bin], and its log-likelihood, of time series alone.
struct BinPowers {
    std::vector<std::vector<BinPower>> at;
    double log_likelihood = 0.0;
};

class Effort;

/// Everything that a likelihood is asked about.
struct LikelihoodContext {
    const BelievedCase* believed = nullptr;
    const std::vector<Observation>* observations = nullptr;
    /// the same in short windows, for blunted(); none: `observations` serve
    const std::vector<Observation>* coarse = nullptr;
    Part part = Part::fitted;
    double least_floor = 0.0;  ///< relative; large values blunt the likelihood while a fit is far away
    int threads = 0;
    const BinPowers* powers = nullptr;  ///< of another trial, whose counts of processes hold; none: every trial's own
    std::size_t every = 1;              ///< of the bins of time series: one in so many speaks, for all of them
    Effort* effort = nullptr;           ///< counts what is computed; none: nobody asks
};

/// Of the bins, where a likelihood is blunt: the amplitudes of neighbours of Hann windows, (−¼, ½, −¼) of plain ones,
/// are correlated by 2/3.
inline constexpr std::size_t kBluntEvery = 2;

/// The likelihood on every second bin of the coarse observations, blunted by a relative floor.
LikelihoodContext blunted(const LikelihoodContext& context, double floor);

/// Prediction of one observation, `reuse` from the cache of a similar trial.
ExpectedSpectra predict_one(const Trial& trial, const LikelihoodContext& context, std::size_t observation,
                            const ExpectationCache* known = nullptr, Reuse reuse = Reuse::nothing,
                            ExpectationCache* filled = nullptr);

/// Predictions of a trial; observations in parallel.
Predictions predict(const Trial& trial, const LikelihoodContext& context);

/// The same from what the predictions of a similar trial may share, as far as they have it.
ExpectedSpectra predict_like(const Predictions& similar, const Trial& trial, const LikelihoodContext& context,
                             std::size_t observation, Reuse reuse);

/// Log-likelihood of averaged cross-spectra (complex Wishart; Yuen, Katafygiotis & Beck 2002) relative to the saturated
/// model: −Σ n[log det S − log det Ŝ + tr(S⁻¹Ŝ) − p], S = prediction + noise + floor.
double log_likelihood(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context);

/// A trial's own, whatever powers `context` has.
BinPowers bin_powers(const Trial& trial, const Predictions& predictions, const LikelihoodContext& context);

/// The same with its slope. The sums are made in a fixed order, whatever the number of threads.
LikelihoodSlope likelihood_slope(const Trial& trial, const std::vector<Unknown>& unknowns,
                                 const Predictions& predictions, const std::vector<PredictionDerivative>& derivatives,
                                 const LikelihoodContext& context);

/// What neighbouring bins of one observation add to the gradient of the log-likelihood; at its top they sum up to
/// nothing (or the beliefs' pull).
struct GradientBlock {
    std::size_t observation = 0;
    double frequency_hz = 0.0;  ///< the first bin's
    Eigen::VectorXd gradient;   ///< one element per unknown
};

/// The gradient in blocks of a few hertz, observation by observation, upwards. Time series only.
std::vector<GradientBlock> gradient_blocks(const Trial& trial, const std::vector<Unknown>& unknowns,
                                           const Predictions& predictions,
                                           const std::vector<PredictionDerivative>& derivatives,
                                           const LikelihoodContext& context);

/// The measured spectra of the part in question.
const MeasuredSpectra& measured(const Observation& observation, Part part);

/// Prediction with noise and floor at a bin of an observation.
Eigen::MatrixXcd complete_prediction(const Trial& trial, const Observation& observation, std::size_t index,
                                     const ExpectedSpectra& prediction, std::size_t bin, double least_floor = 0.0);

}  // namespace railpem::diagnosis
