#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/checks/checks.hpp"

namespace railpem::recordings::checks {
namespace {

Fault about(FaultKind kind, std::vector<std::string> channels, std::string says, double value, double p) {
    Fault found;
    found.kind = kind;
    found.severity = Severity::error;
    found.channels = std::move(channels);
    found.says = std::move(says);
    found.value = value;
    found.unit = "1";
    found.false_alarm = p;
    return found;
}

void check_duplicates(const Evidence& evidence, std::vector<Fault>& faults) {
    constexpr std::size_t kFewest = 100;  // of fewer samples any two agree
    const auto& x = evidence.detrended;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < i && x[i].size() >= kFewest; ++j) {
            double ii = 0.0, jj = 0.0, ij = 0.0;
            for (std::size_t n = 0; n < x[i].size(); ++n) {
                ii += x[i][n] * x[i][n];
                jj += x[j][n] * x[j][n];
                ij += x[i][n] * x[j][n];
            }
            if (ii <= 0.0 || jj <= 0.0) continue;
            // Two sensors at two places never agree to a ten-thousandth of their power.
            const double left = 1.0 - ij * ij / (ii * jj);
            if (left < 1e-4)
                faults.push_back(
                    about(FaultKind::duplicated, {evidence.name(j), evidence.name(i)},
                          fmt::format("{} is {:.4g} × {} but for {:.1e} of its power: one sensor recorded twice",
                                      evidence.name(i), ij / jj, evidence.name(j), std::max(0.0, left)),
                          ij / jj, 0.0));
        }
}

/// Above 20 Hz every suspension makes the next mass quieter: wheel, bogie, body.
void check_roughness(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    constexpr double kNothing_db = -250.0;  // a channel that stands still is said to, and is no measure of others
    const auto level = [&](std::size_t channel) {
        double sum = 0.0;
        for (std::size_t k = 1; k < spectra.bins(); ++k)
            if (spectra.frequency_hz[k] >= 20.0 &&
                spectra.frequency_hz[k] <= std::min(100.0, 0.4 * spectra.sampling_rate_hz))
                sum += spectra.psd(k, channel);
        return 10.0 * std::log10(std::max(sum, 1e-300));
    };
    const auto rank = [](Location location) {
        return location == Location::body ? 1 : location == Location::bogie ? 2 : location == Location::wheel ? 3 : 0;
    };
    for (std::size_t i = 0; i < spectra.size(); ++i)
        for (std::size_t j = 0; j < spectra.size(); ++j) {
            const ChannelDescription &quiet = spectra.channels[i], &rough = spectra.channels[j];
            if (rank(quiet.location) == 0 || rank(quiet.location) >= rank(rough.location) ||
                quiet.quantity != ChannelQuantity::acceleration || rough.quantity != ChannelQuantity::acceleration)
                continue;
            if (quiet.scale == Scale::unknown || rough.scale == Scale::unknown) continue;
            const double difference = level(i) - level(j);
            if (difference < 6.0 || level(j) < kNothing_db) continue;
            // Said of the pair that differs most, not of every pair that the same swap disturbs.
            bool largest = true;
            for (std::size_t k = 0; k < spectra.size() && largest; ++k)
                if (rank(spectra.channels[k].location) == rank(rough.location)) largest = level(j) <= level(k);
            for (std::size_t k = 0; k < spectra.size() && largest; ++k)
                if (rank(spectra.channels[k].location) == rank(quiet.location)) largest = level(i) >= level(k);
            if (largest)
                faults.push_back(about(
                    FaultKind::swapped, {quiet.name, rough.name},
                    fmt::format(
                        "{} is {:.0f} dB rougher than {} above 20 Hz: the channels are swapped, or a unit is wrong",
                        quiet.name, difference, rough.name),
                    difference, false_alarm));
        }
}

}  // namespace

void check_channels(const Evidence& evidence, std::vector<Fault>& faults) {
    check_duplicates(evidence, faults);
    if (evidence.spectra) check_roughness(evidence, faults);
}

}  // namespace railpem::recordings::checks
