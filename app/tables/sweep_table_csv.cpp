#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "app/number_table.hpp"
#include "app/output_folder.hpp"
#include "app/tables/sweep_table.hpp"

namespace railpem::app {

namespace {

void append_number(std::string& text, double value) {
    if (!std::isfinite(value)) return;  // an empty field
    char buffer[32];
    text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, kDigits).ptr);
}

/// What stands behind the varied values in every case: speed, quantity, response, frequency.
std::vector<std::string> row_labels(const pem::SweepPlan& plan) {
    const bool speeds = plan.base.running.speeds_m_per_s.size() > 1;
    std::vector<std::string> labels;
    for (const pem::SweepRow& row : pem::sweep_rows(plan)) {
        std::string label = ",";
        if (speeds) {
            append_number(label, row.speed_m_per_s);
            label += ',';
        }
        label += row.quantity + "," + row.response + ",";
        append_number(label, row.frequency_hz);
        labels.push_back(label + ",");
    }
    return labels;
}

std::string case_label(const pem::SweepPlan& plan, std::size_t index) {
    std::string label = fmt::format("{}", index + 1);
    for (const double value : pem::sweep_values(plan, index)) {
        label += ',';
        append_number(label, value);
    }
    return label;
}

std::string header(const pem::SweepPlan& plan) {
    std::string text = "case";
    for (const pem::SweepAxis& axis : plan.axes) text += "," + axis.key;
    if (plan.base.running.speeds_m_per_s.size() > 1) text += ",speed_m_per_s";
    return text + ",quantity,response,frequency_hz,value\n";
}

/// A file that says when not all of it arrives.
class TableFile {
  public:
    explicit TableFile(const std::filesystem::path& path) : path_(path), file_(std::fopen(path.c_str(), "wb")) {
        if (!file_) fail();
    }
    TableFile(const TableFile&) = delete;
    TableFile& operator=(const TableFile&) = delete;
    ~TableFile() {
        if (file_) std::fclose(file_);
    }
    void write(const std::string& text) {
        if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail();
    }
    void finish() {
        std::FILE* file = file_;
        file_ = nullptr;
        if (std::fclose(file) != 0) fail();
    }

  private:
    [[noreturn]] void fail() const { throw OutputError(fmt::format("{}: {}", path_.string(), std::strerror(errno))); }
    std::filesystem::path path_;
    std::FILE* file_ = nullptr;
};

}  // namespace

double sweep_csv_bytes(const pem::SweepPlan& plan) {
    double bytes = 0.0;
    const double label = static_cast<double>(case_label(plan, 0).size());
    for (const std::string& row : row_labels(plan)) bytes += label + static_cast<double>(row.size()) + 15.0;
    return bytes * static_cast<double>(pem::sweep_size(plan));
}

void write_sweep_csv(const std::filesystem::path& file, const pem::SweepPlan& plan, const SweepValues& values,
                     const std::string& stamp) {
    const std::vector<std::string> rows = row_labels(plan);
    const std::size_t cases = pem::sweep_size(plan);
    TableFile output(file);
    output.write(header(plan));
    for (std::size_t first = 0; first < cases; first += kCasesPerBlock) {
        const std::size_t count = std::min(kCasesPerBlock, cases - first);
        const std::vector<double> block = values(first, count);
        for (std::size_t i = 0; i < count; ++i) {
            const std::string label = case_label(plan, first + i);
            std::string text;
            for (std::size_t row = 0; row < rows.size(); ++row) {
                text += label;
                text += rows[row];
                append_number(text, block[i * rows.size() + row]);
                text += '\n';
            }
            output.write(text);
        }
    }
    output.write(stamp);
    output.finish();
}

}  // namespace railpem::app
