#include "recordings/fault.hpp"

namespace railpem::recordings {

std::string fault_name(FaultKind kind) {
    static const char* const names[] = {"missing-samples", "held-values",  "constant",       "coarse-resolution",
                                        "clipping",        "offset",       "drift",          "low-frequency-noise",
                                        "duplicated",      "swapped",      "inverted",       "wrong-unit",
                                        "unknown-scale",   "mains-hum",    "aliasing",       "sampling-jitter",
                                        "sampling-rate",   "timing-skew",  "not-stationary", "speed-changes",
                                        "speed-mismatch",  "stop",         "impacts",        "mileage",
                                        "too-short",       "band-limited", "clock-drift",    "not-causal",
                                        "band-centres"};
    return names[static_cast<int>(kind)];
}

std::string severity_name(Severity severity) {
    static const char* const names[] = {"note", "warning", "error"};
    return names[static_cast<int>(severity)];
}

}  // namespace railpem::recordings
