#include <fmt/format.h>
#include <sndfile.h>

#include <memory>

#include "recordings/files/isolated_read.hpp"
#include "recordings/files/read_binary.hpp"
#include "recordings/files/read_error.hpp"
#include "recordings/files/read_unprotected.hpp"

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

DataTable read_wav_unprotected(const std::string& file, const std::vector<std::string>& wanted,
                               const ReadLimits& limits) {
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
    if (frames > limits.memory_bytes / sizeof(double) / selected.size())
        throw ReadError(file, 0, fmt::format("{} channels of {} samples", selected.size(), frames),
                        fmt::format("at most {} MB of numbers", limits.memory_bytes >> 20));
    table.columns.resize(selected.size());
    constexpr sf_count_t frames_at_once = 16384;
    std::vector<double> block(channels * frames_at_once);
    std::size_t done = 0;
    for (sf_count_t got = 0; (got = sf_readf_double(sound.get(), block.data(), frames_at_once)) > 0;
         done += static_cast<std::size_t>(got))
        for (std::size_t i = 0; i < selected.size(); ++i)
            for (std::size_t k = 0; k < static_cast<std::size_t>(got); ++k)
                table.columns[i].push_back(block[k * channels + selected[i]]);
    if (done != frames)
        throw ReadError(file, 0, fmt::format("the file is truncated: {} of {} samples are there", done, frames),
                        "a complete WAV file");
    return table;
}

DataTable read_wav(const std::string& file, const std::vector<std::string>& wanted, const ReadLimits& limits) {
    return read_isolated(file, limits, [&] { return read_wav_unprotected(file, wanted, limits); });
}

}  // namespace railpem::recordings
