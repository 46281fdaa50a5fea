#pragma once
// What a likelihood is asked about, and what it answers, as data.

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "diagnosis/model/reuse.hpp"
#include "diagnosis/model/trial.hpp"

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

/// The likelihood on every second bin of the coarse observations, blunted by a relative floor.
LikelihoodContext blunted(const LikelihoodContext& context, double floor);

/// How the expectation of a part of an observation is computed: at the speeds of its windows.
ExpectationOptions expectation_of(const Observation& observation, Part part);

/// The measured spectra of the part in question.
const MeasuredSpectra& measured(const Observation& observation, Part part);

}  // namespace railpem::diagnosis
