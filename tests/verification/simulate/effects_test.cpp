// Every effect, hidden at its standard strength in a moving record, must be felt where it sits and must leave the rest
// alive.
#include <gtest/gtest.h>

#include "simulate/effects/hidden_effects.hpp"
#include "tests/verification/simulate/transfer.hpp"

namespace railpem::tests {
namespace {

struct Felt {
    std::string text;        ///< as after --hide
    std::size_t channel;     ///< in which it is looked for
    double low_hz, high_hz;  ///< and the band
    double least_db;         ///< change of the level at least
};

std::ostream& operator<<(std::ostream& out, const Felt& felt) {
    return out << felt.text;
}

pem::CaseParameters believed() {
    auto c = paper_case(1);
    c.frequency.from_hz = 1.0;
    return c;
}

simulate::Recording record(const std::string& hide) {
    auto c = believed();
    if (hide.starts_with("sleeper-flexibility"))
        c.track.support = {.model = track::SupportModel::two_layer,
                           .mass_kg = 150,
                           .stiffness_n_per_m = 8e7,
                           .damping_n_s_per_m = 8e4};
    simulate::Options options;
    options.seconds = 4.0;
    options.settling_s = 1.5;
    if (!hide.ends_with("none"))
        simulate::apply_hidden(simulate::parse_hidden(hide), c, options.only_here,
                               [](pem::CaseParameters& p, const std::string&, double factor) {
                                   p.track.pads.static_stiffness_n_per_m *= factor;
                               });
    pem::check(c);
    return simulate::simulate(c, options);
}

double level_db(const simulate::Recording& recording, const Felt& felt) {
    const auto spectrum = spectrum_of(recording.channels[felt.channel].acceleration_m_per_s2);
    double energy = 0.0;
    for (std::size_t k = 1; k < spectrum.size() / 2; ++k) {
        const double f = recording.sampling_rate_hz * static_cast<double>(k) / static_cast<double>(spectrum.size());
        if (f >= felt.low_hz && f < felt.high_hz) energy += std::norm(spectrum[k]);
    }
    return 10.0 * std::log10(energy);
}

class Hidden : public testing::TestWithParam<Felt> {};

TEST_P(Hidden, IsFelt) {
    static const simulate::Recording plain = record("none");
    static const simulate::Recording plain_on_sleepers = record("sleeper-flexibility-none");
    const Felt& felt = GetParam();
    const simulate::Recording with = record(felt.text);
    for (const auto& channel : with.channels)
        for (const double a : channel.acceleration_m_per_s2) ASSERT_TRUE(std::isfinite(a));
    const double change =
        level_db(with, felt) - level_db(felt.text.starts_with("sleeper-flexibility") ? plain_on_sleepers : plain, felt);
    if (std::getenv("RAILPEM_PRINT") != nullptr)
        std::printf("%-60s %.2f dB, %.1f solves per step\n", felt.text.c_str(), change, with.making.solves_per_step);
    EXPECT_GT(std::abs(change), felt.least_db) << change;
    EXPECT_LT(with.making.solves_per_step, 12.0);
}

constexpr std::size_t axlebox_1 = 0, axlebox_2 = 1, bogie_1 = 4, body_rear = 7, body_centre = 8;
const double v = 80.0 / 3.6;

const std::vector<Felt> felt{
    {"pad-frequency-stiffening", axlebox_1, 60, 90, 0.5},
    {"pad-preload-stiffening", axlebox_1, 50, 90, 0.3},
    {"pad-hysteresis", axlebox_1, 40, 70, 0.5},
    {"rail-shear", axlebox_1, 35.5, 38.5, 0.05},
    {"support-compliance", axlebox_1, 30, 80, 0.5},
    {"sleeper-flexibility", axlebox_1, 90, 160, 0.1},
    {"rail-damper:mass_kg_per_m=40", axlebox_1, 80, 140, 0.1},
    {"failed-fasteners:every=5", axlebox_1, v / 3.0 - 0.4, v / 3.0 + 0.4, 3.0},
    {"failed-fasteners:fraction=0.3,seed=3", axlebox_1, 5, 40, 0.3},
    {"sleeper-passing:amplitude_factor=19", axlebox_1, v / 0.6 - 0.4, v / 0.6 + 0.4, 3.0},
    {"wheel-out-of-roundness:wheel=2,order=6,amplitude_m=2e-4", axlebox_2, 6 * v / (2 * std::numbers::pi * 0.42) - 0.4,
     6 * v / (2 * std::numbers::pi * 0.42) + 0.4, 6.0},
    {"rail-corrugation", axlebox_1, 65, 83, 2.0},
    {"rail-joints:depth_m=2e-3", axlebox_1, 10, 40, 1.0},
    {"irregularity-spectrum:level_db=4", body_centre, 2, 20, 3.9},
    {"body-bending", body_centre, 8, 12, 2.0},
    {"wheelset-bending", axlebox_1, 60, 100, 0.3},
    {"bogie-mounted-mass", bogie_1, 15, 25, 0.3},
    {"primary-damper-series-stiffness", bogie_1, 40, 100, 0.3},
    {"secondary-damper-series-stiffness", body_rear, 10, 40, 0.3},
    {"suspension-friction:stage=secondary,force_n=3000", body_rear, 3, 20, 0.5},
    {"suspension-friction:stage=primary,force_n=3000", bogie_1, 20, 80, 0.5},
    {"contact-nonlinearity:factor=5", axlebox_1, 120, 220, 0.005},
    {"contact-filter", axlebox_1, 150, 220, 0.05},
    {"sensor-gain:channel=bogie_1,gain=1.2", bogie_1, 2, 180, 1.5},
    {"sensor-resonance:channel=axlebox_1,frequency_hz=100", axlebox_1, 90, 110, 6.0},
    {"sensor-noise:channel=body_centre,rms_m_per_s2=0.2", body_centre, 50, 200, 6.0},
    {"parameter-error:parameter=track.pads.static_stiffness_n_per_m", axlebox_1, 50, 80, 0.3},
    {"bogie-coupling:stiffness_n_per_m=1e7", bogie_1, 4, 20, 0.3},
    {"axle-absorber", axlebox_1, 40, 50, 0.5},
    {"guidance-stick-slip", bogie_1, 20, 80, 0.3},
    {"body-coupling:stiffness_n_per_m=4e6", body_rear, 1, 6, 0.3},
    {"secondary-bump-stop:gap_m=5e-4", body_rear, 3, 30, 0.3},
    {"pad-dead-band", axlebox_1, 40, 80, 0.3},
    {"wandering-subgrade", axlebox_1, 20, 60, 0.3},
};

INSTANTIATE_TEST_SUITE_P(Effects, Hidden, testing::ValuesIn(felt));

}  // namespace
}  // namespace railpem::tests
