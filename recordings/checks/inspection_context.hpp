#pragma once

#include <optional>
#include <string>
#include <vector>

#include "recordings/estimates/wheelbase_speed.hpp"

namespace railpem::recordings {

/// What a believed case predicts for one channel: one-sided PSD in SI units.
struct PredictedSpectrum {
    std::string channel;
    std::vector<double> frequency_hz;  ///< increasing
    std::vector<double> psd;
};

/// What a believed case predicts for its track without a vehicle.
struct PredictedTrack {
    std::vector<double> frequency_hz;        ///< increasing
    std::vector<double> receptance_m_per_n;  ///< magnitude, where the recording says that the rail was struck
    std::vector<double> centre_hz;           ///< of third-octaves, increasing
    std::vector<double> decay_rate_db_per_m;
};

/// What is believed about vehicle and track, as far as it helps to judge a recording. Everything may be absent.
struct InspectionContext {
    std::optional<VehicleGeometry> geometry;
    double wheel_radius_m = 0.0;     ///< 0: not known
    double sleeper_spacing_m = 0.0;  ///< 0: not known
    std::vector<PredictedSpectrum> predicted;
    PredictedTrack track;  ///< for the kinds receptance and decay-rate
};

}  // namespace railpem::recordings
