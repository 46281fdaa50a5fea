#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace railpem::app {

/// A bar with the remaining time on stderr, only when stderr is a terminal and only from two seconds on.
class ProgressBar {
  public:
    explicit ProgressBar(std::string label);
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();  ///< wipes the bar

    void show(std::size_t done, std::size_t all);

  private:
    using Clock = std::chrono::steady_clock;
    std::string label_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point begin_;
    Clock::time_point last_;
};

/// The line of the bar: "case1  [#####               ]  25 %  remaining 0:12".
std::string progress_line(const std::string& label, double share, double elapsed_s);

}  // namespace railpem::app
