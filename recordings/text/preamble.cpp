#include "recordings/text/preamble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "recordings/files/known_units.hpp"
#include "recordings/text/csv_dialect.hpp"
#include "recordings/text/time_stamp.hpp"

namespace railpem::recordings {
namespace {

/// "Sample rate (Hz)" → "samplerate", with the unit apart.
struct Key {
    std::string word;
    std::string unit;
};

struct Entry {
    Key key;
    std::string value;
};

Key key_of(std::string_view text) {
    const NameWithUnit parts = name_with_unit(std::string(text));
    Key key{.word = {}, .unit = parts.unit};
    for (const char c : parts.name) {
        if (c >= 'A' && c <= 'Z') key.word += static_cast<char>(c + 32);
        if (c >= 'a' && c <= 'z') key.word += c;
    }
    return key;
}

std::string without_marks(std::string_view line) {
    std::string text(line);
    text.erase(std::remove(text.begin(), text.end(), '"'), text.end());
    const std::size_t begin = text.find_first_not_of("#%/ \t*;");
    return begin == std::string::npos ? "" : text.substr(begin);
}

std::optional<Entry> entry_of(std::string_view line) {
    const std::string text = without_marks(line);
    const std::size_t at = text.find_first_of(":=;\t,");
    if (at == std::string::npos) return std::nullopt;
    std::string_view value = std::string_view(text).substr(at + 1);
    while (!value.empty() && std::string_view(" \t;,=:").find(value.front()) != std::string_view::npos)
        value.remove_prefix(1);
    while (!value.empty() && std::string_view(" \t;,").find(value.back()) != std::string_view::npos)
        value.remove_suffix(1);
    return Entry{key_of(std::string_view(text).substr(0, at)), std::string(value)};
}

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> known) {
    return std::find(known.begin(), known.end(), word) != known.end();
}

/// "500 Hz", "0,002 s", "1000": the number, with what stands behind it as its unit.
struct Measure {
    double value = 0.0;
    std::optional<KnownUnit> unit;
};

std::optional<Measure> measure_of(const Entry& entry) {
    const std::size_t end = std::min(entry.value.find_first_not_of("0123456789.,+-eE"), entry.value.size());
    Measure measure;
    const std::string_view number = std::string_view(entry.value).substr(0, end);
    const bool comma = number.find(',') != std::string_view::npos && number.find('.') == std::string_view::npos;
    if (number.empty() || parse_field(number, {.decimal_comma = comma}, measure.value) == FieldKind::text ||
        !std::isfinite(measure.value))
        return std::nullopt;
    std::string_view unit = std::string_view(entry.value).substr(end);
    unit.remove_prefix(std::min(unit.find_first_not_of(" ;\t"), unit.size()));  // in a field of its own
    unit = unit.substr(0, unit.find_first_of(";,\t "));                         // the same for further channels
    measure.unit = known_unit(unit.empty() ? std::string_view(entry.key.unit) : unit);
    return measure;
}

/// Hz; 0 when the line says nothing of it.
double rate_of(const Entry& entry) {
    const std::string& word = entry.key.word;
    const bool is_rate = is_one_of(
        word, {"samplerate", "samplingrate", "samplingfrequency", "samplefrequency", "scanrate", "abtastrate",
               "abtastfrequenz", "messrate", "fs", "fshz", "samplespersecond", "sampleratehz", "samplingratehz",
               "samplingfrequencyhz", "datarate", "rate", "sps", "samplesperchannelpersecond"});
    const bool is_interval =
        is_one_of(word, {"sampleinterval", "samplinginterval", "sampletime", "timestep", "deltax", "deltat", "dt",
                         "dts", "timeincrement", "xincrement", "abtastintervall", "samplingperiod", "sampleperiod"});
    if (!is_rate && !is_interval) return 0.0;
    const std::optional<Measure> measure = measure_of(entry);
    if (!measure || !(measure->value > 0.0)) return 0.0;
    // A rate may be of anything: alone it needs the unit of one of samples.
    if (word == "rate" && !measure->unit) return 0.0;
    const Dimension wanted = is_rate ? Dimension::frequency : Dimension::time;
    if (measure->unit && measure->unit->dimension != wanted) return 0.0;
    const double value = measure->value * (measure->unit ? measure->unit->factor : 1.0);
    return is_rate ? value : std::round(1e6 / value) / 1e6;
}

void take(const Entry& entry, const NumberedLine& line, Preamble& preamble) {
    const std::string& word = entry.key.word;
    if (const double rate = rate_of(entry); rate > 0.0 && preamble.sampling_rate_hz == 0.0) {
        preamble.sampling_rate_hz = rate;
        preamble.sampling_rate_where = fmt::format("line {}", line.number);
    }
    if (is_one_of(word, {"unit", "units", "einheit", "einheiten", "yunitlabel", "yunit"}) && preamble.unit.empty()) {
        const std::string unit(trimmed(std::string_view(entry.value).substr(0, entry.value.find_first_of(";,\t"))));
        if (!known_unit(unit)) return;
        preamble.unit = unit;
        preamble.unit_where = fmt::format("line {}", line.number);
    }
    if (is_one_of(word, {"date", "datum", "time", "uhrzeit", "starttime", "start", "datetime", "recordingstart",
                         "measurementstart", "triggertime", "startdate", "starttimestamp"})) {
        const std::string value(trimmed(std::string_view(entry.value).substr(0, entry.value.find_first_of(";\t"))));
        const std::optional<TimeStamp> stamp = parse_time_stamp(value);
        if (!stamp) return;
        if (preamble.start.empty())
            preamble.start = value;
        else if (!stamp->has_date && preamble.start.find(':') == std::string::npos)
            preamble.start += " " + value;  // the date stood in a line of its own
    }
}

}  // namespace

Preamble read_preamble(const std::vector<NumberedLine>& lines) {
    Preamble preamble;
    for (const NumberedLine& line : lines)
        if (const std::optional<Entry> entry = entry_of(line.text)) take(*entry, line, preamble);
    // A time of day alone is no start of a record that could be told.
    const std::optional<TimeStamp> stamp = parse_time_stamp(preamble.start.substr(0, 10));
    if (!stamp || !stamp->has_date) preamble.start.clear();
    return preamble;
}

}  // namespace railpem::recordings
