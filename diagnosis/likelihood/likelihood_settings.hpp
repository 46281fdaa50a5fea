#pragma once
// Every number that steers how a likelihood is computed, in one place.

#include <cstddef>

#include "diagnosis/observations/observation_options.hpp"

namespace railpem::diagnosis {

/// Blocks of bins, and the search for a bin's power. What a caller chooses is in LikelihoodContext.
struct LikelihoodSettings {
    // Bins that are taken together.

    std::size_t chunk_bins = 64;  ///< summed at a time, so that sums do not depend on the threads. Chosen
    /// Hz, bins of one scatter: neighbours share half of their window's band. Chosen: eight of them
    double block_hz = 2.0;
    /// of the bins, one in so many speaks where the likelihood is tempered. Derived: the amplitudes of neighbours of
    /// Hann windows, (−¼, ½, −¼) of plain ones, are correlated by 2/3
    std::size_t tempered_every = 2;

    // The secant method for the logarithm s of a bin's power (whitened_bin.hpp), the first step by Fisher's
    // information.

    int power_steps = 8;              ///< at most. Chosen; not calibrated
    double power_shortening = 4.0;    ///< times: a step that failed, and how far a secant may be off. Chosen
    double longest_power_step = 1.0;  ///< in s. Chosen; not calibrated
    /// a step in s that is not worth making. Derived: ½·n·r·s² is below a thousandth of a nat
    double least_power_step = 1e-3;
    double least_excess = 1e-6;  ///< of processes over one, that a bin's power is sought for. Chosen; not calibrated

    /// Bins of a block in segments of the usual length.
    constexpr std::size_t block_bins() const {
        return static_cast<std::size_t>(block_hz * ObservationOptions{}.window_s);
    }
};

inline constexpr LikelihoodSettings kLikelihoodSettings{};

}  // namespace railpem::diagnosis
