// libFuzzer's entry: the first byte of an input chooses the reader, or RAILPEM_FUZZ_KIND does for the whole run.

#include <cstdint>
#include <cstdlib>
#include <string>

#include "feed.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const char* const fixed = std::getenv("RAILPEM_FUZZ_KIND");
    const auto& kinds = railpem::fuzz::input_kinds();
    std::string kind = fixed ? fixed : "";
    if (!fixed) {
        if (size == 0) return 0;
        kind = kinds[data[0] % kinds.size()];
        ++data;
        --size;
    }
    railpem::fuzz::feed(kind, {reinterpret_cast<const char*>(data), size}, railpem::fuzz::Libraries::in_this_process);
    return 0;
}
