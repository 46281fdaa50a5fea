#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace railpem::recordings {

/// What the header of a RIFF or RF64 file says about its samples, against what is there.
struct WavHeader {
    std::uint64_t size_at = 0;          ///< offset of the field with the size of the data
    std::uint64_t data_at = 0;          ///< offset of the first sample
    std::uint64_t stated_bytes = 0;     ///< of samples, as the header says
    std::uint64_t held_bytes = 0;       ///< from the first sample to the end of the file
    std::uint32_t bytes_per_frame = 0;  ///< of one sample of all channels; 0: not said
    bool size_is_open = false;          ///< 0 or all ones where samples follow: the length was never written
    bool goes_on = false;               ///< behind the stated end stands no chunk, but more samples

    std::uint64_t frames(std::uint64_t bytes) const { return bytes_per_frame > 0 ? bytes / bytes_per_frame : 0; }
};

/// Walks the chunks of the file up to its data. Empty for what is neither RIFF nor RF64, or has no data chunk.
std::optional<WavHeader> read_wav_header(const std::string& file);

}  // namespace railpem::recordings
