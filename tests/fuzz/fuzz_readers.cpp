// Feeds arbitrary bytes to every reader. What a reader may do with them: return a table, or throw ReadError. Anything
// else ends the run. The first byte chooses the reader; RAILPEM_FUZZ_READER (csv, text, uff, mat, hdf5, wav) fixes it
// for the whole run.

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "parameters/parameter_error.hpp"
#include "recordings/load_tables.hpp"
#include "recordings/read_binary.hpp"
#include "recordings/read_csv.hpp"
#include "recordings/read_error.hpp"
#include "recordings/uff.hpp"

namespace {

using namespace railpem::recordings;

const ReadLimits limits{
    .memory_bytes = std::size_t{64} << 20, .line_bytes = std::size_t{1} << 16, .columns = 512, .seconds = 5.0};

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

int chosen_reader() {
    const char* name = std::getenv("RAILPEM_FUZZ_READER");
    const std::string names[] = {"csv", "text", "uff", "mat", "hdf5", "wav"};
    for (int i = 0; name && i < 6; ++i)
        if (names[i] == name) return i;
    return -1;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const int fixed = chosen_reader();
    int reader = fixed;
    if (reader < 0) {
        if (size == 0) return 0;
        reader = data[0] % 6;
        ++data;
        --size;
    }
    const int memory = memfd_create("fuzz", 0);
    if (write(memory, data, size) != static_cast<ssize_t>(size)) std::abort();
    const std::string file = "/proc/self/fd/" + std::to_string(memory);
    try {
        switch (reader) {
            case 0:
                read_sections(file);
                break;
            case 1:
                read_points(file);
                break;
            case 2:
                read_uff(file, limits);
                break;
            case 3:
                read_mat(file, {}, limits);
                break;
            case 4:
                read_hdf5(file, {}, limits);
                break;
            case 5:
                read_wav(file, {}, limits);
                break;
            default:
                break;
        }
    } catch (const ReadError&) {
    } catch (const railpem::parameters::ParameterError&) {
    }
    close(memory);
    return 0;
}
