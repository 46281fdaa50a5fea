#pragma once

#include <string>
#include <vector>

namespace railpem::recordings {

enum class FaultKind {
    missing_samples,
    held_values,
    constant,
    coarse_resolution,
    clipping,
    offset,
    drift,
    low_frequency_noise,
    duplicated,
    swapped,
    inverted,
    wrong_unit,
    unknown_scale,
    mains_hum,
    aliasing,
    sampling_jitter,
    sampling_rate,
    timing_skew,
    not_stationary,
    speed_changes,
    speed_mismatch,
    stop,
    impacts,
    mileage,
    too_short,
    band_limited,
    clock_drift,
    not_causal,
    band_centres
};

/// note: worth knowing; warning: spoils some uses; error: the channel or the record cannot be trusted as it is.
enum class Severity { note, warning, error };

/// Something wrong with a recording: what, where, and how sure. Nothing is repaired because of it.
struct Fault {
    FaultKind kind = FaultKind::missing_samples;
    Severity severity = Severity::warning;
    std::vector<std::string>
        channels;                     ///< empty: the record as a whole; several: these, or one of these as `says` tells
    std::string says;                 ///< one sentence with the numbers
    double from_s = 0.0, to_s = 0.0;  ///< where in time; both 0: everywhere
    double low_hz = 0.0, high_hz = 0.0;  ///< where in frequency; both 0: everywhere
    double value = 0.0;                  ///< size: of the offset, the delay, the share …
    std::string unit;                    ///< of the value
    double false_alarm = 0.0;            ///< probability that a sound recording looks like this; 0: certain
};

/// "missing-samples", "clipping", …
std::string fault_name(FaultKind kind);
std::string severity_name(Severity severity);

}  // namespace railpem::recordings
