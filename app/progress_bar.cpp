#include "app/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace railpem::app {

namespace {

constexpr double kSilence_s = 2.0;
constexpr double kInterval_s = 0.1;

double seconds(std::chrono::steady_clock::duration duration) {
    return std::chrono::duration<double>(duration).count();
}

}  // namespace

std::string progress_line(const std::string& label, double share, double elapsed_s) {
    constexpr int kWidth = 30;
    const double within = std::clamp(share, 0.0, 1.0);
    const int filled = static_cast<int>(within * kWidth);
    const long remaining = within > 0.0 ? std::lround(elapsed_s * (1.0 - within) / within) : 0;
    return fmt::format(
        "{}  [{}{}] {:3.0f} %  remaining {}:{:02}", label, std::string(static_cast<std::size_t>(filled), '#'),
        std::string(static_cast<std::size_t>(kWidth - filled), ' '), 100.0 * within, remaining / 60, remaining % 60);
}

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), terminal_(::isatty(STDERR_FILENO) == 1), begin_(Clock::now()), last_(begin_) {}

ProgressBar::~ProgressBar() {
    if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(std::size_t done, std::size_t all) {
    if (!terminal_ || done == 0 || all == 0) return;
    const Clock::time_point now = Clock::now();
    if (seconds(now - begin_) < kSilence_s || seconds(now - last_) < kInterval_s) return;
    last_ = now;
    drawn_ = true;
    std::fputs(
        ("\r" + progress_line(label_, static_cast<double>(done) / static_cast<double>(all), seconds(now - begin_)) +
         "\033[K")
            .c_str(),
        stderr);
}

}  // namespace railpem::app
