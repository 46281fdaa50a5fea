#include "recordings/checks/prediction_levels.hpp"

#include <algorithm>
#include <cmath>

#include "recordings/checks/interpolated.hpp"

namespace railpem::recordings::checks {

LevelDifferences against_prediction(const Evidence& evidence, std::size_t channel) {
    LevelDifferences differences;
    const auto predicted =
        std::find_if(evidence.context.predicted.begin(), evidence.context.predicted.end(),
                     [&](const PredictedSpectrum& p) { return p.channel == evidence.name(channel); });
    if (predicted == evidence.context.predicted.end() || !evidence.spectra) return differences;
    const CrossSpectra& spectra = *evidence.spectra;
    std::vector<double> weights;
    for (double centre = 2.0; centre < 0.4 * spectra.sampling_rate_hz; centre *= std::pow(10.0, 0.1)) {
        double measured = 0.0, expected = 0.0;
        for (std::size_t k = 1; k < spectra.bins(); ++k)
            if (spectra.frequency_hz[k] >= centre * std::pow(10.0, -0.05) &&
                spectra.frequency_hz[k] < centre * std::pow(10.0, 0.05)) {
                const double own = interpolated(predicted->frequency_hz, predicted->psd, spectra.frequency_hz[k]);
                measured += own > 0.0 ? spectra.psd(k, channel) : 0.0;
                expected += own;
            }
        if (measured <= 0.0 || expected <= 0.0) continue;
        differences.frequency_hz.push_back(centre);
        differences.level_db.push_back(10.0 * std::log10(measured / expected));
        weights.push_back(expected);
    }
    if (weights.empty()) return differences;
    const double least = *std::max_element(weights.begin(), weights.end()) * std::pow(10.0, -2.5);
    for (const double weight : weights) differences.strong.push_back(weight >= least);
    return differences;
}

}  // namespace railpem::recordings::checks
