#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recordings/checks/body_as_rigid.hpp"
#include "recordings/checks/checks.hpp"
#include "recordings/estimates/confidence.hpp"

namespace railpem::recordings::checks {
namespace {

Fault inverted(std::vector<std::string> channels, std::string says) {
    Fault found;
    found.kind = FaultKind::inverted;
    found.severity = Severity::error;
    found.channels = std::move(channels);
    found.says = std::move(says);
    found.value = -1.0;
    found.unit = "1";
    found.false_alarm = false_alarm;
    return found;
}

/// Channels whose sign disagrees with the others of a group. `signs`: +1 alike, −1 opposite, 0 not known, row by row.
void report_minority(const Evidence& evidence, const std::vector<std::size_t>& members,
                     const std::vector<std::vector<int>>& signs, std::vector<Fault>& faults) {
    std::vector<int> sign(members.size(), 0);
    sign[0] = 1;
    for (std::size_t pass = 0; pass < members.size(); ++pass)
        for (std::size_t i = 0; i < members.size(); ++i)
            for (std::size_t j = 0; j < members.size(); ++j)
                if (sign[i] != 0 && sign[j] == 0 && signs[i][j] != 0) sign[j] = sign[i] * signs[i][j];
    const auto minus = std::count(sign.begin(), sign.end(), -1), plus = std::count(sign.begin(), sign.end(), 1);
    if (minus == 0 || plus == 0) return;
    if (minus == plus) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < members.size(); ++i)
            if (sign[i] != 0) names.push_back(evidence.name(members[i]));
        faults.push_back(inverted(
            names, "half of these channels have the opposite sign of the other half: which half cannot be told"));
        return;
    }
    for (std::size_t i = 0; i < members.size(); ++i)
        if (sign[i] == (minus < plus ? -1 : 1))
            faults.push_back(
                inverted({evidence.name(members[i])},
                         "the sign is opposite to that of the other channels at such places: the sensor is "
                         "upside down or wired the wrong way"));
}

/// Signs by delayed copies (axle boxes, bogies) and by channels at one place (left and right of an axle).
void check_polarity_of_copies(const Evidence& evidence, std::vector<Fault>& faults) {
    for (const Location location : {Location::wheel, Location::bogie}) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < evidence.series().channels.size(); ++i)
            if (evidence.series().channels[i].description.location == location) members.push_back(i);
        if (members.size() < 2) continue;
        std::vector<std::vector<int>> signs(members.size(), std::vector<int>(members.size(), 0));
        const auto position = [&](std::size_t channel) {
            return static_cast<std::size_t>(std::find(members.begin(), members.end(), channel) - members.begin());
        };
        for (const PairDelay& pair : evidence.delays) {
            const std::size_t a = position(pair.front), b = position(pair.rear);
            if (a < members.size() && b < members.size()) signs[a][b] = signs[b][a] = pair.delay.inverted ? -1 : 1;
        }
        report_minority(evidence, members, signs, faults);
    }
}

/// Real part of a normalised cross-spectrum over a band, and whether it stands out.
struct BandSign {
    double real = 0.0, coherence = 0.0;
    bool significant = false;
};

BandSign band_sign(const std::vector<std::complex<double>>& cross, const std::vector<double>& a,
                   const std::vector<double>& b, double averages_per_bin) {
    // Every bin normalised, so that a resonance does not outvote the rest.
    std::complex<double> sum = 0.0;
    double count = 0.0;
    for (std::size_t k = 0; k < cross.size(); ++k) {
        if (a[k] <= 0.0 || b[k] <= 0.0) continue;
        sum += cross[k] / std::sqrt(a[k] * b[k]);
        count += 1.0;
    }
    BandSign result;
    if (count == 0.0) return result;
    result.real = sum.real() / count;
    result.coherence = std::norm(sum) / (count * count);
    result.significant = result.coherence > coherence_limit(std::max(2.0, averages_per_bin * count), false_alarm) &&
                         std::abs(result.real) > 0.5 * std::sqrt(result.coherence);
    return result;
}

/// A bogie frame follows the mean of its wheels below its own resonance.
void check_polarity_of_bogies(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    const auto find = [&](Location location, int index) {
        for (std::size_t i = 0; i < spectra.size(); ++i)
            if (spectra.channels[i].location == location && spectra.channels[i].index == index &&
                spectra.channels[i].quantity == ChannelQuantity::acceleration)
                return i;
        return spectra.size();
    };
    for (int bogie = 1; bogie <= 2; ++bogie) {
        const std::size_t b = find(Location::bogie, bogie), w1 = find(Location::wheel, 2 * bogie - 1),
                          w2 = find(Location::wheel, 2 * bogie);
        if (b == spectra.size() || w1 == spectra.size() || w2 == spectra.size()) continue;
        std::vector<std::complex<double>> cross;
        std::vector<double> bogie_power, wheel_power;
        for (std::size_t k = 1; k < spectra.bins() && spectra.frequency_hz[k] <= 3.0; ++k) {
            if (spectra.frequency_hz[k] < 0.7) continue;
            cross.push_back(0.5 * (spectra.at(k, b, w1) + spectra.at(k, b, w2)));
            bogie_power.push_back(spectra.psd(k, b));
            wheel_power.push_back(0.25 *
                                  (spectra.psd(k, w1) + spectra.psd(k, w2) + 2.0 * spectra.at(k, w1, w2).real()));
        }
        const BandSign sign = band_sign(cross, bogie_power, wheel_power, spectra.averages_per_bin);
        if (sign.significant && sign.real < 0.0)
            faults.push_back(inverted({spectra.channels[b].name},
                                      fmt::format("below 3 Hz it moves against the mean of axle boxes {} and {} "
                                                  "(correlation {:.2f}): bogie or both axle boxes are inverted",
                                                  2 * bogie - 1, 2 * bogie, sign.real)));
    }
}

/// A rigid body's centre moves with the mean of its ends: coefficients of the ends in the centre, both about 0.5.
void check_polarity_of_body(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    const auto body = body_channels(spectra);
    if (!body) return;
    const auto [front, centre, rear] = body->front_centre_rear;
    const auto fit = rigid_fit(spectra, centre, front, rear);
    // Otherwise it is not a rigid body, and nothing follows.
    if (!fit || fit->explained < 0.7 || std::min(std::abs(fit->a), std::abs(fit->b)) < 0.2) return;
    if (fit->a > 0.0 && fit->b > 0.0) return;
    const std::size_t culprit = fit->a < 0.0 && fit->b < 0.0 ? centre : fit->a < 0.0 ? front : rear;
    faults.push_back(
        inverted({spectra.channels[culprit].name},
                 fmt::format("centre = {:.2f} × front {:+.2f} × rear below 5 Hz, where a body makes +0.5 and "
                             "+0.5: the sign of this channel is wrong",
                             fit->a, fit->b)));
}

}  // namespace

void check_polarity(const Evidence& evidence, std::vector<Fault>& faults) {
    check_polarity_of_copies(evidence, faults);
    if (!evidence.spectra) return;
    check_polarity_of_bogies(evidence, faults);
    check_polarity_of_body(evidence, faults);
}

}  // namespace railpem::recordings::checks
