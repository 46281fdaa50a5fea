#include "pem/excitation.hpp"

#include <cmath>
#include <numbers>

#include "pem/contact.hpp"
#include "spectra/irregularity_spectrum.hpp"

namespace railpem::pem {

namespace {

Source irregularity_source(const CaseParameters& parameters, const std::vector<double>& wheels_m, double speed) {
    const auto amplitude = [&parameters, wheels_m, speed](lanes::Real omega) {
        WheelVector e;
        for (int lane = 0; lane < lanes::width; ++lane) {
            const double frequency = omega[lane] / (2.0 * std::numbers::pi);
            const double filter = contact_filter(parameters.contact.patch_half_length_m, omega[lane] / speed);
            const double root = filter * std::sqrt(spectra::irregularity_psd_m2_per_hz(parameters.irregularity, frequency, speed));
            for (std::size_t j = 0; j < e.size(); ++j) {
                const double phase = -omega[lane] * (wheels_m[0] - wheels_m[j]) / speed;
                e[j].set(lane, std::polar(root, phase));
            }
        }
        return e;
    };
    return {"irregularity", amplitude};
}

}  // namespace

std::vector<Source> excitation_sources(const CaseParameters& parameters, const std::vector<double>& wheels_m, double speed_m_per_s) {
    return {irregularity_source(parameters, wheels_m, speed_m_per_s)};
}

}  // namespace railpem::pem
