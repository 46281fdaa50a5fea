#pragma once
// Sentences that the text and the page of an inspection share.

#include <string>
#include <vector>

#include "recordings/inspection/inspection_report.hpp"

namespace railpem::recordings {

/// One sentence: can the recording be trusted.
std::string verdict_of(const InspectionReport& report);

std::string place_words(const ChannelDescription& channel);  ///< "wheel 1", "body +9 m", "wheel 2 left"
std::string fault_place(const Fault& fault);                 ///< channels and time of a fault: "axlebox_1 at 12.3 s"
std::string speed_words(const InspectionReport& report);     ///< "" when nothing is known
std::string unit_words(const InspectionReport& report);  ///< units in the file and who says so; "" when none is known
std::string averages_words(const InspectionReport& report);  ///< "" when there is no spectrum

/// What irregularity was brought, over which wavelengths and, at the recording's speed, frequencies; "" when none was.
std::string irregularity_words(const InspectionReport& report);

/// A table of the kinds that are not time series, in words: {"decay rate", "18 bands, 100 to 5000 Hz"}.
struct TableFact {
    std::string name, holds;
};
std::vector<TableFact> table_facts(const InspectionReport& report);

}  // namespace railpem::recordings
