#include "simulate/world_grades.hpp"

#include <cassert>

namespace railpem::simulate {

namespace {

using W = WorldParameters;

// Where a source gives a range, good stands near its lower end and worn near its upper one. "Chosen" says that it is
// ours, and why. "On": where more is to be found about the kind of scatter, not the very number.

std::vector<WorldKey> speed_keys() {
    return {
        {"speed_rms", &W::speed_rms, "1", 0.007, 0.018, 0.0, 0.1, "relative rms of the speed about its mean",
         "ISO 3095:2013 holds a test run to 5 % of its speed; worn fills that range within a minute, good a third"},
        {"speed_correlation_s", &W::speed_correlation_s, "s", 8.0, 8.0, 1.0, 1000.0, "correlation time of the speed",
         "chosen: 40 m/s then change by 0.04 and 0.11 m/s2 rms, a tenth of a service brake (EN 13452-1: 1 m/s2)"},
        {"speed_end_m_per_s", &W::speed_end_m_per_s, "m/s", 0.0, 0.0, 0.0, 200.0,
         "speed at the end of the record, reached linearly; 0: no ramp", "none: a record is meant to hold its speed"},
    };
}

std::vector<WorldKey> seat_keys() {
    return {
        {"pad_scatter", &W::pad_scatter, "1", 0.1, 0.25, 0.0, 1.0,
         "standard deviation of the logarithm of the pads' stiffness, seat to seat",
         "range 10 to 30 %; on measured scatter: Oscarsson, Vehicle System Dynamics 37 (2002) 59-79"},
        {"pad_damping_scatter", &W::pad_damping_scatter, "1", 0.15, 0.3, 0.0, 1.0,
         "the same of their dashpots, independent of the stiffness",
         "chosen above the stiffness; on pads and their loss: Fenander, Proc. IMechE F 211 (1997) 51-62"},
        {"support_scatter", &W::support_scatter, "1", 0.15, 0.35, 0.0, 1.0,
         "the same of what lies under the pads, varying slowly along the line",
         "range 20 to 50 %, good: a new line; on stiffness measured in motion: Li & Berggren, IHHA 2009"},
        {"support_length_m", &W::support_length_m, "m", 20.0, 20.0, 1.0, 1000.0, "correlation length of that",
         "tens of metres; see Berggren, thesis KTH, TRITA AVE 2009:17"},
        {"ground_share", &W::ground_share, "1", 0.2, 0.2, 0.0, 0.9,
         "single-layer tracks: share of a seat's compliance that is the ground's",
         "chosen: slab tracks, whose compliance is nearly all in the pads"},
    };
}

std::vector<WorldKey> line_keys() {
    return {
        {"own_irregularity_at_1_m", &W::own_irregularity_at_1_m, "1", 1e-3, 1e-2, 0.0, 1.0,
         "share of the irregularity's spectrum, at 1 m, that each wheel meets for itself",
         "chosen: parallel lines on one rail agree in long waves, not in short ones (EN 15610:2019 measures several)"},
        {"own_irregularity_exponent", &W::own_irregularity_exponent, "1", 1.0, 1.0, 0.0, 3.0,
         "the share grows with 1/wavelength to this power",
         "chosen: 1e-4 at 10 m, 1e-2 at 0.1 m; on correlation across the contact: Remington, JSV 46 (1976)"},
        {"rough_level_db", &W::rough_level_db, "dB", 1.0, 4.0, -20.0, 20.0, "a rougher stretch: over the rest",
         "EN 13848-6: neighbouring quality classes of longitudinal level are 2.7 to 4.3 dB apart"},
        {"rough_share", &W::rough_share, "1", 0.2, 0.2, 0.0, 1.0, "share of the record that it takes", "chosen"},
        {"impacts_per_km", &W::impacts_per_km, "1/km", 0.3, 4.0, 0.0, 1000.0, "dips at random places, mean number",
         "chosen: rare on a welded line in good state; worn: one in 250 m"},
        {"impact_depth_m", &W::impact_depth_m, "m", 2e-4, 5e-4, 0.0, 5e-3, "mean depth of a dip",
         "chosen: a weld; on their geometry: Steenbergen & Esveld, Proc. IMechE F 220 (2006)"},
        {"impact_length_m", &W::impact_length_m, "m", 0.5, 0.5, 0.05, 5.0, "mean length of a dip",
         "chosen; on dipped joints: Jenkins et al., Railway Engineering Journal 3 (1974)"},
    };
}

std::vector<WorldKey> sensor_keys() {
    return {
        {"gain_scatter", &W::gain_scatter, "1", 0.01, 0.02, 0.0, 0.5,
         "standard deviation of the calibration of a channel, relative",
         "chosen: as a calibration by comparison is uncertain (ISO 16063-21), and twice that"},
        {"gain_drift", &W::gain_drift, "1", 0.002, 0.01, 0.0, 0.5,
         "standard deviation of its change from begin to end of the record, relative",
         "chosen: sensitivity of piezoelectric sensors changes by 0.1 % per K; 2 K and 10 K"},
        {"noise_rms_m_per_s2", &W::noise_rms_m_per_s2, "m/s^2", 0.02, 0.05, 0.0, 100.0,
         "noise of every channel, from 0.5 Hz to half the sampling rate",
         "chosen: 9e-4 (m/s2)/rtHz at 1 kHz, an industrial accelerometer for axle boxes of some 1000 m/s2"},
        {"noise_corner_hz", &W::noise_corner_hz, "Hz", 10.0, 20.0, 0.0, 1000.0,
         "below it the noise grows with 1/frequency",
         "chosen; on 1/f noise of such sensors: Levinzon, IEEE Sensors J. 4 (2004) 108-111"},
        {"tone_rms_m_per_s2", &W::tone_rms_m_per_s2, "m/s^2", 0.0, 0.02, 0.0, 100.0,
         "a sharp tone on one channel, which is drawn", "chosen: as strong as the noise of a good sensor"},
        {"tone_hz", &W::tone_hz, "Hz", 50.0, 50.0, 0.1, 50000.0, "its frequency", "mains and their converters"},
    };
}

}  // namespace

const std::vector<WorldKey>& world_keys() {
    static const std::vector<WorldKey> all = [] {
        std::vector<WorldKey> list;
        for (const auto& keys : {speed_keys(), seat_keys(), line_keys(), sensor_keys()})
            list.insert(list.end(), keys.begin(), keys.end());
        return list;
    }();
    return all;
}

const std::vector<std::string>& world_grades() {
    static const std::vector<std::string> names{"ideal", "good", "worn"};
    return names;
}

WorldParameters world_of_grade(const std::string& grade) {
    WorldParameters world;
    assert(grade == "ideal" || grade == "good" || grade == "worn");
    if (grade == "ideal") return world;
    for (const WorldKey& key : world_keys()) world.*key.member = grade == "good" ? key.good : key.worn;
    return world;
}

}  // namespace railpem::simulate
