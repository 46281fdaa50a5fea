#pragma once
// What the estimator of a recording would measure if the model were true.

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <vector>

#include "pem/case_parameters.hpp"
#include "pem/contact_distortion.hpp"
#include "pem/excitation.hpp"
#include "pem/modulated_forces.hpp"
#include "pem/pad_distortion.hpp"
#include "pem/realised_friction.hpp"
#include "pem/wheel_transfers.hpp"
#include "recordings/cross_spectra.hpp"

namespace railpem::diagnosis {

/// Channels of a recording that the model knows: index of the channel and of the response.
struct ObservedChannel {
    std::size_t channel;
    std::size_t response;
    int integrations = 0;  ///< 0 acceleration, 1 velocity, 2 displacement
};

/// Pairs channels with responses by location and index (wheel n, bogie n, rail n; body by its position: centre or a
/// pivot within 0.25 m). Channels elsewhere are left out.
std::vector<ObservedChannel> observed_channels(const std::vector<recordings::ChannelDescription>& channels,
                                               const pem::CaseParameters& parameters);

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
    double high_hz = 175.0;
    /// grid of the single-wheel transfers: what an axle box leaves unsaid by the others is 1e-5 of its power
    double transfer_step_hz = 0.25;
    int rail_every = 8;    ///< the rail is smoother still: solved at one line of that grid in so many
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
    recordings::KernelWeights weights;  ///< of the kernel, when whoever asks often has them already; else computed
};

/// From acceleration to the channel's quantity, and what its sensors do, at a frequency.
std::complex<double> channel_factor(const pem::CaseParameters& parameters, const ObservedChannel& channel,
                                    double frequency_hz);

/// The kernel on the fine grid of an expectation.
recordings::KernelWeights expectation_weights(const recordings::WindowKernel& kernel, int oversampling);

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
    pem::WheelTransfers transfers, of_irregularity;  ///< the latter with what comes back through the supports
    std::vector<pem::SensorParameters> sensors;      ///< that are part of them
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

/// Expectation of the windowed estimate: ∫|W(f − f')|² S(f') df' with S = Σ_s y_s y_sᴴ over all broadband sources with
/// their delays, plus P·K(f − f_l) for every line l of power P, plus noise. The single-wheel transfers are solved on a
/// coarse grid and interpolated; delays and irregularity enter analytically on the fine grid. `noise_psd`: per observed
/// channel, (m/s²)²/Hz, flat. Sensors of the case are applied. `reuse` says what is taken from `known`; `filled`
/// receives what others may reuse.
ExpectedSpectra expected_spectra(const pem::CaseParameters& parameters, double speed_m_per_s,
                                 const recordings::WindowKernel& kernel, const std::vector<ObservedChannel>& channels,
                                 const std::vector<double>& noise_psd, const ExpectationOptions& options,
                                 const ExpectationCache* known = nullptr, Reuse reuse = Reuse::nothing,
                                 ExpectationCache* filled = nullptr);

/// tr(S⁻¹Ŝ)/channels at every bin: 1 on average when the model predicts what the estimator measures.
std::vector<double> whitened_trace(const ExpectedSpectra& expected, const recordings::CrossSpectra& measured,
                                   const std::vector<ObservedChannel>& channels);

}  // namespace railpem::diagnosis
