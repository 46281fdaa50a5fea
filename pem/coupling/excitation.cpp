#include "pem/coupling/excitation.hpp"

#include <algorithm>
#include <cmath>

#include "pem/angular_frequency.hpp"
#include "spectra/line_power.hpp"

namespace railpem::pem {

namespace {

/// In standard deviations of a line: beyond it lies less than 1e-32 of its power, less than the rounding of an
/// amplitude.
constexpr double kFarthest = 12.0;

/// What every bin asks of a line, computed once.
struct LinePower {
    std::array<double, 4> power{};                ///< m² per wheel
    std::array<std::complex<double>, 4> phase{};  ///< of size 1
    double sum = 0.0, frequency_hz = 0.0;

    explicit LinePower(const SpectralLine& line) : frequency_hz(line.frequency_hz) {
        for (std::size_t j = 0; j < 4; ++j) {
            power[j] = 0.5 * std::norm(line.amplitude_m[j]);
            phase[j] = std::polar(1.0, std::arg(line.amplitude_m[j]));
            sum += power[j];
        }
    }
};

}  // namespace

Source delayed_source(DelayedSpectrum spectrum, std::vector<double> wheels_m, double speed) {
    std::string name = spectrum.name;
    const auto amplitude = [wheels = std::move(wheels_m), speed,
                            spectrum = std::move(spectrum)](const LineGroup& group) {
        WheelVector e;
        for (int lane = 0; lane < lanes::width; ++lane) {
            const std::array<std::complex<double>, 4> own = met(spectrum, wheels, speed, group.omega[lane] / kTwoPi);
            for (std::size_t j = 0; j < e.size(); ++j) e[j].set(lane, own[j]);
        }
        return e;
    };
    return {std::move(name), amplitude};
}

Source line_source(std::string name, std::vector<SpectralLine> lines, double speed_fluctuation) {
    std::vector<LinePower> powers(lines.begin(), lines.end());
    std::stable_sort(powers.begin(), powers.end(),
                     [](const LinePower& a, const LinePower& b) { return a.frequency_hz < b.frequency_hz; });
    const auto amplitude = [lines = std::move(powers), speed_fluctuation](const LineGroup& group) {
        WheelVector e;
        for (int lane = 0; lane < lanes::width; ++lane) {
            const double f = group.omega[lane] / kTwoPi;
            std::array<double, 4> power{};
            double strongest = 0.0;
            const LinePower* leading = nullptr;
            const auto reach = [&](const LinePower& line) {
                return kFarthest * speed_fluctuation * line.frequency_hz + group.step_hz;
            };
            const auto first = std::partition_point(
                lines.begin(), lines.end(), [&](const LinePower& line) { return line.frequency_hz + reach(line) < f; });
            for (auto next = first; next != lines.end(); ++next) {
                const LinePower& line = *next;
                // Lines so wide that they reach down to zero never end this.
                if (line.frequency_hz - reach(line) > f) break;
                const double share =
                    spectra::line_power_in_bin(f - 0.5 * group.step_hz, f + 0.5 * group.step_hz, line.frequency_hz, 1.0,
                                               speed_fluctuation * line.frequency_hz) /
                    group.step_hz;
                for (std::size_t j = 0; j < 4; ++j) power[j] += share * line.power[j];
                if (share * line.sum > strongest) {
                    strongest = share * line.sum;
                    leading = &line;
                }
            }
            if (!leading) continue;
            for (std::size_t j = 0; j < 4; ++j) e[j].set(lane, std::sqrt(power[j]) * leading->phase[j]);
        }
        return e;
    };
    return {std::move(name), amplitude};
}

std::complex<double> delay_phase(const std::vector<double>& wheels_m, std::size_t wheel, double frequency_hz,
                                 double speed_m_per_s) {
    return std::polar(1.0, -kTwoPi * frequency_hz * (wheels_m[0] - wheels_m[wheel]) / speed_m_per_s);
}

std::array<std::complex<double>, 4> met(const DelayedSpectrum& source, const std::vector<double>& wheels_m,
                                        double speed, double frequency) {
    if (source.under_wheels) return source.under_wheels(frequency);
    std::array<std::complex<double>, 4> own;
    const double root = std::sqrt(source.psd_m2_per_hz(frequency));
    for (std::size_t j = 0; j < 4; ++j) own[j] = root * source.share[j] * delay_phase(wheels_m, j, frequency, speed);
    return own;
}

}  // namespace railpem::pem
