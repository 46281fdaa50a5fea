#include "recordings/text/time_stamp.hpp"

#include <charconv>
#include <chrono>

namespace railpem::recordings {
namespace {

/// Takes text from the front, piece by piece.
class Pieces {
  public:
    explicit Pieces(std::string_view text) : left_(text) {}

    bool empty() const { return left_.empty(); }
    std::string_view left() const { return left_; }

    bool take(char c) {
        if (left_.empty() || left_.front() != c) return false;
        left_.remove_prefix(1);
        return true;
    }

    bool take_word(std::string_view lower) {
        if (left_.size() < lower.size()) return false;
        for (std::size_t i = 0; i < lower.size(); ++i)
            if ((left_[i] | 0x20) != lower[i]) return false;
        left_.remove_prefix(lower.size());
        return true;
    }

    void skip_blanks() {
        while (take(' ')) {
        }
    }

    /// A whole number of `least` to `most` digits.
    std::optional<int> number(std::size_t least, std::size_t most) {
        std::size_t digits = 0;
        while (digits < left_.size() && digits < most && left_[digits] >= '0' && left_[digits] <= '9') ++digits;
        if (digits < least) return std::nullopt;
        int value = 0;
        std::from_chars(left_.data(), left_.data() + digits, value);
        left_.remove_prefix(digits);
        return value;
    }

    /// ".002" or ",002", as a share of one; empty when there is none.
    std::optional<double> fraction() {
        if (left_.size() < 2 || (left_.front() != '.' && left_.front() != ',') || left_[1] < '0' || left_[1] > '9')
            return std::nullopt;
        left_.remove_prefix(1);
        double value = 0.0, weight = 1.0;
        while (!left_.empty() && left_.front() >= '0' && left_.front() <= '9') {
            value = 10.0 * value + (left_.front() - '0');
            weight *= 10.0;
            left_.remove_prefix(1);
        }
        return value / weight;
    }

  private:
    std::string_view left_;
};

std::optional<long> day_number(int year, int month, int day) {
    using namespace std::chrono;
    const year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                              std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok() || year < 1900 || year > 2200) return std::nullopt;
    return sys_days(date).time_since_epoch().count();
}

/// A date at the front, taken off; nothing is taken when there is none.
std::optional<long> take_date(Pieces& text) {
    Pieces ahead = text;
    const std::optional<int> first = ahead.number(1, 4);
    if (!first) return std::nullopt;
    const char separator = ahead.empty() ? '\0' : ahead.left().front();
    if ((separator != '-' && separator != '/' && separator != '.') || !ahead.take(separator)) return std::nullopt;
    const std::optional<int> second = ahead.number(1, 2);
    if (!second || !ahead.take(separator)) return std::nullopt;
    const std::optional<int> third = ahead.number(1, 4);
    if (!third) return std::nullopt;
    std::optional<long> day;
    if (*first > 31)
        day = day_number(*first, *second, *third);
    else if (separator == '/' && *first <= 12)
        day = day_number(*third < 100 ? 2000 + *third : *third, *first, *second);
    if (!day && *first <= 31) day = day_number(*third < 100 ? 2000 + *third : *third, *second, *first);
    if (day) text = ahead;
    return day;
}

/// "20240607T130000.5": the basic form of ISO 8601.
std::optional<TimeStamp> basic_form(Pieces text) {
    const std::optional<int> year = text.number(4, 4), month = text.number(2, 2), day = text.number(2, 2);
    if (!year || !month || !day || !text.take_word("t")) return std::nullopt;
    const std::optional<int> hour = text.number(2, 2), minute = text.number(2, 2), second = text.number(2, 2);
    const std::optional<long> days = day_number(*year, *month, *day);
    if (!hour || !minute || !second || !days) return std::nullopt;
    const double part = text.fraction().value_or(0.0);
    text.take_word("z");
    if (!text.empty()) return std::nullopt;
    return TimeStamp{true, *days, 3600.0 * *hour + 60.0 * *minute + *second + part};
}

/// AM and PM, and the zone, behind a time of day. False when something else stands there.
bool take_tail(Pieces& text, double& second) {
    text.skip_blanks();
    const bool morning = text.take_word("am"), afternoon = !morning && text.take_word("pm");
    if (morning && second >= 12.0 * 3600.0) second -= 12.0 * 3600.0;
    if (afternoon && second < 12.0 * 3600.0) second += 12.0 * 3600.0;
    text.skip_blanks();
    if (text.take_word("utc") || text.take_word("gmt") || text.take_word("z")) text.skip_blanks();
    if (text.empty()) return true;
    const bool east = text.take('+');
    if (!east && !text.take('-')) return false;
    const std::optional<int> hours = text.number(2, 2);
    if (!hours) return false;
    text.take(':');
    const double shift = 3600.0 * *hours + 60.0 * text.number(2, 2).value_or(0);
    second += east ? -shift : shift;
    return text.empty();
}

/// "13:00", "13:00:00.002" or, without a date, "05:12.3" for minutes and seconds; the rest of the text.
std::optional<double> time_of_day(Pieces text, bool has_date) {
    const std::optional<int> first = text.number(1, 2);
    if (!first || !text.take(':')) return std::nullopt;
    const std::optional<int> second = text.number(2, 2);
    if (!second || *second > 59) return std::nullopt;
    double seconds = 0.0;
    if (text.take(':')) {
        const std::optional<int> third = text.number(1, 2);
        if (!third || *third > 60 || *first > 24) return std::nullopt;
        std::optional<double> part = text.fraction();
        if (!part && text.take(':')) {  // hours:minutes:seconds:milliseconds
            const std::optional<int> thousandths = text.number(3, 3);
            if (!thousandths) return std::nullopt;
            part = 1e-3 * *thousandths;
        }
        seconds = 3600.0 * *first + 60.0 * *second + *third + part.value_or(0.0);
    } else {
        const std::optional<double> part = text.fraction();
        const bool minutes_and_seconds = part && !has_date;
        if (!minutes_and_seconds && *first > 24) return std::nullopt;
        seconds = minutes_and_seconds ? 60.0 * *first + *second + *part : 3600.0 * *first + 60.0 * *second;
    }
    if (!take_tail(text, seconds)) return std::nullopt;
    return seconds;
}

}  // namespace

std::optional<TimeStamp> parse_time_stamp(std::string_view field) {
    constexpr std::size_t shortest = 4, longest = 48;
    if (field.size() < shortest || field.size() > longest || field.front() < '0' || field.front() > '9')
        return std::nullopt;
    Pieces text(field);
    if (const auto basic = basic_form(text)) return basic;
    const std::optional<long> day = take_date(text);
    if (day) {
        if (!text.take_word("t")) text.take(',');
        text.skip_blanks();
        if (text.empty()) return TimeStamp{true, *day, 0.0};
    }
    const std::optional<double> second = time_of_day(text, day.has_value());
    if (!second) return std::nullopt;
    return TimeStamp{day.has_value(), day.value_or(0), *second};
}

}  // namespace railpem::recordings
