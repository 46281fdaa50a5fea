#include "diagnosis/observations/reference_band.hpp"

#include <cmath>

namespace railpem::diagnosis {

namespace {

int band_of(double frequency_hz) {
    return static_cast<int>(std::lround(10.0 * std::log10(frequency_hz)));
}

}  // namespace

int reference_band(const pem::DecayRateReference& reference, double frequency_hz) {
    for (std::size_t i = 0; i < reference.centre_hz.size(); ++i)
        if (band_of(reference.centre_hz[i]) == band_of(frequency_hz)) return static_cast<int>(i);
    return -1;
}

}  // namespace railpem::diagnosis
