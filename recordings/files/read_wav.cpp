#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <memory>

#include "recordings/files/read_error.hpp"
#include "recordings/files/read_unprotected.hpp"
#include "recordings/files/send_blocks.hpp"

namespace railpem::recordings {
namespace {

struct CloseSound {
    void operator()(SNDFILE* sound) const { sf_close(sound); }
};

bool is_wave(int format) {
    const int kind = format & SF_FORMAT_TYPEMASK;
    return kind == SF_FORMAT_WAV || kind == SF_FORMAT_WAVEX || kind == SF_FORMAT_RF64 || kind == SF_FORMAT_W64;
}

}  // namespace

void read_wav_unprotected(const std::string& file, const std::vector<std::string>& wanted, std::size_t rows,
                          const ReadLimits& limits, const SendTable& send) {
    SF_INFO info{};
    const std::unique_ptr<SNDFILE, CloseSound> sound(sf_open(file.c_str(), SFM_READ, &info));
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
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= channels; ++i) names.push_back(std::to_string(i));
    std::vector<std::size_t> selected;
    for (const std::string& name : wanted.empty() ? names : wanted) {
        selected.push_back(require_name(name, names, "channel", file, 0));
        table.names.push_back(name);
    }
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
