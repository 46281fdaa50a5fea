#pragma once

#include <complex>
#include <vector>

namespace railpem::recordings {

/// One order of rotation along the record.
struct OrderTrack {
    double order = 1.0;
    std::vector<double> time_s;                   ///< centres of the windows
    std::vector<double> frequency_hz;             ///< order × v/(2πR) there
    std::vector<std::complex<double>> amplitude;  ///< peak value, phase against the wheel's angle
    double mean_square = 0.0;  ///< of the order over the record, its share of the background taken off
    double background = 0.0;   ///< one-sided PSD beside the order, unit²/Hz
    double false_alarm = 1.0;  ///< that the background alone shows so much power at the order
};

/// Follows an order through changes of speed: the samples are demodulated with the wheel's angle ∫v/R dt and averaged
/// in Hann windows, half overlapped; the background comes from the same beside the order (± 2 and ± 3 bins of the
/// window). `speed_m_per_s`: one value per sample. Missing samples count as 0.
OrderTrack track_order(const std::vector<double>& samples, double sampling_rate_hz,
                       const std::vector<double>& speed_m_per_s, double wheel_radius_m, double order,
                       double window_s = 4.0);

}  // namespace railpem::recordings
