#pragma once

#include <string>
#include <vector>

#include "diagnosis/findings/diagnosis.hpp"

namespace railpem::app {

/// A file of the output folder: its name and its text.
struct TextFile {
    std::string name;
    std::string text;
};

/// The tables of a diagnosis as CSV. A value that does not exist is an empty cell.
/// - <recording>.spectra.csv: frequency_hz, channel, then measured, low, high (90 % of the estimate), believed,
/// retuned,
///   diagnosed, each with _psd_m2_per_s4_per_hz (_receptance_m_per_n, _decay_rate_db_per_m of such recordings); a row
///   per bin and channel
/// - <recording>.bands.csv: centre_hz, channel, then believed, retuned, diagnosed with _level_difference_db: recording
/// over
///   model in third octaves
/// - parameters.csv: the numbers of the case after the fits `retuned` (nothing added) and `diagnosed`, with intervals
/// of
///   90 %, and how many tolerances they are away from what was believed
/// - curves.csv: inferred dynamic stiffnesses with bands of 90 %, beside the laws of the retuned and the diagnosed case
/// Characters of a recording's name that have no place in a file name become '_'; names that then are equal get a
/// number.
std::vector<TextFile> diagnosis_tables(const diagnosis::Diagnosis& diagnosis);

}  // namespace railpem::app
