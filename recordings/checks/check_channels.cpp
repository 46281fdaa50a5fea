#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recordings/checks/checks.hpp"
#include "recordings/confidence.hpp"

namespace railpem::recordings::checks {
namespace {

constexpr double false_alarm = 1e-6;

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
    const auto& x = evidence.detrended;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
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
                faults.push_back(about(FaultKind::duplicated, {evidence.name(j), evidence.name(i)},
                                       fmt::format("{} is {:.4g} × {} but for {:.1e} of its power: one sensor recorded twice", evidence.name(i), ij / jj, evidence.name(j), std::max(0.0, left)), ij / jj, 0.0));
        }
}

/// Channels whose sign disagrees with the others of a group. `signs`: +1 alike, −1 opposite, 0 not known, row by row.
void report_minority(const Evidence& evidence, const std::vector<std::size_t>& members, const std::vector<std::vector<int>>& signs, std::vector<Fault>& faults) {
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
        faults.push_back(about(FaultKind::inverted, names, "half of these channels have the opposite sign of the other half: which half cannot be told", -1.0, false_alarm));
        return;
    }
    for (std::size_t i = 0; i < members.size(); ++i)
        if (sign[i] == (minus < plus ? -1 : 1)) faults.push_back(about(FaultKind::inverted, {evidence.name(members[i])}, "the sign is opposite to that of the other channels at such places: the sensor is upside down or wired the wrong way", -1.0, false_alarm));
}

