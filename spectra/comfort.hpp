#pragma once
// Vertical comfort from a one-sided acceleration PSD in (m/s²)²/Hz on an increasing grid, linear between its lines.
// A measure has no value when the grid does not cover the frequencies it needs; what the grid holds beyond them counts
// with its weight.

#include <optional>
#include <span>

namespace railpem::spectra {

/// Weighted rms acceleration in m/s², W_k (ISO 2631-1:1997). Needs 0.5 to 80 Hz.
std::optional<double> weighted_rms_iso2631(std::span<const double> frequency_hz,
                                           std::span<const double> acceleration_psd);

/// Vertical part of the comfort of EN 12299:2009 on the floor.
struct VerticalComfort {
    double weighted_rms_m_per_s2 = 0.0;   ///< W_b-weighted rms over all times
    double percentile_95_m_per_s2 = 0.0;  ///< 95th percentile of the continuous comfort C_Cz: rms over 5 s
    double mean_comfort = 0.0;            ///< 6·percentile: N_MV with the two horizontal directions at rest
    double degrees_of_freedom = 0.0;      ///< of a 5 s mean square
};

/// Estimate for a stationary Gaussian vibration of this PSD, as of straight uniform track; joints, curves and switches
/// of a real run are not in it. With m = ∫W_b²S df and T = 5 s the variance of a 5 s mean square is
/// s² = ∬ W_b²S(f) W_b²S(f') sinc²((f − f')T) df df' (Gaussian process, f·T ≫ 1; Bendat & Piersol 2010), its
/// distribution about that of m·χ²_ν/ν with ν = 2m²/s², and the percentile of χ²_ν that of Wilson & Hilferty (1931),
/// right within 0.5 % of the rms for ν ≥ 2. For a body at 1 Hz it is 0.9 % below the
/// percentile counted in 20 simulated records of 10240 s. Needs 0.5 to 80 Hz.
std::optional<VerticalComfort> vertical_comfort_en12299(std::span<const double> frequency_hz,
                                                        std::span<const double> acceleration_psd);

/// Sperling's ride index for comfort, vertical: W_z = (100·√2·a_B)^0.3 = 4.42·a_B^0.3 with a_B the B-weighted rms in
/// m/s² between 0.5 and 30 Hz (peaks in cm/s² are √2·rms; Garg & Dukkipati 1984; Andersson, Berg & Stichel 2014).
/// 2 clearly noticeable, 2.5 more pronounced but not unpleasant, 3 strong, irregular but still tolerable.
std::optional<double> sperling_index_vertical(std::span<const double> frequency_hz,
                                              std::span<const double> acceleration_psd);

}  // namespace railpem::spectra
