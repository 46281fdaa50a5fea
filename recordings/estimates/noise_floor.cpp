#include "recordings/estimates/noise_floor.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace railpem::recordings {

std::vector<double> incoherent_part(const CrossSpectra& spectra, std::size_t channel) {
    const double p = static_cast<double>(spectra.size()), k_averages = spectra.averages;
    std::vector<double> result(spectra.bins(), std::numeric_limits<double>::quiet_NaN());
    if (k_averages < 2.0 * p) return result;
    const double correction = k_averages / (k_averages - p + 1.0);
    const auto n = static_cast<Eigen::Index>(spectra.size());
    const auto c = static_cast<Eigen::Index>(channel);
    for (std::size_t k = 1; k + 1 < spectra.bins(); ++k) {
        // Scaled to a unit diagonal: channels differ in power by many orders of magnitude.
        const Eigen::VectorXd power = spectra.matrix(k).diagonal().real();
        if (power.minCoeff() <= 0.0) continue;
        const Eigen::VectorXd scale = power.cwiseSqrt().cwiseInverse();
        const Eigen::MatrixXcd scaled = scale.asDiagonal() * spectra.matrix(k) * scale.asDiagonal();
        const Eigen::LLT<Eigen::MatrixXcd> factor(scaled);
        if (factor.info() != Eigen::Success) continue;
        const double inverse = factor.solve(Eigen::MatrixXcd::Identity(n, n).col(c))[c].real();
        if (inverse > 0.0 && inverse < 1e12) result[k] = correction * power[c] / inverse;
    }
    return result;
}

}  // namespace railpem::recordings
