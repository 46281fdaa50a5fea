#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <functional>

#include "app/output_folder.hpp"
#include "app/tables/hdf5_handle.hpp"
#include "app/tables/sweep_table.hpp"

namespace railpem::app {

namespace {

constexpr hsize_t kChunk = 1u << 16;  ///< rows per chunk
constexpr unsigned kDeflate = 4;

constexpr const char* kNotWritten = "HDF5: the table cannot be written";

/// One column of `rows` values, filled block by block.
void write_column(hid_t file, const std::string& name, hid_t type, hsize_t rows, hsize_t block_rows,
                  const std::function<const void*(std::size_t block, hsize_t count)>& fill) {
    const Hdf5Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose, kNotWritten);
    const Hdf5Handle options(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, kNotWritten);
    const hsize_t chunk = std::min(kChunk, rows);
    H5Pset_chunk(options.id, 1, &chunk);
    H5Pset_deflate(options.id, kDeflate);
    const Hdf5Handle set(H5Dcreate2(file, name.c_str(), type, space.id, H5P_DEFAULT, options.id, H5P_DEFAULT), H5Dclose,
                         kNotWritten);
    for (hsize_t first = 0, block = 0; first < rows; first += block_rows, ++block) {
        const hsize_t count = std::min(block_rows, rows - first);
        const Hdf5Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose, kNotWritten);
        H5Sselect_hyperslab(space.id, H5S_SELECT_SET, &first, nullptr, &count, nullptr);
        if (H5Dwrite(set.id, type, memory.id, space.id, H5P_DEFAULT, fill(static_cast<std::size_t>(block), count)) < 0)
            throw OutputError("HDF5: the table could not be written whole");
    }
}

/// Texts of the rows of one case, repeated for every case.
void write_texts(hid_t file, const std::string& name, const std::vector<std::string>& texts, hsize_t rows,
                 std::size_t cases_per_block) {
    std::size_t length = 1;
    for (const std::string& text : texts) length = std::max(length, text.size());
    const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, kNotWritten);
    H5Tset_size(type.id, length);
    H5Tset_strpad(type.id, H5T_STR_NULLPAD);
    std::string block;
    for (std::size_t i = 0; i < cases_per_block; ++i)
        for (const std::string& text : texts) block += text + std::string(length - text.size(), '\0');
    write_column(file, name, type.id, rows, cases_per_block * texts.size(),
                 [&](std::size_t, hsize_t) { return block.data(); });
}

}  // namespace

void write_sweep_hdf5(const std::filesystem::path& path, const pem::SweepPlan& plan, const SweepValues& values,
                      const std::string& stamp) {
    const std::vector<pem::SweepRow> rows = pem::sweep_rows(plan);
    const std::size_t per_case = rows.size(), cases = pem::sweep_size(plan);
    const hsize_t total = cases * per_case, block_rows = kCasesPerBlock * per_case;
    {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are reported as exceptions
        const Hdf5Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, kNotWritten);
        if (!stamp.empty()) write_hdf5_stamp(file.id, stamp, kNotWritten);
        std::vector<double> column;
        const auto per_row = [&](const std::string& name,
                                 const std::function<double(std::size_t index, std::size_t row)>& value) {
            write_column(file.id, name, H5T_NATIVE_DOUBLE, total, block_rows,
                         [&](std::size_t block, hsize_t count) -> const void* {
                             column.resize(count);
                             for (std::size_t i = 0; i < count; ++i)
                                 column[i] = value(block * kCasesPerBlock + i / per_case, i % per_case);
                             return column.data();
                         });
        };
        per_row("case", [](std::size_t index, std::size_t) { return static_cast<double>(index + 1); });
        for (std::size_t axis = 0; axis < plan.axes.size(); ++axis)
            per_row(plan.axes[axis].key,
                    [&](std::size_t index, std::size_t) { return pem::sweep_values(plan, index)[axis]; });
        if (plan.base.running.speeds_m_per_s.size() > 1)
            per_row("speed_m_per_s", [&](std::size_t, std::size_t row) { return rows[row].speed_m_per_s; });
        std::vector<std::string> quantities, responses;
        for (const pem::SweepRow& row : rows) {
            quantities.push_back(row.quantity);
            responses.push_back(row.response);
        }
        write_texts(file.id, "quantity", quantities, total, kCasesPerBlock);
        write_texts(file.id, "response", responses, total, kCasesPerBlock);
        per_row("frequency_hz", [&](std::size_t, std::size_t row) { return rows[row].frequency_hz; });
        write_column(file.id, "value", H5T_NATIVE_DOUBLE, total, block_rows,
                     [&](std::size_t block, hsize_t count) -> const void* {
                         column = values(block * kCasesPerBlock, count / per_case);
                         return column.data();
                     });
    }
}

}  // namespace railpem::app
