#include "track/pads/pad_scale.hpp"

namespace railpem::track {

namespace {

/// SplitMix64 (Steele, Lea & Flood 2014): a bijection of 64 bits whose output passes tests of randomness on counters.
std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ULL;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

/// Uniform in [0, 1), one number per seed and seat.
double uniform(int seed, std::int64_t seat) {
    const std::uint64_t bits = mix(mix(static_cast<std::uint64_t>(seed)) ^ static_cast<std::uint64_t>(seat));
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace

double pad_scale(const FailedFasteners& failed, std::int64_t seat) {
    const bool regular = failed.every > 0 && (seat - failed.first_seat) % failed.every == 0;
    const bool drawn = failed.fraction > 0.0 && uniform(failed.seed, seat) < failed.fraction;
    return regular || drawn ? failed.remaining_stiffness_fraction : 1.0;
}

double pad_scale(const TrackParameters& track, std::int64_t seat) {
    return track.failed_fasteners.empty() ? 1.0 : pad_scale(track.failed_fasteners.front(), seat);
}

double mean_pad_scale(const TrackParameters& track) {
    if (track.failed_fasteners.empty()) return 1.0;
    const FailedFasteners& failed = track.failed_fasteners.front();
    const double regular = failed.every > 0 ? 1.0 / failed.every : 0.0;
    const double share = regular + (1.0 - regular) * failed.fraction;  // the draw does not know the regular ones
    return 1.0 - share * (1.0 - failed.remaining_stiffness_fraction);
}

}  // namespace railpem::track
