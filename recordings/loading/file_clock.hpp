#pragma once
// Times as a file has them become seconds.

#include <optional>
#include <string>
#include <vector>

#include "recordings/fault.hpp"
#include "recordings/files/file_statements.hpp"
#include "recordings/text/time_writing.hpp"

namespace railpem::recordings {

/// Turns a column of times into seconds, section by section: seconds, ms and other units that the file says; times of
/// day over midnight; seconds, ms, us or ns since 1970 and days of a spreadsheet, counted from the first; numbers of
/// samples. A unit that nobody says is told by the sampling rate, where that is stated: 2 per sample at 500 Hz are ms.
/// Without both the numbers are seconds, and a fault is added when that makes fewer than `lowest_rate_hz`.
class FileClock {
  public:
    /// Below this nothing of a vehicle is measured: its slowest mode, the bounce of the body near 1 Hz, needs ten
    /// samples of a period to be seen as it is.
    static constexpr double lowest_rate_hz = 10.0;

    /// `says`: of the column of times. `rate_hz`: stated by the description or the file; 0: by neither.
    FileClock(ColumnStatement says, TimeWriting writing, double rate_hz)
        : says_(std::move(says)), writing_(writing), rate_hz_(rate_hz) {}

    /// Seconds of the next section's times. What was found on the way is added to notes and contradictions. Throws
    /// parameters::ParameterError for a unit that is none of time.
    std::vector<double> seconds(std::vector<double> times, std::vector<std::string>& notes,
                                std::vector<Fault>& contradictions);

    /// Date and time (UTC) of the first sample where the numbers count from 1970; empty: they do not.
    const std::string& start() const { return start_; }

  private:
    void begin(const std::vector<double>& times, std::vector<std::string>& notes);
    bool by_said_unit();
    bool by_rate(double step, std::vector<std::string>& notes);
    bool by_epoch(const std::vector<double>& times, double step, std::vector<std::string>& notes);
    void find_slow(double step, std::size_t count);
    void unwrap(std::vector<double>& times);

    ColumnStatement says_;
    TimeWriting writing_;
    double rate_hz_;
    bool begun_ = false;
    double factor_ = 1.0, origin_ = 0.0;  ///< (number − origin) × factor is in s
    double days_ = 0.0, last_ = 0.0;      ///< midnights passed, in s; the last time before unwrapping
    std::string start_;
    std::optional<Fault> slow_;  ///< of every section, as what else is wrong with the whole record
};

/// The sampling rate that times in seconds make, Hz; 0: too few of them. Times that stand still in every other row or
/// more often tell no rate, which `stand_still` says.
double rate_of_times(const std::vector<double>& time_s, bool& stand_still);

/// Median of the steps between neighbouring times that are not negative; 0 when there are none.
double median_step(const std::vector<double>& times);

}  // namespace railpem::recordings
