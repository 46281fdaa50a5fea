#pragma once
// Comparison line by line: the vehicle stands, a periodic profile is pulled through for exactly one of its periods, and
// the discrete Fourier transform of every channel over that of the profile under wheel 1 is the transfer function,
// without leakage and without statistics.

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <unsupported/Eigen/FFT>
#include <vector>

#include <algorithm>
#include "pem/coupling/solution.hpp"
#include "pem/coupling/solve_case.hpp"
#include "pem/response_names.hpp"
#include "simulate/march/excitation.hpp"
#include "simulate/march/simulate.hpp"
#include "spectra/irregularity_spectrum.hpp"
#include "tests/verification/pem/paper_case.hpp"

namespace railpem::tests {

struct BandLevel {
    double centre_hz;
    double difference_db;  ///< marched over frequency domain
};

struct ChannelDifference {
    std::string channel;
    std::vector<BandLevel> bands;
    double median_db = 0.0;  ///< of the absolute differences
    double largest_db = 0.0;
};

/// rms of a line of a channel (the first is the axle box of wheel 1), over a whole number of its periods, m/s².
inline double line_rms(const simulate::Recording& record, double frequency_hz, std::size_t channel = 0) {
    const std::vector<double>& a = record.channels[channel].acceleration_m_per_s2;
    const double periods = std::floor(static_cast<double>(a.size()) / record.sampling_rate_hz * frequency_hz);
    const auto n = static_cast<std::size_t>(std::lround(periods / frequency_hz * record.sampling_rate_hz));
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < n; ++i)
        sum += a[i] * std::polar(1.0, -2.0 * std::numbers::pi * frequency_hz * static_cast<double>(i) /
                                          record.sampling_rate_hz);
    return std::sqrt(2.0) * std::abs(sum) / static_cast<double>(n);
}

inline std::vector<std::complex<double>> spectrum_of(const std::vector<double>& samples) {
    Eigen::FFT<double> transform;
    std::vector<std::complex<double>> spectrum;
    transform.fwd(spectrum, samples);
    return spectrum;
}

inline const std::vector<std::string>& solver_names() {
    static const std::vector<std::string> names{"wheel_1", "wheel_2",    "wheel_3",   "wheel_4", "bogie_1",
                                                "bogie_2", "body_front", "body_rear", "body"};
    return names;
}

/// Options of a standing record that takes exactly one period of the profile.
inline simulate::Options standing_options(const pem::CaseParameters& parameters, double seconds) {
    simulate::Options options;
    options.mode = simulate::Mode::standing;
    options.seconds = seconds;
    options.profile_length_m = seconds * parameters.running.speeds_m_per_s.front();
    options.repeat_profile = true;
    options.settling_s = 6.0;
    options.linear_contact = true;
    options.linear_pads = true;
    return options;
}

/// Sixth-octave bands from 2 to 180 Hz: energy of the marched record against the frequency-domain transfer functions
/// applied to the very same profile.
inline std::vector<ChannelDifference> compare(pem::CaseParameters parameters, const simulate::Options& options) {
    const double speed = parameters.running.speeds_m_per_s.front();
    const simulate::Recording recording = simulate::simulate(parameters, options);
    const std::size_t n = recording.samples();
    const double resolution = recording.sampling_rate_hz / static_cast<double>(n);

    parameters.frequency = {.from_hz = resolution, .to_hz = 200.0, .step_hz = resolution};
    parameters.solver.moving = options.mode == simulate::Mode::moving;
    const pem::Solution solution = pem::solve_case(parameters, speed);
    parameters.contact.patch_half_length_m = 0.0;  // the patch is part of the transfer functions
    const simulate::Travel travel{.speed_m_per_s = speed, .wander = {}};
    const simulate::Excitation excitation =
        simulate::make_excitation(parameters, options, travel, -1.0, options.seconds, recording.making.step_s);
    std::vector<double> met(n);
    for (std::size_t i = 0; i < n; ++i)
        met[i] = excitation.at(0, 1e9, speed * static_cast<double>(i) / recording.sampling_rate_hz);
    const auto met_spectrum = spectrum_of(met);

    std::vector<ChannelDifference> differences;
    for (std::size_t c = 0; c < solver_names().size(); ++c) {
        const auto marched = spectrum_of(recording.channels[c].acceleration_m_per_s2);
        const std::complex<double>* pseudo = solution.at(0, pem::response_index(solver_names()[c]));
        ChannelDifference difference{.channel = solver_names()[c], .bands = {}};
        std::vector<double> sizes;
        for (double centre = 2.0; centre < 181.0; centre *= std::pow(2.0, 1.0 / 6.0)) {
            double energy_marched = 0.0;
            double energy_solved = 0.0;
            for (std::size_t k = 1; k <= solution.frequency_hz.size(); ++k) {
                // to the last bit: a band of the irregularity may begin here
                const double f = solution.frequency_hz[k - 1];
                if (f < centre * std::pow(2.0, -1.0 / 12.0) || f >= centre * std::pow(2.0, 1.0 / 12.0)) continue;
                const double s = spectra::irregularity_psd_m2_per_hz(parameters.irregularity, f, speed);
                if (s <= 0.0) continue;
                // Lines of sleeper passing: their own test.
                if (options.mode == simulate::Mode::moving &&
                    std::abs(std::remainder(f, speed / parameters.track.spacing_m)) < 0.5 * resolution)
                    continue;
                energy_marched += std::norm(marched[k]);
                energy_solved += std::norm(pseudo[k - 1] / std::sqrt(s) * met_spectrum[k]);
            }
            if (energy_solved <= 0.0) continue;
            difference.bands.push_back({centre, 10.0 * std::log10(energy_marched / energy_solved)});
            sizes.push_back(std::abs(difference.bands.back().difference_db));
        }
        std::sort(sizes.begin(), sizes.end());
        difference.median_db = sizes[sizes.size() / 2];
        difference.largest_db = sizes.back();
        differences.push_back(difference);
    }
    return differences;
}

}  // namespace railpem::tests
