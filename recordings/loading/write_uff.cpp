#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstdint>
#include <fstream>

#include "recordings/files/read_error.hpp"
#include "recordings/files/uff.hpp"

namespace railpem::recordings {
namespace {

void append_little_endian(std::string& out, double value) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (int i = 0; i < 8; ++i, bits >>= 8) out += static_cast<char>(bits & 0xFF);
}

/// "E" format of Fortran with a mantissa of one digit before the point, as every reader takes it.
std::string exponent_number(double value, int width, int digits) {
    return fmt::format("{:>{}.{}E}", value, width, digits);
}

std::string axis(int kind, const std::string& unit) {
    return fmt::format("{:10d}{:5d}{:5d}{:5d} {:<20.20} {:<20.20}\n", kind, 0, 0, 0, "NONE",
                       unit.empty() ? "NONE" : unit);
}

std::string records(const UffDataset& dataset) {
    std::string out;
    for (const std::string& id : dataset.id) out += fmt::format("{:<80.80}\n", id.empty() ? "NONE" : id);
    out += fmt::format("{:5d}{:10d}{:5d}{:10d} {:<10.10}{:10d}{:4d} {:<10.10}{:10d}{:4d}\n", dataset.function_type, 0,
                       0, 0, dataset.response_entity.empty() ? "NONE" : dataset.response_entity, dataset.response_node,
                       dataset.response_direction, dataset.reference_entity.empty() ? "NONE" : dataset.reference_entity,
                       dataset.reference_node, dataset.reference_direction);
    out += fmt::format("{:10d}{:10d}{:10d}{}{}{}\n", dataset.complex ? 6 : 4, dataset.size(),
                       dataset.abscissa.empty() ? 1 : 0, exponent_number(dataset.abscissa_start, 13, 5),
                       exponent_number(dataset.abscissa_step, 13, 5), exponent_number(0.0, 13, 5));
    out += axis(dataset.abscissa_kind, dataset.abscissa_unit) + axis(dataset.ordinate_kind, dataset.ordinate_unit) +
           axis(dataset.denominator_kind, dataset.denominator_unit);
    return out + axis(0, "");
}

/// Ordinates in the columns of the format: E20.12, four to a line (complex: two pairs; uneven: E13.5 before each
/// ordinate).
std::string text_data(const UffDataset& dataset) {
    std::string out;
    const bool even = dataset.abscissa.empty();
    const std::size_t points_per_line = dataset.complex ? (even ? 2 : 1) : (even ? 4 : 2);
    for (std::size_t i = 0; i < dataset.size(); ++i) {
        if (!even) out += exponent_number(dataset.abscissa[i], 13, 5);
        out += exponent_number(dataset.real[i], 20, 12);
        if (dataset.complex) out += exponent_number(dataset.imaginary[i], 20, 12);
        if ((i + 1) % points_per_line == 0 || i + 1 == dataset.size()) out += '\n';
    }
    return out;
}

std::string binary_data(const UffDataset& dataset) {
    std::string out;
    for (std::size_t i = 0; i < dataset.size(); ++i) {
        if (!dataset.abscissa.empty()) {
            auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(dataset.abscissa[i]));
            for (int k = 0; k < 4; ++k, bits >>= 8) out += static_cast<char>(bits & 0xFF);
        }
        append_little_endian(out, dataset.real[i]);
        if (dataset.complex) append_little_endian(out, dataset.imaginary[i]);
    }
    return out;
}

}  // namespace

void write_uff(const std::string& file, const std::vector<UffDataset>& datasets, bool binary) {
    std::ofstream out(file, std::ios::binary);
    for (const UffDataset& dataset : datasets) {
        assert(!dataset.complex || dataset.imaginary.size() == dataset.real.size());
        assert(dataset.abscissa.empty() || dataset.abscissa.size() == dataset.real.size());
        const std::string data = binary ? binary_data(dataset) : text_data(dataset);
        const std::string kind = binary ? fmt::format("{:6d}b{:6d}{:6d}{:12d}{:12d}{:6d}{:6d}{:12d}{:12d}", 58, 1, 2,
                                                      11, data.size(), 0, 0, 0, 0)
                                        : fmt::format("{:6d}", 58);
        out << "    -1\n" << kind << '\n' << records(dataset) << data << (binary ? "\n" : "") << "    -1\n";
    }
    if (!out.flush()) throw ReadError(file, 0, "cannot be written", "a place where a file can be written");
}

}  // namespace railpem::recordings
