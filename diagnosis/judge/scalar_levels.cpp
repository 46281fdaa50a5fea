#include "diagnosis/judge/scalar_levels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "diagnosis/likelihood/scalar_likelihood.hpp"

namespace railpem::diagnosis {

namespace {

/// Of the values of one channel in one third-octave.
struct Band {
    std::complex<double> difference = 0.0;  ///< sum, nepers and radians
    double variance = 0.0;                  ///< sum
    double count = 0.0;
};

std::map<std::pair<std::size_t, long>, Band> bands_of(const ScalarData& data, const ExpectedSpectra& prediction) {
    std::map<std::pair<std::size_t, long>, Band> bands;
    for (std::size_t i = 0; i < data.values.size(); ++i) {
        const ScalarValue& value = data.values[i];
        Band& band = bands[{value.channel, std::lround(10.0 * std::log10(value.frequency_hz))}];
        const std::complex<double> z = prediction.values[i];
        band.difference += data.has_phase ? z : std::complex<double>(z.real(), 0.0);
        band.variance += scalar_variance(value, kBeliefs.scalar_discrepancy) * (data.has_phase ? 2.0 : 1.0);
        band.count += 1.0;
    }
    return bands;
}

}  // namespace

double scalar_level_db(const Fit& fit, const LikelihoodContext& context) {
    double sum = 0.0, count = 0.0;
    for (std::size_t o = 0; o < context.observations->size(); ++o) {
        const Observation& observation = (*context.observations)[o];
        if (!observation.scalar) continue;
        const double db = db_per_neper(observation.scalar->kind);
        for (const auto& [place, band] : bands_of(*observation.scalar, fit.predictions[o])) {
            sum += db * db * (std::norm(band.difference) - band.variance) / (band.count * band.count);
            count += 1.0;
        }
    }
    return count == 0.0 ? 0.0 : std::sqrt(std::max(0.0, sum / count));
}

}  // namespace railpem::diagnosis
