#include "recordings/loading/write_csv.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>

#include "recordings/files/read_error.hpp"

namespace railpem::recordings {
namespace {

void append_number(std::string& out, double value) {
    if (std::isnan(value)) return;
    std::array<char, 32> text;
    const auto [stop, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    assert(error == std::errc());
    out.append(text.data(), stop);
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void write_csv(const std::string& file, const DataTable& table) {
    assert(table.names.size() == table.columns.size());
    const ReadError failed(file, 0, "cannot be written", "a place where a file can be written");
    std::unique_ptr<std::FILE, CloseFile> out(std::fopen(file.c_str(), "wb"));
    if (!out) throw failed;
    std::string text;
    const auto flush = [&] {
        if (std::fwrite(text.data(), 1, text.size(), out.get()) != text.size()) throw failed;
        text.clear();
    };
    for (std::size_t i = 0; i < table.names.size(); ++i) {
        const bool quote = table.names[i].find_first_of(",;\t\"") != std::string::npos;
        text += (i > 0 ? "," : "");
        text += quote ? '"' + table.names[i] + '"' : table.names[i];
    }
    text += '\n';
    for (std::size_t row = 0; row < table.rows(); ++row) {
        for (std::size_t i = 0; i < table.columns.size(); ++i) {
            if (i > 0) text += ',';
            append_number(text, table.columns[i][row]);
        }
        text += '\n';
        if (text.size() > (std::size_t{1} << 20)) flush();
    }
    flush();
    if (std::fflush(out.get()) != 0) throw failed;
}

DataTable to_table(const TimeSeries& series) {
    DataTable table;
    table.sampling_rate_hz = series.sampling_rate_hz;
    table.names.emplace_back("time_s");
    table.columns.emplace_back();
    for (std::size_t i = 0; i < series.size(); ++i)
        table.columns[0].push_back(series.start_s + static_cast<double>(i) / series.sampling_rate_hz);
    for (const Channel& channel : series.channels) {
        table.names.push_back(channel.description.column.empty() ? channel.description.name
                                                                 : channel.description.column);
        table.columns.push_back(channel.samples);
    }
    return table;
}

}  // namespace railpem::recordings
