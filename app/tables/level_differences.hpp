#pragma once
// What changes from one case to another, in third-octaves.

#include <string>
#include <vector>

#include "app/number_table.hpp"
#include "app/tables/response_tables.hpp"

namespace railpem::app {

/// Two cases, each solved at one speed. Differences are 10·log10 of (second case)/(first case) of the mean square in a
/// third-octave, in dB: positive where the second case has more. For the force into the trackbed this is the insertion
/// gain of whatever distinguishes the second case (the negative of its insertion loss).
struct LevelDifferences {
    double speed_1_m_per_s = 0.0, speed_2_m_per_s = 0.0;
    std::vector<double> centre_hz;  ///< nominal centres of the bands that the lines of both cases cover
    std::vector<std::vector<double>> difference_db;  ///< [response of pem::response_names()][band]
    std::vector<double> rms_1, rms_2;                ///< [response], over all lines of its case; m/s² or N
    std::vector<std::string> warnings;               ///< of both cases
};

/// A band in which a response is at rest in both cases has no difference and is left out.
LevelDifferences level_differences(const ResponseSpectra& first, const ResponseSpectra& second);

/// The *.compare.csv table: centre_hz, `<where>_acceleration_level_difference_db`,
/// `contact_n_force_level_difference_db`, `trackbed_force_insertion_gain_db`; with several speeds speed_m_per_s first.
NumberTable difference_table(const std::vector<LevelDifferences>& speeds);

/// The *.compare.json text: per speed and response both rms values, their ratio in dB and the band of the largest
/// difference.
std::string difference_summary_text(const std::string& case_1, const std::string& case_2,
                                    const std::vector<LevelDifferences>& speeds);

}  // namespace railpem::app
