#pragma once
// An expectation as data: cross-spectra at bins, how they are computed, and what one leaves for similar ones.

#include <Eigen/Core>
#include <complex>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "diagnosis/expectation/expectation_settings.hpp"
#include "diagnosis/expectation/speed_mixture.hpp"
#include "pem/coupling/excitation.hpp"
#include "pem/coupling/wheel_transfers.hpp"
#include "pem/distortion/contact_distortion.hpp"
#include "pem/distortion/modulated_forces.hpp"
#include "pem/distortion/pad_distortion.hpp"
#include "pem/distortion/realised_friction.hpp"
#include "recordings/estimates/window.hpp"

namespace railpem::diagnosis {

/// Cross-spectral matrices of the observed channels at the bins first … first + count − 1, in the squared units of the
/// channels per Hz: Hermitian, one after the other, each column by column.
struct ExpectedSpectra {
    std::size_t first_bin = 0;
    std::size_t channels = 0;
    std::vector<std::complex<double>> values;

    std::size_t bins() const { return channels == 0 ? 0 : values.size() / (channels * channels); }
    Eigen::Map<Eigen::MatrixXcd> matrix(std::size_t bin) {
        return {values.data() + bin * channels * channels, static_cast<long>(channels), static_cast<long>(channels)};
    }
    Eigen::Map<const Eigen::MatrixXcd> matrix(std::size_t bin) const {
        return {values.data() + bin * channels * channels, static_cast<long>(channels), static_cast<long>(channels)};
    }
};

/// Of both stages; without curves where they have no friction.
struct StageFriction {
    pem::RealisedFriction primary, secondary;
};

/// How the expectation is computed.
struct ExpectationOptions {
    double low_hz = 4.0;
    double high_hz = kExpectationSettings.band_high_hz;
    /// grid of the single-wheel transfers: what an axle box leaves unsaid by the others is 1e-5 of its power
    double transfer_step_hz = 0.25;
    /// the rail is smoother still: solved at one line of that grid in so many
    int rail_every = static_cast<int>(kExpectationSettings.rail_step_hz / transfer_step_hz);
    int oversampling = 4;  ///< fine lines per bin; at least 2·(1 + longest wheel delay/segment)
    /// else, for who forgives a tenth: no modulation by equal seats (29 to 40 dB below the rest), derivatives from
    /// every second line of the rolling rail's table
    bool sharp = true;
    int threads = 0;
    /// of the forces that friction has beside its equivalent damping, over that of a constant force
    double friction_power = 1.0;
    /// what it does where velocities are not Gaussian; none: as if they were
    std::shared_ptr<const StageFriction> realised_friction;
    /// what they distort, but for the case's nonlinearity; not smoothed by the kernel: broad and weak
    pem::ContactDistortion contacts;
    std::shared_ptr<const SpeedMixture> speeds;  ///< at which the windows were run; none: one speed
    recordings::KernelWeights weights;  ///< of the kernel, when whoever asks often has them already; else computed
};

/// Power of the irregularity as wheels meet it, m²/Hz, along the fine lines.
struct MetPowers {
    spectra::IrregularityParameters irregularity;
    double patch_half_length_m = 0.0, speed_m_per_s = 0.0;
    std::vector<double> at_lines;
};

/// What one expectation leaves for others that differ from it only in part.
struct ExpectationCache {
    std::shared_ptr<const pem::RailModel> rail;  ///< none of scalars
    /// on the lines of the transfers, and on those of pem::linearise()
    std::vector<pem::RailGroup> rails, level_rails;
    pem::WheelTransfers transfers, of_irregularity;            ///< the latter with what comes back through the supports
    std::vector<pem::SensorParameters> sensors;                ///< that are part of them
    std::map<std::string, lanes::FactorCurve> sensor_factors;  ///< and pem::Modifiers::sensors
    pem::TrackExcitation track;
    vehicle::FrictionDamping friction;  ///< as linearised: where the next linearisation starts
    /// ExpectedSpectra::values of what the suspension's own forces add; empty without any
    std::vector<std::complex<double>> forces;
    pem::PadTransfers pads;  ///< of pads that load stiffens
    pem::ModulationTransfers modulation;
    std::vector<pem::Modulation> orders;
    std::vector<pem::FeltOrder> felt;
    MetPowers powers;
    std::vector<std::complex<double>> broadband;  ///< ExpectedSpectra::values without lines and what sensors add
};

/// What may be taken from the cache, ever more of it: nothing, the rail (track and speed are the same), all motion
/// (only what sensors make of it differs), all transfers (only the excitation differs) or all that is broadband (only
/// lines differ).
enum class Reuse { nothing, rail, motion, transfers, broadband };

}  // namespace railpem::diagnosis
