#pragma once
// What the description says of a channel, held against what the data file says of it. Where the description is silent,
// the file speaks; where both speak and differ, the description is followed and a fault names both.

#include <optional>
#include <string>
#include <vector>

#include "recordings/fault.hpp"
#include "recordings/files/file_statements.hpp"
#include "recordings/recording_description.hpp"

namespace railpem::recordings {

/// How the numbers of a column become SI values.
struct Conversion {
    double factor = 1.0, offset = 0.0;   ///< number × factor + offset is in the SI unit of the quantity
    std::string says;                    ///< the unit of the numbers, and who says so, in words for a report
    bool scale_is_known = true;          ///< false: nobody says what the numbers are, levels mean nothing
    std::optional<Fault> contradiction;  ///< one message with both sides, or with what neither says
};

/// `key`: of the channel in the description, "channel[2]". Throws parameters::ParameterError when the file says a unit
/// of another quantity and the description says no unit of its own.
Conversion conversion_of(const ChannelDescription& channel, const ColumnStatement& file, const std::string& key);

/// Adds a fault; one that says the same of other channels takes these over: it is told once.
void add_contradiction(const Fault& fault, std::vector<Fault>& contradictions);

/// The rate of the record, Hz, from the description (`described_hz`) and the file (`file_hz`, said at `file_where`); 0:
/// neither says it. When both do and differ by more than 1e-4, the description is followed and a fault is added.
double held_sampling_rate(double described_hz, double file_hz, const std::string& file_where,
                          std::vector<Fault>& contradictions);

/// Columns that start or step at times of their own cannot be one recording: a fault names two of them.
void hold_columns_together(const std::vector<std::string>& names, const std::vector<ColumnStatement>& columns,
                           std::vector<Fault>& contradictions);

/// Fewer samples than the header of the file promises: a fault with both counts.
void hold_promised_rows(std::size_t rows, std::size_t promised, double sampling_rate_hz,
                        std::vector<Fault>& contradictions);

}  // namespace railpem::recordings
