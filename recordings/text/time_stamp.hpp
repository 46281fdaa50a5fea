#pragma once
// Dates and times of day as loggers write them.

#include <optional>
#include <string_view>

namespace railpem::recordings {

/// A time of day, with its date when one is written.
struct TimeStamp {
    bool has_date = false;
    long day = 0;         ///< days from 1970-01-01; 0 without a date
    double second = 0.0;  ///< of the day, in UTC when a zone is written
};

/// "2024-06-07T13:00:00.002Z", "2024-06-07 13:00:00,002+02:00", "2024/06/07 13:00", "07.06.2024 13:00:00",
/// "06/07/2024 1:00:00.002 PM", "13:00:00.002", "00:05.3" (minutes and seconds), "20240607T130000". Of 06/07/2024 the
/// larger of the first two numbers is the day where it can be told, else the first is the month. Empty for anything
/// else, a plain number included.
std::optional<TimeStamp> parse_time_stamp(std::string_view text);

}  // namespace railpem::recordings
