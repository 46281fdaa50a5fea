#include "recordings/estimates/band_levels.hpp"

#include <cmath>
#include <span>

namespace railpem::recordings {

std::vector<BandLevel> band_levels(const CrossSpectra& spectra, std::size_t channel) {
    std::vector<double> psd;
    for (std::size_t k = 1; k + 1 < spectra.bins(); ++k) psd.push_back(spectra.psd(k, channel));
    const std::span<const double> frequency(spectra.frequency_hz.data() + 1, psd.size());
    std::vector<BandLevel> levels;
    for (const spectra::ThirdOctaveLevel& level : spectra::third_octave_levels(frequency, psd)) {
        if (level.band.high_hz - level.band.low_hz < 3.0 * spectra.kernel().bin_hz() || !(level.mean_square > 0.0))
            continue;
        std::vector<double> weights;
        for (std::size_t k = 0; k < psd.size(); ++k)
            if (frequency[k] >= level.band.low_hz && frequency[k] < level.band.high_hz) weights.push_back(psd[k]);
        BandLevel result{level.band, level.level_db, {}, band_averages(spectra.segments, weights)};
        const Interval factors = spectrum_interval(result.averages);
        result.interval_db = {level.level_db + 10.0 * std::log10(factors.low),
                              level.level_db + 10.0 * std::log10(factors.high)};
        levels.push_back(result);
    }
    return levels;
}

}  // namespace railpem::recordings
