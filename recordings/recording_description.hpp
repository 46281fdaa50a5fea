#pragma once
// The description of a recording as data: what stands in recording.toml.

#include <optional>
#include <string>
#include <vector>

namespace railpem::recordings {

enum class RecordingKind { timeseries, psd, points, receptance, decay_rate };
enum class ChannelQuantity { acceleration, velocity, displacement, speed, mileage };
enum class Location { none, body, bogie, wheel, rail };
enum class Side { unstated, left, right };
enum class Scale { known, unknown };
enum class Place { over_pad, mid_bay };

/// One [[channel]] of a recording.
struct ChannelDescription {
    std::string name;
    std::string column;  ///< CSV column, MAT variable, UFF record, WAV channel, HDF5 dataset; empty: the name
    ChannelQuantity quantity = ChannelQuantity::acceleration;
    std::string unit;  ///< empty: as the data file says, else the SI unit of the quantity
    std::optional<double>
        scale_factor;  ///< number in the file × this = value in `unit`; empty: as the file says, else 1
    Scale scale = Scale::known;
    double gain_standard_error = 0.01;  ///< relative, of the sensor's calibration; 0: exact
    Location location = Location::none;
    int index = 0;  ///< wheel 1…4, bogie 1…2, rail: under wheel n; 0 for the body
    Side side = Side::unstated;
    double position_m = 0.0;  ///< body only: from the centre, positive towards the front
};

struct RecordingDescription {
    std::string title;
    RecordingKind kind = RecordingKind::timeseries;
    std::string data;               ///< file, relative to the description
    double sampling_rate_hz = 0.0;  ///< 0: as the data file says
    double speed_m_per_s = 0.0;     ///< 0: not stated
    double speed_standard_error_m_per_s = 0.0;
    double payload_kg = 0.0;
    std::string irregularity;       ///< file with a measured PSD or profile; empty: none
    std::string time_column;        ///< empty: a column named time_s, time or t when there is one
    int averages = 0;               ///< psd: independent averages behind every value; 0: not stated
    Place place = Place::over_pad;  ///< receptance
    std::vector<ChannelDescription> channels;
};

}  // namespace railpem::recordings
