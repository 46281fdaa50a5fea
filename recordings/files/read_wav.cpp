#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

#include "recordings/files/read_error.hpp"
#include "recordings/files/read_unprotected.hpp"
#include "recordings/files/send_blocks.hpp"
#include "recordings/files/wav_header.hpp"

namespace railpem::recordings {
namespace {

struct CloseSound {
    void operator()(SNDFILE* sound) const { sf_close(sound); }
};

struct CloseStream {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

/// The file as it would be with its length written: what a recorder that lost power did not come to.
struct CompletedFile {
    std::unique_ptr<std::FILE, CloseStream> file;
    std::uint64_t size_at = 0;
    std::uint32_t size = 0;

    static CompletedFile& of(void* self) { return *static_cast<CompletedFile*>(self); }

    static sf_count_t length(void* self) {
        std::FILE* file = of(self).file.get();
        const off_t at = ftello(file);
        fseeko(file, 0, SEEK_END);
        const off_t end = ftello(file);
        fseeko(file, at, SEEK_SET);
        return end;
    }
    static sf_count_t seek(sf_count_t offset, int whence, void* self) {
        fseeko(of(self).file.get(), offset, whence);
        return ftello(of(self).file.get());
    }
    static sf_count_t tell(void* self) { return ftello(of(self).file.get()); }
    static sf_count_t read(void* to, sf_count_t count, void* self) {
        CompletedFile& own = of(self);
        const auto at = static_cast<std::uint64_t>(ftello(own.file.get()));
        const std::size_t got = std::fread(to, 1, static_cast<std::size_t>(count), own.file.get());
        for (std::uint64_t i = 0; i < 4; ++i)
            if (own.size_at + i >= at && own.size_at + i < at + got)
                static_cast<unsigned char*>(to)[own.size_at + i - at] = static_cast<unsigned char>(own.size >> (8 * i));
        return static_cast<sf_count_t>(got);
    }
};

using Sound = std::unique_ptr<SNDFILE, CloseSound>;

/// Opens the file; one whose length was never written as if it ended with its last sample.
Sound open_sound(const std::string& file, const std::optional<WavHeader>& header, CompletedFile& completed,
                 SF_INFO& info) {
    if (!header || !header->size_is_open) return Sound(sf_open(file.c_str(), SFM_READ, &info));
    completed.file.reset(std::fopen(file.c_str(), "rb"));
    if (!completed.file) return nullptr;
    completed.size_at = header->size_at;
    constexpr std::uint64_t most = 0xFFFFFFFEU;
    const std::uint64_t frame = std::max<std::uint64_t>(1, header->bytes_per_frame);
    completed.size = static_cast<std::uint32_t>(std::min(most, header->held_bytes) / frame * frame);
    SF_VIRTUAL_IO calls{CompletedFile::length, CompletedFile::seek, CompletedFile::read, nullptr, CompletedFile::tell};
    return Sound(sf_open_virtual(&calls, SFM_READ, &info, &completed));
}

bool is_wave(int format) {
    const int kind = format & SF_FORMAT_TYPEMASK;
    return kind == SF_FORMAT_WAV || kind == SF_FORMAT_WAVEX || kind == SF_FORMAT_RF64 || kind == SF_FORMAT_W64;
}

/// Integers of any width and their companded forms: what full scale is worth, the file does not say.
bool is_share_of_full_scale(int format) {
    const int coding = format & SF_FORMAT_SUBMASK;
    return coding != SF_FORMAT_FLOAT && coding != SF_FORMAT_DOUBLE;
}

/// What the header says of scale, length and start, and what is seen to be wrong with it.
void state(SNDFILE* sound, const SF_INFO& info, const std::optional<WavHeader>& header, DataTable& table) {
    table.says.sampling_rate_where = "header of the WAV file";
    table.says.columns.assign(table.names.size(), {});
    for (ColumnStatement& column : table.says.columns) column.share_of_full_scale = is_share_of_full_scale(info.format);
    SF_BROADCAST_INFO broadcast{};
    if (sf_command(sound, SFC_GET_BROADCAST_INFO, &broadcast, sizeof broadcast) == SF_TRUE) {
        const auto text = [](const auto& field) { return std::string(field, strnlen(field, sizeof field)); };
        table.says.start = text(broadcast.origination_date) + " " + text(broadcast.origination_time);
        if (table.says.start.size() < 12) table.says.start.clear();
    }
    if (!header) return;
    if (header->size_is_open)
        table.notes.push_back(
            fmt::format("the header of the WAV file says no length, as after a loss of power: all {} samples up to its "
                        "end were read",
                        info.frames));
    else
        table.says.promised_rows = header->frames(header->stated_bytes);
    if (header->goes_on)
        table.notes.push_back(
            fmt::format("the header of the WAV file says {} samples, {} are there: those beyond were "
                        "not read",
                        header->frames(header->stated_bytes), header->frames(header->held_bytes)));
}

std::vector<std::size_t> select_channels(const std::string& file, const std::vector<std::string>& wanted,
                                         std::size_t channels, DataTable& table) {
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= channels; ++i) names.push_back(std::to_string(i));
    std::vector<std::size_t> selected;
    for (const std::string& name : wanted.empty() ? names : wanted) {
        selected.push_back(require_name(name, names, "channel", file, 0));
        table.names.push_back(name);
    }
    return selected;
}

}  // namespace

void read_wav_unprotected(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                          const ReadLimits& limits, const SendTable& send) {
    SF_INFO info{};
    const std::optional<WavHeader> header = read_wav_header(file);
    CompletedFile completed;
    const Sound sound = open_sound(file, header, completed, info);
    if (!sound)
        throw ReadError(file, 0, fmt::format("not a WAV file ({})", sf_strerror(nullptr)),
                        "RIFF, RF64 or W64 with PCM or floating-point samples");
    if (!is_wave(info.format))
        throw ReadError(file, 0, "a sound file, but not a WAV file",
                        "RIFF, RF64 or W64 with PCM or floating-point samples");
    if (info.channels < 1 || info.frames < 1 || info.samplerate < 1)
        throw ReadError(file, 0, "the file holds no sample", "at least one channel with samples");
    const auto channels = static_cast<std::size_t>(info.channels);
    const auto frames = static_cast<std::size_t>(info.frames);
    DataTable table;
    table.sampling_rate_hz = info.samplerate;
    const std::vector<std::size_t> selected = select_channels(file, wanted, channels, table);
    state(sound.get(), info, header, table);
    constexpr std::size_t frames_at_once = 16384;
    std::vector<double> block(channels * frames_at_once);
    send_blocks(table, frames, rows, limits, file, send, [&](std::size_t begin, std::size_t count) {
        for (std::size_t done = 0; done < count;) {
            const auto asked = static_cast<sf_count_t>(std::min(frames_at_once, count - done));
            const sf_count_t got = sf_readf_double(sound.get(), block.data(), asked);
            for (std::size_t i = 0; i < selected.size(); ++i)
                for (std::size_t k = 0; k < static_cast<std::size_t>(got); ++k)
                    table.columns[i].push_back(block[k * channels + selected[i]]);
            done += static_cast<std::size_t>(got);
            if (got < asked)
                throw ReadError(file, 0,
                                fmt::format("the file is truncated: {} of {} samples are there", begin + done, frames),
                                "a complete WAV file");
        }
    });
}

}  // namespace railpem::recordings
