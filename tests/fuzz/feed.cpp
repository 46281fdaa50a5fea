#include "feed.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "app/input_error.hpp"
#include "app/schema/case_file.hpp"
#include "app/schema/recording_schema.hpp"
#include "app/schema/sweep_schema.hpp"
#include "parameters/parameter_error.hpp"
#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/read_unprotected.hpp"
#include "recordings/files/uff.hpp"
#include "recordings/loading/load_tables.hpp"
#include "recordings/measured_irregularity.hpp"
#include "recordings/text/read_csv.hpp"

namespace railpem::fuzz {
namespace {

using namespace recordings;

/// Small, so that a file that asks for too much is refused at once.
const ReadLimits limits{
    .memory_bytes = std::size_t{16} << 20, .line_bytes = std::size_t{1} << 14, .columns = 512, .seconds = 20.0};

/// A file with these bytes. In memory only where the reader does not mind: HDF5 asks for the real name of what it opens
/// and refuses a file that has none.
class InputFile {
  public:
    InputFile(std::span<const char> bytes, bool named) {
        std::string pattern = (std::filesystem::temp_directory_path() / "railpem_input_XXXXXX").string();
        descriptor_ = named ? mkstemp(pattern.data()) : memfd_create("input", 0);
        if (descriptor_ < 0 || write(descriptor_, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()))
            throw std::runtime_error("no file for the input");
        path_ = named ? pattern : "/proc/self/fd/" + std::to_string(descriptor_);
        named_ = named;
    }
    ~InputFile() {
        if (named_) unlink(path_.c_str());
        close(descriptor_);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    const std::string& path() const { return path_; }

  private:
    int descriptor_ = -1;
    bool named_ = false;
    std::string path_;
};

void read_sections(const std::string& file) {
    CsvReader reader(file, limits);
    std::vector<std::vector<double>> columns(reader.names().size());
    while (reader.read(64, columns) > 0)
        for (auto& column : columns) column.clear();
}

void read_points(const std::string& file) {
    Recording recording;
    recording.file = file;
    recording.description.kind = RecordingKind::points;
    recording.description.channels = {{.name = "a"}};
    load_points(recording, limits);
}

using ReadUnprotected = void (*)(const std::string&, const std::vector<std::string>&, std::size_t, const ReadLimits&,
                                 const SendTable&);

struct Reader {
    std::string kind;
    std::function<void(const std::string& file, Libraries libraries)> read;
};

/// In blocks, as long files are read.
Reader library_reader(const std::string& kind, ReadBlocks in_child, ReadUnprotected unprotected) {
    constexpr std::size_t rows = 64;
    return {kind, [=](const std::string& file, Libraries libraries) {
                if (libraries == Libraries::in_child)
                    in_child(file, {}, rows, limits, [](DataTable&) {});
                else
                    unprotected(file, {}, rows, limits, [](const DataTable&) {});
            }};
}

Reader own_reader(const std::string& kind, const std::function<void(const std::string& file)>& read) {
    return {kind, [=](const std::string& file, Libraries) { read(file); }};
}

const std::vector<Reader>& readers() {
    static const std::vector<Reader> all = {
        own_reader("csv", read_sections),
        own_reader("text", read_points),
        own_reader("irregularity", [](const std::string& file) { read_irregularity(file, limits); }),
        own_reader("uff", [](const std::string& file) { read_uff(file, limits); }),
        library_reader("mat", read_mat_blocks, read_mat_unprotected),
        library_reader("hdf5", read_hdf5_blocks, read_hdf5_unprotected),
        library_reader("wav", read_wav_blocks, read_wav_unprotected),
        own_reader("recording", [](const std::string& file) { app::read_recording(file); }),
        own_reader("case", [](const std::string& file) { app::read_case(file, {}); }),
        own_reader("sweep", [](const std::string& file) { app::read_sweep(file, {}); }),
    };
    return all;
}

[[noreturn]] void without_reason(const std::string& message) {
    throw std::logic_error("refused without a reason: '" + message + "'");
}

}  // namespace

const std::vector<std::string>& input_kinds() {
    static const std::vector<std::string> kinds = [] {
        std::vector<std::string> names;
        for (const Reader& reader : readers()) names.push_back(reader.kind);
        return names;
    }();
    return kinds;
}

bool feed(std::string_view kind, std::span<const char> bytes, Libraries libraries) {
    const auto reader =
        std::find_if(readers().begin(), readers().end(), [&](const Reader& r) { return r.kind == kind; });
    if (reader == readers().end()) throw std::invalid_argument("no reader of this kind");
    const InputFile file(bytes, kind == "hdf5");
    try {
        reader->read(file.path(), libraries);
        return true;
    } catch (const ReadError& error) {
        if (error.problem().empty() || error.allowed().empty()) without_reason(error.what());
    } catch (const parameters::ParameterError& error) {
        if (error.problem().empty() || error.allowed().empty()) without_reason(error.what());
    } catch (const app::InputError& error) {
        if (std::string_view(error.what()).size() < 10) without_reason(error.what());
    }
    return false;
}

}  // namespace railpem::fuzz
