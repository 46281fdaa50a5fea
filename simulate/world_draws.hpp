#pragma once
// What the imperfections of one record came out as, for the truth about it.

#include <cstdint>
#include <string>
#include <vector>

namespace railpem::simulate {

/// A raised-cosine dip of the running surface: −depth/2·(1 + cos(2πx/length)) within half its length.
struct Dip {
    double position_m = 0.0;  ///< from where the centre of the car is at time 0
    double depth_m = 0.0;
    double length_m = 1.0;
};

/// Calibration of one channel over the record: gain·(1 + drift·(t/T − 1/2)).
struct ChannelDraw {
    double gain = 1.0;
    double drift = 0.0;
};

struct WorldDraws {
    double mean_speed_m_per_s = 0.0, least_speed_m_per_s = 0.0, most_speed_m_per_s = 0.0;  ///< during the record
    double speed_rms_m_per_s = 0.0;                                                        ///< about the mean
    std::int64_t first_seat =
        0;  ///< number of the seat of the first factors below; 0: the one at or behind wheel 1 at time 0
    std::vector<double> pad_stiffness;      ///< of the seats along the record, relative to the case; empty: no scatter
    std::vector<double> support_stiffness;  ///< the same of what lies under them
    double rough_from_m = 0.0, rough_to_m = 0.0;  ///< equal: no rough stretch
    std::vector<Dip> dips;
    std::vector<ChannelDraw> channels;  ///< in the order of channel_names(); empty: as calibrated
    std::string tone_channel;           ///< empty: none
};

}  // namespace railpem::simulate
