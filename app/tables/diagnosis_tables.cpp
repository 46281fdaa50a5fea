#include "app/tables/diagnosis_tables.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <complex>
#include <set>

#include "app/number_table.hpp"

namespace railpem::app {
namespace {

using diagnosis::ChannelComparison;
using diagnosis::Diagnosis;

/// Rows of a CSV file; texts are quoted where they must be (RFC 4180).
class Rows {
  public:
    explicit Rows(const std::string& header) : text_(header + "\n") {}

    Rows& cell(const std::string& value) {
        separate();
        if (value.find_first_of(",\"\r\n") == std::string::npos) {
            text_ += value;
            return *this;
        }
        text_ += '"';
        for (const char c : value) text_ += c == '"' ? "\"\"" : std::string(1, c);
        text_ += '"';
        return *this;
    }

    Rows& cell(double value) {
        separate();
        if (!std::isfinite(value)) return *this;
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.begin(), digits.end(), value, std::chars_format::general, kDigits).ptr;
        text_.append(digits.begin(), end);
        return *this;
    }

    /// Nothing where the list is shorter: a law that the diagnosis does not have.
    Rows& cell(const std::vector<double>& values, std::size_t row) {
        return cell(row < values.size() ? values[row] : std::nan(""));
    }

    Rows& cell(const std::vector<std::complex<double>>& values, std::size_t row) {
        const bool there = row < values.size();
        return cell(there ? values[row].real() : std::nan("")).cell(there ? values[row].imag() : std::nan(""));
    }

    void end_row() {
        text_ += '\n';
        first_ = true;
    }

    const std::string& text() const { return text_; }

  private:
    void separate() {
        if (!first_) text_ += ',';
        first_ = false;
    }

    std::string text_;
    bool first_ = true;
};

/// Every name once, in order of appearance.
std::vector<std::string> recordings_of(const Diagnosis& diagnosis) {
    std::vector<std::string> names;
    for (const ChannelComparison& channel : diagnosis.channels)
        if (std::find(names.begin(), names.end(), channel.recording) == names.end()) names.push_back(channel.recording);
    return names;
}

std::string file_stem(const std::string& name, std::set<std::string>& taken) {
    std::string stem = name.empty() ? "recording" : name;
    for (char& c : stem)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_' && c != '.') c = '_';
    if (stem.front() == '.') stem.front() = '_';
    std::string unique = stem;
    for (int n = 2; !taken.insert(unique).second; ++n) unique = stem + "_" + std::to_string(n);
    return unique;
}

std::string spectra_csv(const Diagnosis& diagnosis, const std::string& recording) {
    std::string header = "frequency_hz,channel", quantity;
    for (const ChannelComparison& c : diagnosis.channels)
        if (c.recording == recording) quantity = c.quantity;  // the same for all channels of a recording
    for (const char* what : {"measured", "low", "high", "believed", "retuned", "diagnosed"})
        header += std::string(",") + what + "_" + quantity;
    Rows rows(header);
    for (const ChannelComparison& c : diagnosis.channels) {
        if (c.recording != recording) continue;
        for (std::size_t i = 0; i < c.frequency_hz.size(); ++i) {
            rows.cell(c.frequency_hz[i]).cell(c.channel).cell(c.measured, i).cell(c.low, i).cell(c.high, i);
            rows.cell(c.believed, i).cell(c.retuned, i).cell(c.diagnosed, i).end_row();
        }
    }
    return rows.text();
}

std::string bands_csv(const Diagnosis& diagnosis, const std::string& recording) {
    Rows rows(
        "centre_hz,channel,believed_level_difference_db,retuned_level_difference_db,diagnosed_level_difference_db");
    for (const ChannelComparison& c : diagnosis.channels) {
        if (c.recording != recording) continue;
        for (std::size_t i = 0; i < c.band_centre_hz.size(); ++i) {
            rows.cell(c.band_centre_hz[i]).cell(c.channel).cell(c.band_believed_db, i);
            rows.cell(c.band_retuned_db, i).cell(c.band_diagnosed_db, i).end_row();
        }
    }
    return rows.text();
}

std::string parameters_csv(const Diagnosis& diagnosis) {
    Rows rows("fit,key,unit,believed,value,low,high,relative_tolerance,tolerances_away,outside");
    const auto add = [&rows](const std::string& fit, const std::vector<diagnosis::RetunedNumber>& numbers) {
        for (const diagnosis::RetunedNumber& n : numbers) {
            rows.cell(fit).cell(n.key).cell(n.unit).cell(n.believed).cell(n.value).cell(n.low).cell(n.high);
            rows.cell(n.tolerance).cell(n.tolerances_away).cell(n.outside ? 1.0 : 0.0).end_row();
        }
    };
    add("retuned", diagnosis.retuned_numbers);
    add("diagnosed", diagnosis.numbers);
    return rows.text();
}

std::string curves_csv(const Diagnosis& diagnosis) {
    Rows rows(
        "element,unit,frequency_hz,real,imaginary,real_low,real_high,imaginary_low,imaginary_high,retuned_real,"
        "retuned_imaginary,diagnosed_real,diagnosed_imaginary");
    for (const diagnosis::InferredCurve& c : diagnosis.curves)
        for (std::size_t i = 0; i < c.frequency_hz.size(); ++i) {
            rows.cell(element_name(c.element)).cell(c.unit).cell(c.frequency_hz[i]).cell(c.value, i);
            rows.cell(c.real_low, i).cell(c.real_high, i).cell(c.imaginary_low, i).cell(c.imaginary_high, i);
            rows.cell(c.retuned, i).cell(c.diagnosed, i).end_row();
        }
    return rows.text();
}

}  // namespace

std::vector<TextFile> diagnosis_tables(const Diagnosis& diagnosis) {
    std::vector<TextFile> files;
    std::set<std::string> taken;
    for (const std::string& recording : recordings_of(diagnosis)) {
        const std::string stem = file_stem(recording, taken);
        files.push_back({stem + ".spectra.csv", spectra_csv(diagnosis, recording)});
        files.push_back({stem + ".bands.csv", bands_csv(diagnosis, recording)});
    }
    files.push_back({"parameters.csv", parameters_csv(diagnosis)});
    files.push_back({"curves.csv", curves_csv(diagnosis)});
    return files;
}

}  // namespace railpem::app
