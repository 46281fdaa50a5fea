#include <fmt/format.h>
#include <hdf5.h>

#include <array>
#include <fstream>

#include "recordings/files/read_error.hpp"
#include "recordings/files/read_unprotected.hpp"
#include "recordings/files/send_blocks.hpp"
#include "recordings/matlab/mat_file.hpp"
#include "recordings/matlab/mat_path.hpp"

namespace railpem::recordings {
namespace {

std::unique_ptr<MatFile> open_mat(const std::string& file) {
    H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);
    if (H5Fis_hdf5(file.c_str()) > 0) return open_mat73(file);
    std::array<char, 128> header{};
    std::ifstream(file, std::ios::binary).read(header.data(), header.size());
    const std::string_view mark(header.data() + 126, 2), title(header.data(), 10);
    if (mark == "MI" || mark == "IM") return open_mat5(file);
    if (title.starts_with("MATLAB"))
        throw ReadError(file, 0, "the file is truncated: it ends within its header", "a complete .mat file");
    return open_mat4(file);
}

}  // namespace

void read_mat_unprotected(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                          const ReadLimits& limits, const SendTable& send) {
    const std::unique_ptr<MatFile> mat = open_mat(file);
    if (mat->variables().empty())
        throw ReadError(file, 0, "the file holds no variable", "real numeric vectors or matrices");
    DataTable table;
    table.names = wanted.empty() ? mat_channel_paths(mat->variables()) : wanted;
    std::vector<MatColumn> channels;
    for (const std::string& name : table.names) {
        channels.push_back(find_mat_column(mat->variables(), name, file, table.notes));
        if (channels.back().count != channels.front().count)
            throw ReadError(file, 0,
                            fmt::format("'{}' has {} samples and '{}' has {}", table.names.front(),
                                        channels.front().count, name, channels.back().count),
                            "channels of one length");
    }
    if (channels.empty()) throw ReadError(file, 0, "the file holds no real matrix", "real numeric vectors or matrices");
    send_blocks(table, channels.front().count, rows, limits, file, send,
                [&](std::size_t begin, std::size_t count) { mat->read(channels, begin, count, table.columns); });
}

}  // namespace railpem::recordings
