#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "simulate/world_draws.hpp"

namespace railpem::simulate {

/// What was measured where, as the recording's description says it.
struct Channel {
    std::string name;      ///< axlebox_1 … axlebox_4, bogie_1, bogie_2, body_front, body_rear, body_centre
    std::string location;  ///< wheel, bogie, body
    int index = 0;         ///< wheel or bogie; 0: body
    double position_m = 0.0;
    std::vector<double> acceleration_m_per_s2;
};

/// What happened while the record was made: for the user's eyes and the truth file, not part of the recording.
struct Making {
    double step_s = 0.0;
    double profile_rms_m = 0.0;     ///< of the irregularity met during the record
    double profile_length_m = 0.0;  ///< it does not repeat within this
    double shortest_wavelength_m = 0.0;
    double chain_error = 0.0;         ///< of the pads' relaxation chain against the law, 1 to 400 Hz
    double contact_lost_share = 0.0;  ///< share of wheel time without contact
    double solves_per_step = 0.0;
    double seconds_per_second = 0.0;  ///< computing time per second of record
    WorldDraws draws;                 ///< speed, and what the imperfections of the world came out as
};

struct Recording {
    double sampling_rate_hz = 0.0;
    double speed_m_per_s = 0.0;  ///< the mean over the record
    double speed_standard_error_m_per_s = 0.0;
    double payload_kg = 0.0;
    std::vector<Channel> channels;
    std::vector<double> speed_channel_m_per_s{};  ///< the speed sample by sample; empty: not recorded
    Making making;

    std::size_t samples() const { return channels.empty() ? 0 : channels.front().acceleration_m_per_s2.size(); }
};

/// Names in the order of the columns.
const std::vector<std::string>& channel_names();

/// CSV: `time_s`, the channels, and `speed` if it was recorded; one row per sample, seven significant digits (two below
/// the least noise of a sensor).
void write_csv(std::ostream& out, const Recording& recording);

/// The description that goes with it, TOML; `data`: name of the file with the samples.
std::string description(const Recording& recording, const std::string& data);

}  // namespace railpem::simulate