/// Signs by delayed copies (axle boxes, bogies) and by channels at one place (left and right of an axle).
void check_polarity_of_copies(const Evidence& evidence, std::vector<Fault>& faults) {
    for (const Location location : {Location::wheel, Location::bogie}) {
        std::vector<std::size_t> members;
        for (std::size_t i = 0; i < evidence.series().channels.size(); ++i)
            if (evidence.series().channels[i].description.location == location) members.push_back(i);
        if (members.size() < 2) continue;
        std::vector<std::vector<int>> signs(members.size(), std::vector<int>(members.size(), 0));
        const auto position = [&](std::size_t channel) { return static_cast<std::size_t>(std::find(members.begin(), members.end(), channel) - members.begin()); };
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

BandSign band_sign(const std::vector<std::complex<double>>& cross, const std::vector<double>& a, const std::vector<double>& b, double averages_per_bin) {
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
    result.significant = result.coherence > coherence_limit(std::max(2.0, averages_per_bin * count), false_alarm) && std::abs(result.real) > 0.5 * std::sqrt(result.coherence);
    return result;
}

/// A bogie frame follows the mean of its wheels below its own resonance.
void check_polarity_of_bogies(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    const auto find = [&](Location location, int index) {
        for (std::size_t i = 0; i < spectra.size(); ++i)
            if (spectra.channels[i].location == location && spectra.channels[i].index == index && spectra.channels[i].quantity == ChannelQuantity::acceleration) return i;
        return spectra.size();
    };
    for (int bogie = 1; bogie <= 2; ++bogie) {
        const std::size_t b = find(Location::bogie, bogie), w1 = find(Location::wheel, 2 * bogie - 1), w2 = find(Location::wheel, 2 * bogie);
        if (b == spectra.size() || w1 == spectra.size() || w2 == spectra.size()) continue;
        std::vector<std::complex<double>> cross;
        std::vector<double> bogie_power, wheel_power;
        for (std::size_t k = 1; k < spectra.bins() && spectra.frequency_hz[k] <= 3.0; ++k) {
            if (spectra.frequency_hz[k] < 0.7) continue;
            cross.push_back(0.5 * (spectra.at(k, b, w1) + spectra.at(k, b, w2)));
            bogie_power.push_back(spectra.psd(k, b));
            wheel_power.push_back(0.25 * (spectra.psd(k, w1) + spectra.psd(k, w2) + 2.0 * spectra.at(k, w1, w2).real()));
        }
        const BandSign sign = band_sign(cross, bogie_power, wheel_power, spectra.averages_per_bin);
        if (sign.significant && sign.real < 0.0)
            faults.push_back(about(FaultKind::inverted, {spectra.channels[b].name}, fmt::format("below 3 Hz it moves against the mean of axle boxes {} and {} (correlation {:.2f}): bogie or both axle boxes are inverted", 2 * bogie - 1, 2 * bogie, sign.real), -1.0, false_alarm));
    }
}

/// A rigid body's centre moves with the mean of its ends: coefficients of the ends in the centre, both about 0.5.
void check_polarity_of_body(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    std::size_t front = spectra.size(), rear = front, centre = front;
    for (std::size_t i = 0; i < spectra.size(); ++i) {
        const ChannelDescription& c = spectra.channels[i];
        if (c.location != Location::body || c.quantity != ChannelQuantity::acceleration) continue;
        (c.position_m > 2.0 ? front : c.position_m < -2.0 ? rear : centre) = i;
    }
    if (front == spectra.size() || rear == spectra.size() || centre == spectra.size()) return;
    // Normal equations of the centre on both ends, real parts, below 5 Hz where the body is rigid.
    double ff = 0.0, rr = 0.0, fr = 0.0, cf = 0.0, cr = 0.0, cc = 0.0;
    for (std::size_t k = 1; k < spectra.bins() && spectra.frequency_hz[k] <= 5.0; ++k) {
        if (spectra.frequency_hz[k] < 0.5) continue;
        ff += spectra.psd(k, front);
        rr += spectra.psd(k, rear);
        cc += spectra.psd(k, centre);
        fr += spectra.at(k, front, rear).real();
        cf += spectra.at(k, centre, front).real();
        cr += spectra.at(k, centre, rear).real();
    }
    const double determinant = ff * rr - fr * fr;
    if (determinant < 1e-3 * ff * rr || cc <= 0.0) return;
    const double a = (cf * rr - cr * fr) / determinant, b = (cr * ff - cf * fr) / determinant;
    const double explained = (a * cf + b * cr) / cc;
    if (explained < 0.7 || std::min(std::abs(a), std::abs(b)) < 0.2) return;  // not a rigid body: nothing follows
    if (a > 0.0 && b > 0.0) return;
    const std::size_t culprit = a < 0.0 && b < 0.0 ? centre : a < 0.0 ? front : rear;
    faults.push_back(about(FaultKind::inverted, {spectra.channels[culprit].name}, fmt::format("centre = {:.2f} × front {:+.2f} × rear below 5 Hz, where a body makes +0.5 and +0.5: the sign of this channel is wrong", a, b), -1.0, false_alarm));
}

/// Which wheel a channel is, judged by the delays: the order of the axle boxes that fits best, over all orders.
void check_order(const Evidence& evidence, std::vector<Fault>& faults) {
    if (!evidence.context.geometry) return;
    std::vector<std::size_t> members;
    for (const PairDelay& pair : evidence.delays)
        for (const std::size_t channel : {pair.front, pair.rear})
            if (evidence.series().channels[channel].description.location == Location::wheel && std::find(members.begin(), members.end(), channel) == members.end()) members.push_back(channel);
    if (members.size() < 2 || members.size() > 6) return;
    std::sort(members.begin(), members.end());
    std::vector<double> places;
    for (const std::size_t channel : members) places.push_back(evidence.context.geometry->wheels_m[static_cast<std::size_t>(evidence.series().channels[channel].description.index - 1)]);
    std::vector<std::size_t> order(members.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Misfit of an order: delays against one positive slowness times the distances it implies.
    const auto misfit = [&](const std::vector<std::size_t>& assigned) {
        double xx = 0.0, xy = 0.0, yy = 0.0;
        for (const PairDelay& pair : evidence.delays) {
            const auto a = std::find(members.begin(), members.end(), pair.front), b = std::find(members.begin(), members.end(), pair.rear);
            if (a == members.end() || b == members.end()) continue;
            const double distance = places[assigned[static_cast<std::size_t>(a - members.begin())]] - places[assigned[static_cast<std::size_t>(b - members.begin())]];
            xx += distance * distance;
            xy += distance * pair.delay.seconds;
            yy += pair.delay.seconds * pair.delay.seconds;
        }
        return xy > 0.0 ? 1.0 - xy * xy / (xx * yy) : 1.0;
    };
    const double as_described = misfit(order);
    double best = as_described;
    std::vector<std::size_t> best_order = order, assigned = order;
    while (std::next_permutation(assigned.begin(), assigned.end())) {
        const double value = misfit(assigned);
        if (value < best) {
            best = value;
            best_order = assigned;
        }
    }
    // A sound order leaves less than a ten-thousandth; a swap of two neighbours leaves more than a hundredth.
    if (as_described < 0.005 || best > 0.2 * as_described) return;
    std::vector<std::string> names;
    std::string says;
    for (std::size_t i = 0; i < members.size(); ++i)
        if (best_order[i] != order[i]) {
            names.push_back(evidence.name(members[i]));
            says += fmt::format("{}{} sits where {} is described", says.empty() ? "" : ", ", evidence.name(members[i]), evidence.name(members[best_order[i]]));
        }
    faults.push_back(about(FaultKind::swapped, names, "by the delays between the axle boxes " + says + (names.size() == members.size() && members.size() > 2 ? ": the numbering runs from the rear, or the train ran backwards" : ""), 0.0, false_alarm));
}

/// Above 20 Hz every suspension makes the next mass quieter: wheel, bogie, body.
void check_roughness(const Evidence& evidence, std::vector<Fault>& faults) {
    const CrossSpectra& spectra = *evidence.spectra;
    const auto level = [&](std::size_t channel) {
        double sum = 0.0;
        for (std::size_t k = 1; k < spectra.bins(); ++k)
            if (spectra.frequency_hz[k] >= 20.0 && spectra.frequency_hz[k] <= std::min(100.0, 0.4 * spectra.sampling_rate_hz)) sum += spectra.psd(k, channel);
        return 10.0 * std::log10(std::max(sum, 1e-300));
    };
    const auto rank = [](Location location) { return location == Location::body ? 1 : location == Location::bogie ? 2 : location == Location::wheel ? 3 : 0; };
    for (std::size_t i = 0; i < spectra.size(); ++i)
        for (std::size_t j = 0; j < spectra.size(); ++j) {
            const ChannelDescription &quiet = spectra.channels[i], &rough = spectra.channels[j];
            if (rank(quiet.location) == 0 || rank(quiet.location) >= rank(rough.location) || quiet.quantity != ChannelQuantity::acceleration || rough.quantity != ChannelQuantity::acceleration) continue;
            if (quiet.scale == Scale::unknown || rough.scale == Scale::unknown) continue;
            const double difference = level(i) - level(j);
            if (difference < 6.0) continue;
            // Said of the pair that differs most, not of every pair that the same swap disturbs.
            bool largest = true;
            for (std::size_t k = 0; k < spectra.size() && largest; ++k)
                if (rank(spectra.channels[k].location) == rank(rough.location)) largest = level(j) <= level(k);
            for (std::size_t k = 0; k < spectra.size() && largest; ++k)
                if (rank(spectra.channels[k].location) == rank(quiet.location)) largest = level(i) >= level(k);
            if (largest)
                faults.push_back(about(FaultKind::swapped, {quiet.name, rough.name}, fmt::format("{} is {:.0f} dB rougher than {} above 20 Hz: the channels are swapped, or a unit is wrong", quiet.name, difference, rough.name), difference, false_alarm));
        }
}

}  // namespace

void check_channels(const Evidence& evidence, std::vector<Fault>& faults) {
    check_duplicates(evidence, faults);
    check_polarity_of_copies(evidence, faults);
    check_order(evidence, faults);
    if (!evidence.spectra) return;
    check_polarity_of_bogies(evidence, faults);
    check_polarity_of_body(evidence, faults);
    check_roughness(evidence, faults);
}

}  // namespace railpem::recordings::checks
