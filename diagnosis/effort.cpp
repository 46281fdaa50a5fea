#include "diagnosis/effort.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pem/linearise.hpp"

namespace railpem::diagnosis {

namespace {

// Processor time of threads in five diagnoses of three recordings of a minute on the EPYC of docs/speed.md, a mean by kind of prediction, s; and what a whole diagnosis takes beyond them.
constexpr double kBeyond = 1.1;
constexpr double kFromNothing = kBeyond * 13.3e-6, kWithRail = kBeyond * 8e-6, kWithTransfers = kBeyond * 5.5e-6;  // per bin
constexpr double kFailed = kBeyond * 8e-3, kLoaded = kBeyond * 12e-3, kNonlinear = kBeyond * 4e-3;  // beside it: seats of their own, pads that the wheels load, equivalent dampers
constexpr double kDampers = kBeyond * 20e-6;  // per bin: what hangs on the rail is sharp
constexpr double kBin = kBeyond * 6e-6, kBinAndUnknown = kBeyond * 0.2e-6;
constexpr double kThree_hz = 480.0;  // bands of three such recordings at 15 to 33 m/s

}  // namespace

double effort_of_prediction(const pem::CaseParameters& parameters, std::size_t bins, Reuse reuse) {
    const double count = static_cast<double>(bins);
    if (reuse >= Reuse::motion) return kWithTransfers * count;
    double sum = (reuse == Reuse::rail ? kWithRail : kFromNothing) * count;
    if (pem::is_nonlinear(parameters)) sum += kNonlinear;
    if (reuse == Reuse::rail) return sum;
    const track::TrackParameters& track = parameters.track;
    if (!track.failed_fasteners.empty()) sum += kFailed;
    if (track.pads.preload_strength > 0.0) sum += kLoaded;
    if (!track.rail_dampers.empty()) sum += kDampers * count;
    return sum;
}

double effort_of_likelihood(std::size_t bins, std::size_t unknowns) { return static_cast<double>(bins) * (kBin + kBinAndUnknown * static_cast<double>(unknowns)); }

double effort_allowed(const std::vector<Observation>& observations, double for_three) {
    double bands_hz = 0.0;  // the same however long the segments are
    for (const Observation& own : observations) bands_hz += own.scalar ? 0.0 : static_cast<double>(own.bins()) * own.kernel.bin_hz();
    return for_three * std::max(1.0, bands_hz / kThree_hz);
}

NotTested left_out_for_effort(const std::string& what, const Effort& spent, double allowed_s) {
    return {what, fmt::format("left out, the effort was at {:.0f} s when the search ended ({:.0f} s are allowed, of one core as the program counts; --effort allows more)", spent.seconds(), allowed_s)};
}

}  // namespace railpem::diagnosis
