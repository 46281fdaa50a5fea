#pragma once
// Lines: coherent sources with few degrees of freedom, told from the broadband part by Thomson's F test.

#include <vector>

namespace railpem::recordings {

struct LineOptions {
    double section_s = 8.0;       ///< amplitude and phase may differ from section to section
    double half_bandwidth = 4.0;  ///< NW of the tapers: neighbouring lines closer than 2·NW/section are one
    int tapers = 6;
    int oversampling = 4;       ///< of the frequency grid in which lines are looked for
    double false_alarm = 1e-4;  ///< for the whole search over all frequencies together
    double from_hz = 0.5;
    double to_hz = 1e300;  ///< at most 0.95 of half the sampling rate
};

/// A sinusoid found in the record.
struct SpectralLine {
    double frequency_hz = 0.0;
    double frequency_error_hz = 0.0;  ///< standard error
    double mean_square = 0.0;         ///< power of the line, unit², mean over the sections, noise share taken off
    double background = 0.0;          ///< broadband one-sided PSD around it, unit²/Hz
    double false_alarm = 1.0;         ///< that noise alone gives such a value anywhere in the search
};

/// Lines by the F test of Thomson (1982, eq. 13.10), pooled over sections of the record:
///   F = (K − 1) Σ_s |μ_s|² ΣH_k(0)² / Σ_s Σ_k |y_sk − μ_s H_k(0)|²,  F-distributed with 2S and 2S(K − 1) degrees of
///   freedom.
/// Sections with a missing sample are left out. Sorted by frequency; empty when the record is shorter than one section.
std::vector<SpectralLine> find_lines(const std::vector<double>& samples, double sampling_rate_hz,
                                     const LineOptions& options = {});

/// Test of one given frequency only (mains, an order): nothing is searched, so `false_alarm` is that of this one test.
SpectralLine line_at(const std::vector<double>& samples, double sampling_rate_hz, double frequency_hz,
                     const LineOptions& options = {});

/// The samples with the lines taken out, sinusoid by sinusoid in sections (least squares with all lines together,
/// tapered so that sections join smoothly): the broadband part.
std::vector<double> without_lines(const std::vector<double>& samples, double sampling_rate_hz,
                                  const std::vector<SpectralLine>& lines, double section_s = 8.0);

}  // namespace railpem::recordings
