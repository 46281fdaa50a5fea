#pragma once

namespace railpem::recordings {

/// How a column of times is written; text: in no way that is known.
enum class TimeWriting { numbers, times_of_day, dates, text };

}  // namespace railpem::recordings
