#include "spectra/third_octaves.hpp"

#include <array>
#include <cassert>
#include <cmath>

#include "spectra/integrate_psd.hpp"

namespace railpem::spectra {

namespace {

double nominal(int index) {
    // The names of one decade.
    constexpr std::array names = {1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0};
    const int place = ((index % 10) + 10) % 10;
    const int decade = (index - place) / 10;
    // Dividing by an exact power of ten rounds once; multiplying by 10^−d would not give the double nearest to 0.315.
    const double name = names[static_cast<std::size_t>(place)];
    return decade < 0 ? name / std::pow(10.0, -decade) : name * std::pow(10.0, decade);
}

}  // namespace

ThirdOctaveBand third_octave_band(int index) {
    return {.index = index,
            .nominal_hz = nominal(index),
            .centre_hz = std::pow(10.0, 0.1 * index),
            .low_hz = std::pow(10.0, 0.1 * (index - 0.5)),
            .high_hz = std::pow(10.0, 0.1 * (index + 0.5))};
}

std::vector<ThirdOctaveBand> third_octave_bands(double low_hz, double high_hz) {
    assert(low_hz > 0.0);
    std::vector<ThirdOctaveBand> bands;
    // The edges themselves decide: the index from the logarithm may be off by rounding, so it starts one too low.
    for (int index = static_cast<int>(std::floor(10.0 * std::log10(low_hz)));; ++index) {
        const ThirdOctaveBand band = third_octave_band(index);
        if (band.high_hz > high_hz) return bands;
        if (band.low_hz >= low_hz) bands.push_back(band);
    }
}

double level_db(double mean_square, double reference) {
    return 10.0 * std::log10(mean_square / (reference * reference));
}

std::vector<ThirdOctaveLevel> third_octave_levels(std::span<const double> frequency_hz, std::span<const double> psd,
                                                  double reference) {
    std::vector<ThirdOctaveLevel> levels;
    for (const ThirdOctaveBand& band : third_octave_bands(frequency_hz.front(), frequency_hz.back())) {
        const double power = *mean_square_between(frequency_hz, psd, band.low_hz, band.high_hz);
        levels.push_back({band, power, level_db(power, reference)});
    }
    return levels;
}

}  // namespace railpem::spectra
