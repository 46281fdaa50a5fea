#pragma once
// Every number that steers how a fit climbs, in one place.

#include <array>

namespace railpem::diagnosis {

/// Steps, damping, patience and the ladder of a fit; nats are of log-posterior. FitOptions holds them, and what else a
/// caller asks of one fit.
struct FitSettings {
    // Where a fit begins and ends.

    int iterations = 20;      ///< at the last stage: times that derivatives are taken. Chosen; not calibrated
    double least_gain = 0.1;  ///< nats: the fit ends when a step promises less. Chosen; not calibrated
    /// of the nats that a case leaves unexplained, which a step has to promise: what gains less lacks physics, and
    /// creeps along ridges. Chosen; not calibrated
    double patience = 1e-4;
    /// the same of the retuned case: where it leaves much, thousands of nats tell it from the rest, and what goes on
    /// from it begins with a tempered likelihood. Chosen; not calibrated
    double retuning_patience = 1e-3;

    // The ladder of tempered likelihoods.

    /// relative floors of the rungs: with 10 % there is one broad maximum, each rung brings the next within reach.
    /// Chosen; not calibrated
    std::array<double, 3> ladder{0.1, 0.02, 0.004};
    int rung_iterations = 2;  ///< at each rung. Chosen; not calibrated
    /// then with the lines held: what a climb gains by holding them longer is lost when it lets them go. Judged
    /// on multi-start climbs
    int held_iterations = 8;
    double rung_gain = 3.0;  ///< nats that a step has to promise there: that top is not the one that counts. Chosen
    /// and of the nats that are left unexplained there. Judged: both effects of the paper, retuned without them, took
    /// ten steps of 50 nats of 113 000 with the lines held
    double rung_patience = 1e-3;
    double width_step = 1.0;  ///< widths of lines are first tried a factor e apart. Chosen; not calibrated
    std::array<double, 2> finer_width_steps{0.5, 0.25};  ///< and then about the best. Chosen

    // Damping (Levenberg), relative.

    double first_damping = 1e-3, least_damping = 1e-9, most_damping = 1e6;  ///< chosen; not calibrated
    double damping_factor = 10.0;  ///< from step to step. Chosen; not calibrated

    // How long a step may be.

    double longest_step = 3.0;  ///< in deviations of the belief. Chosen; not calibrated
    /// of noise, floor and what wheels meet alone, in their logarithms: far below what shows, their slope promises
    /// anything. Chosen
    double longest_log_step = 1.0;
    /// of a number's logarithm: where a belief is as wide as a factor of two, three deviations led past the nearest
    /// top, to the bounds of numbers (Fit.WideBeliefsAreClimbedInShortSteps). Judged: 0.35 and 0.5 did the same, 0.7
    /// went too far on one of two kilometres of real track
    double longest_number_step = 0.5;
    /// of a step, to which its direction is followed. Judged: with 5 most places that far along were worse than the
    /// step itself
    double longest_share = 3.0;
    /// of a step's gain, that another place along it has to promise beyond: looking costs one prediction, the
    /// derivatives of another step thirty. Judged on that cost
    double worth_looking = 0.2;

    // What is made of a step.

    int settle_iterations = 3;    ///< of noise and floor alone, after every step. Chosen; not calibrated
    double worth_settling = 2.0;  ///< nats promised by a step, after which noise and floor are settled. Chosen
    /// of `least_gain`: what an undamped last step has to promise to be made. Chosen; not calibrated
    double worth_finishing = 0.1;
    /// of what a step by carried derivatives promised, that it has to bring for them to be carried on; and the other
    /// way round. Chosen; not calibrated
    double worth_carrying = 0.7;
    int most_carried = 6;  ///< steps. Chosen; not calibrated
    /// nats that letting go of a bound has to gain (bounded_step.hpp). Derived: above rounding
    double worth_letting_go = 1e-9;
    long turns_per_unknown = 10;  ///< of the search within bounds: rounding may let go and stop for ever. Chosen

    // When a fit is dropped behind a rival.

    double hope = 3.0;  ///< times its promise, a fit may still climb. Chosen; not calibrated
    /// or times what its last step brought: a ridge is climbed in many equal steps. Chosen; not calibrated
    double pace = 12.0;
    double surprise = 1.5;         ///< times what a step promised: such a climb is not dropped yet. Chosen
    double dropped_behind = 30.0;  ///< nats that a fit must stay behind, hope included. Chosen; not calibrated
    /// the same where the likelihood is tempered, lines are held and a rival's are not. Judged: a rail that shears
    /// stayed 54 behind a damper there, and came out 1100 ahead
    double dropped_behind_tempered = 300.0;

    // Recordings that are drawn (synthesis.hpp).

    double drawn_rate_hz = 1000.0;           ///< sampling rate. Chosen
    double drawn_noise_rms_m_per_s2 = 0.02;  ///< first guess, rms up to half the sampling rate. Chosen
};

inline constexpr FitSettings kFitSettings{};

}  // namespace railpem::diagnosis
