#include "diagnosis_fixtures.hpp"

#include <cmath>
#include <limits>

namespace railpem::app::testing {
namespace {

using namespace diagnosis;

/// The level in dB by which a channel is off at a frequency, for the believed and the retuned case.
struct Differences {
    double believed, retuned;
};

Differences differences(const std::string& channel, double f) {
    const bool wheel = channel.starts_with("axlebox");
    const double bump = std::exp(-std::pow(std::log(f / 75.0) / 0.5, 2.0));
    return {(wheel ? 7.0 : 2.5) * bump - (wheel ? 1.5 : 0.4) * std::exp(-std::pow(std::log(f / 35.0) / 0.4, 2.0)),
            0.25 * bump * std::sin(6.0 * std::log(f)) * (wheel ? 1.0 : 0.4)};
}

ChannelComparison comparison(const std::string& recording, const std::string& channel, double speed) {
    ChannelComparison c{.recording = recording, .channel = channel, .speed_m_per_s = speed};
    const double scale = channel.starts_with("axlebox") ? 1.0 : channel.starts_with("bogie") ? 1e-2 : 1e-4;
    for (int k = 1; k <= 800; ++k) {
        const double f = 0.25 * k;
        const double truth = scale * std::pow(f / 50.0, 1.5) / (1.0 + std::pow(f / 80.0, 6.0)) * speed / 20.0 *
                             (1.0 + 0.6 * std::sin(0.7 * f));
        const double noise = std::exp(0.12 * std::sin(17.3 * k) + 0.1 * std::sin(5.1 * k * k));
        const Differences d = differences(channel, f);
        c.frequency_hz.push_back(f);
        c.measured.push_back(truth * noise);
        c.low.push_back(0.7 * truth * noise);
        c.high.push_back(1.5 * truth * noise);
        c.believed.push_back(truth * std::pow(10.0, -d.believed / 10.0));
        c.retuned.push_back(truth * std::pow(10.0, -d.retuned / 10.0));
        c.diagnosed.push_back(truth);
    }
    for (int band = 0; band <= 23; ++band) {
        const double f = std::pow(10.0, 0.1 * band);
        const Differences d = differences(channel, f);
        const bool silent = channel == "body_centre" && f > 100.0;
        const double nothing = std::nan("");
        c.band_centre_hz.push_back(f);
        c.band_believed_db.push_back(silent ? nothing : d.believed);
        c.band_retuned_db.push_back(silent ? nothing : d.retuned);
        c.band_diagnosed_db.push_back(silent ? nothing : 0.04 * std::sin(9.0 * f));
    }
    return c;
}

const std::vector<std::string>& channel_list() {
    static const std::vector<std::string> list{"axlebox_1", "axlebox_2",  "axlebox_3",   "axlebox_4", "bogie_1",
                                               "bogie_2",   "body_front", "body_centre", "body_rear"};
    return list;
}

UsedRecording used(const std::string& name, double speed) {
    return {.name = name,
            .speed_m_per_s = speed,
            .speed_low = speed - 0.004,
            .speed_high = speed + 0.004,
            .stated_speed_m_per_s = speed * 1.001,
            .payload_kg = 8000,
            .seconds = 60,
            .held_out_seconds = 15,
            .low_hz = 0.5,
            .high_hz = 200,
            .window_s = 4,
            .averages = 21.4,
            .channels = channel_list()};
}

InferredCurve pad_curve() {
    InferredCurve curve{.element = Element::pad, .unit = "N/m"};
    for (int i = 0; i <= 24; ++i) {
        const double f = 10.0 * std::pow(20.0, i / 24.0);
        const std::complex<double> law = 9e7 * std::pow(f / 30.0, 0.15) * std::complex<double>(1.0, 0.24) +
                                         std::complex<double>(0.0, 2.0 * 3.14159 * f * 4.5e4);
        const double width = 2e6 * (1.0 + 30.0 / f + f / 60.0);
        curve.frequency_hz.push_back(f);
        curve.value.push_back(law +
                              std::complex<double>(0.4 * width * std::sin(3.0 * i), 0.4 * width * std::cos(2.0 * i)));
        curve.real_low.push_back(curve.value.back().real() - width);
        curve.real_high.push_back(curve.value.back().real() + width);
        curve.imaginary_low.push_back(curve.value.back().imag() - width);
        curve.imaginary_high.push_back(curve.value.back().imag() + width);
        curve.retuned.emplace_back(1.26e8, 2.0 * 3.14159 * f * 7.8e4);
        curve.diagnosed.push_back(law);
    }
    return curve;
}

RetunedNumber number(const std::string& key, const std::string& unit, double believed, double factor,
                     double tolerance) {
    const double away = std::log(factor) / tolerance;
    return {.key = key,
            .unit = unit,
            .believed = believed,
            .value = believed * factor,
            .low = believed * factor * 0.985,
            .high = believed * factor * 1.015,
            .tolerance = tolerance,
            .tolerances_away = away,
            .outside = std::abs(away) > 2.0};
}

/// What all five have in common.
Diagnosis base() {
    Diagnosis d;
    for (const auto& [name, speed] : {std::pair{"run_60", 16.6667}, std::pair{"run_80", 22.2222}}) {
        for (const std::string& channel : channel_list()) d.channels.push_back(comparison(name, channel, speed));
        d.recordings.push_back(used(name, speed));
    }
    d.recordings[1].faults = {"axlebox_3 is clipped at 196.2 m/s² in 14 samples near 31.2 s"};
    d.recordings[1].channels_not_used = {"cab_microphone: no place in the model"};
    d.not_tested = {"rail-damper with two instances: one was not credible",
                    "sleeper-flexibility: needs the two-layer support"};
    d.rests_on = {"two speeds, 16.67 and 22.22 m/s: structure stays at its frequency, irregularity does not",
                  "the believed irregularity with its tolerance of 3 dB; it was not measured"};
    d.before = {3.43, -12.1};
    d.retuned = {0.143, -0.31};
    d.after = {0.0412, -0.021};
    d.held_out_before = {3.51, -12.6};
    d.held_out_retuned = {0.187, -0.44};
    d.held_out_after = {0.0523, -0.027};
    d.hidden_by_retuning = 0.9741;
    d.numbers = {number("track.pads.stiffness_n_per_m", "N/m", 9e7, 1.04, 0.3),
                 number("track.pads.damping_n_s_per_m", "N·s/m", 4.5e4, 0.97, 0.3),
                 number("vehicle.wheelset_mass_kg", "kg", 1900, 1.012, 0.05),
                 number("contact.constant", "m/N^(2/3)", 5.7e-8, 0.98, 0.15),
                 number("vehicle.primary.stiffness_n_per_m", "N/m", 1.2e6, 1.003, 0.1)};
    d.retuned_numbers = {number("track.pads.stiffness_n_per_m", "N/m", 9e7, 1.46, 0.15),
                         number("track.pads.damping_n_s_per_m", "N·s/m", 4.5e4, 1.74, 0.15),
                         number("vehicle.wheelset_mass_kg", "kg", 1900, 0.93, 0.05),
                         number("contact.constant", "m/N^(2/3)", 5.7e-8, 1.13, 0.15),
                         number("vehicle.primary.stiffness_n_per_m", "N/m", 1.2e6, 0.995, 0.1)};
    d.curves = {pad_curve()};
    d.seconds_taken = 41.7;
    return d;
}

NamedEffect pad_effect() {
    return {.instance = {.effect = "pad-frequency-stiffening", .values = {{"exponent", 0.1512345678901234}}},
            .element = Element::pad,
            .probability = 0.973,
            .says = "the rail pads grow stiffer, and dissipate more, the faster they are deformed",
            .source = "Fenander 1997, J. Rail Rapid Transit 211; Maes et al. 2006; Wei et al. 2016 (10)",
            .parameters = {{"exponent", 0.1512345678901234, 0.134, 0.168, "1"}},
            .nats_fitted = 412.6,
            .nats_held_out = 98.3};
}

std::vector<Rival> rival_list() {
    return {
        {.effects = {"pad-hysteresis"},
         .instances = {{.effect = "pad-hysteresis", .values = {{"loss_factor", 0.231}}}},
         .probability = 0.0173,
         .nats_behind = 14.2,
         .nats_held_out = 88.7,
         .why_not = "its loss at 20 Hz is twice what axlebox_1 & bogie_1 allow",
         .would_separate = "a third speed of 33 m/s, 4 minutes: 11 nats per minute between their predictions"},
        {.effects = {"pad-preload-stiffening", "support-compliance"},
         .instances = {{.effect = "pad-preload-stiffening", .values = {{"strength", 0.71}}},
                       {.effect = "support-compliance", .values = {{"mass_kg", 142}, {"stiffness_n_per_m", 1.1e8}}}},
         .probability = 0.0071,
         .nats_behind = 17.9,
         .why_not = "the strength differs between the recordings by 3.1 standard deviations",
         .would_separate = "the same run with the car empty, 9 minutes"}};
}

}  // namespace

Diagnosis explained() {
    Diagnosis d = base();
    d.verdict = Verdict::explained;
    d.statement =
        "The rail pads stiffen with frequency: exponent 0.151 (90 % interval 0.134 to 0.168). On data that no fit has "
        "seen, the misfit "
        "falls from 3.5 dB (believed) over 0.19 dB (retuned) to 0.05 dB; retuning alone would have needed pads 46 % "
        "too stiff.";
    d.omitted = {pad_effect()};
    d.posterior = {{{"pad-frequency-stiffening"}, 0.973},
                   {{"pad-hysteresis"}, 0.0173},
                   {{"pad-preload-stiffening", "support-compliance"}, 0.0071},
                   {{"unknown"}, 0.0026},
                   {{}, 0.0}};
    d.rivals = rival_list();
    d.places = {{Element::pad, 0.951, 433.1}, {Element::support, 0.0312, 429.7}, {Element::rail, 0.0117, 428.7}};
    d.mismatch = {{"run_80", "axlebox_1", "", 58.0, 92.0, 3.12, 1e-6, Element::pad},
                  {"run_80", "axlebox_1", "axlebox_2", 44.0, 70.0, -0.31, 4e-5, Element::pad},
                  {"run_60", "bogie_<b>&\"2\"", "", 61.0, 83.0, 0.22, 3e-20, Element::pad}};
    // The text of a file may be anything.
    d.channels[5].channel = "bogie_<b>&\"2\"";
    d.recordings[0].channels[5] = "bogie_<b>&\"2\"";
    d.remains = {"0.05 dB near 31 Hz on axlebox_3, where the recording is clipped"};
    return d;
}

Diagnosis ambiguous() {
    Diagnosis d = base();
    d.verdict = Verdict::ambiguous;
    d.statement =
        "Something is missing at the rail pads. Two descriptions explain it equally well; one more speed would tell.";
    d.rivals = rival_list();
    d.rivals[0].probability = 0.52;
    d.rivals[0].nats_behind = 0.0;
    d.rivals[1].probability = 0.44;
    d.rivals[1].nats_behind = 0.17;
    d.posterior = {
        {{"pad-hysteresis"}, 0.52}, {{"pad-preload-stiffening", "support-compliance"}, 0.44}, {{"unknown"}, 0.04}};
    d.places = {{Element::pad, 0.61, 211.0}, {Element::support, 0.33, 210.4}};
    d.mismatch = explained().mismatch;
    return d;
}

Diagnosis consistent() {
    Diagnosis d = base();
    d.verdict = Verdict::consistent;
    d.statement = "The retuned case predicts what was recorded within the accuracy of the recording.";
    d.posterior = {{{}, 0.964}, {{"contact-filter"}, 0.021}, {{"unknown"}, 0.015}};
    d.retuned_numbers = d.numbers;
    d.hidden_by_retuning = std::numeric_limits<double>::quiet_NaN();  // no deficit, no share of it
    d.held_out_before = d.held_out_retuned = d.held_out_after = {std::nan(""), std::nan("")};
    d.curves.clear();
    for (ChannelComparison& c : d.channels) {
        c.diagnosed.clear();
        c.band_diagnosed_db.clear();
    }
    return d;
}

Diagnosis unexplained() {
    Diagnosis d = base();
    d.verdict = Verdict::unexplained;
    d.interrupted = true;
    d.statement =
        "A free correction at the support explains 188 nats, and no effect of the catalogue does as well there.";
    d.posterior = {{{"unknown"}, 0.91}, {{"support-compliance"}, 0.06}, {{}, 0.0}};
    d.places = {{Element::support, 0.78, 188.0}, {Element::pad, 0.14, 186.3}};
    d.mismatch = explained().mismatch;
    d.rivals = {rival_list()[1]};
    d.remains = {"2.1 dB between 40 and 63 Hz on every axle box", "a line at 27.3 Hz that is no multiple of a wheel"};
    return d;
}

Diagnosis recording_fault() {
    Diagnosis d = base();
    d.verdict = Verdict::recording_fault;
    d.statement = "bogie_2 reads 8 % too low in both recordings, and wheel 2 is named as a test of whole numbers.";
    d.omitted = {
        {.instance = {.effect = "sensor-gain", .values = {{"gain", 0.921}}, .choices = {{"channel", "bogie_2"}}},
         .element = Element::sensor,
         .probability = 0.99996,
         .says = "a channel reads too high or too low, or is inverted",
         .source = "every handbook of measurement",
         .parameters = {{"gain", 0.921, 0.919, 0.923, "1"}},
         .nats_fitted = 3410.0,
         .nats_held_out = 911.0},
        {.instance = {.effect = "wheel-out-of-roundness",
                      .values = {{"amplitude_m", 2e-5}},
                      .choices = {{"wheel", "2"}, {"order", "3"}}},
         .element = Element::wheel,
         .probability = 0.98,
         .says = "a wheel is not round",
         .source = "Nielsen & Johansson 2000",
         .parameters = {{"amplitude_m", 2e-5, 1.8e-5, std::numeric_limits<double>::infinity(), "m"}}}};
    d.posterior = {{{"sensor-gain", "wheel-out-of-roundness"}, 0.98}, {{"sensor-gain"}, 0.02}};
    d.places = {{Element::sensor, 0.9999, 3410.0}};
    d.mismatch = {{"", "bogie_2", "", 0.5, 200.0, -0.71, 0.0, Element::sensor}};
    return d;
}

std::vector<Diagnosis> every_verdict() {
    return {explained(), ambiguous(), consistent(), unexplained(), recording_fault()};
}

}  // namespace railpem::app::testing
