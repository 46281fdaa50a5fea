#include "diagnosis/model/effort.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pem/coupling/linearise.hpp"

namespace railpem::diagnosis {

namespace {

// Processor time in two diagnoses of three recordings of a minute (both effects of the paper, seed 9601; an absorber on
// the axles, seed 9801), a mean by kind of prediction, s: on an Intel Xeon, divided by the 1.4 by which it took longer
// from nothing than the EPYC of docs/speed.md.
constexpr double kFromNothing = 14.6e-6, kWithTransfers = 4.6e-6, kWithBroadband = 0.4e-6;  // per bin
constexpr double kWithRail = 8.9e-6, kWithRailBlunt = 4.7e-6;  // without what equal seats pass on
// beside it: pads that the wheels load; what sleepers make of the forces over such pads
constexpr double kLoaded = 13e-3, kLoadedBlunt = 7e-3, kFedBack = 4.5e-3;
constexpr double kFailed = 7e-3, kNonlinear = 4.4e-3;  // seats of their own, equivalent dampers
constexpr double kDampers = 22e-6;                     // per bin: what hangs on the rail is sharp
constexpr double kBin = 7e-6, kBinAndUnknown = 0.26e-6;
constexpr double kThree_hz = 480.0;  // bands of three such recordings at 15 to 33 m/s

}  // namespace

double effort_of_prediction(const pem::CaseParameters& parameters, std::size_t bins, Reuse reuse, bool sharp) {
    const double count = static_cast<double>(bins);
    if (reuse >= Reuse::motion) return (reuse == Reuse::broadband ? kWithBroadband : kWithTransfers) * count;
    const track::TrackParameters& track = parameters.track;
    const bool loaded = track.pads.preload_strength > 0.0;
    double sum = pem::is_nonlinear(parameters) ? kNonlinear : 0.0;
    if (loaded && sharp) sum += kFedBack;
    if (reuse == Reuse::rail) return sum + (sharp ? kWithRail : kWithRailBlunt) * count;
    if (!track.failed_fasteners.empty()) sum += kFailed;
    if (loaded) sum += sharp ? kLoaded : kLoadedBlunt;
    if (!track.rail_dampers.empty()) sum += kDampers * count;
    return sum + kFromNothing * count;
}

double effort_of_likelihood(std::size_t bins, std::size_t unknowns) {
    return static_cast<double>(bins) * (kBin + kBinAndUnknown * static_cast<double>(unknowns));
}

double effort_allowed(const std::vector<Observation>& observations, double for_three) {
    double bands_hz = 0.0;  // the same however long the segments are
    for (const Observation& own : observations)
        bands_hz += own.scalar ? 0.0 : static_cast<double>(own.bins()) * own.kernel.bin_hz();
    return for_three * std::max(1.0, bands_hz / kThree_hz);
}

NotTested left_out_for_effort(const std::string& what, const Effort& spent, double allowed_s) {
    return {what, fmt::format("left out, the effort was at {:.0f} s when the search ended ({:.0f} s are allowed, of "
                              "one core as the program counts; --effort allows more)",
                              spent.seconds(), allowed_s)};
}

}  // namespace railpem::diagnosis
