#pragma once
// Which promises deserve a refit.

#include <string>
#include <vector>

#include "diagnosis/hypotheses/screen.hpp"

namespace railpem::diagnosis {

/// One variant of an effect with the starting points that promise most.
using Starts = std::vector<Promise>;

/// Nats of what replaces a law of the case that deserve a refit: its strength says nothing, for everything else settles
/// anew around it.
inline constexpr double kLeastReplacing = 30.0;

/// Nats to first order for which a belief is worth giving up: what a wrong belief distorts is seen too small from
/// there.
inline constexpr double kLeastRelease = 3.0;

/// The same of an effect that only gives up a belief (Effect::retuned): sleeper passing nine times as strong
/// promised 3.3 and brought 190, three times as strong 1.8. Its power grows with the square.
inline constexpr double kLeastOfABelief = 1.5;

/// Times its promise that it may bring (190 of 3.3): where thousands of nats are asked beside a law that is an
/// approximation, what promises ten is not fitted. What promises more is, and given up by SetTrials::try_set() (253
/// beside 1 kN of friction, which brought 45 of 3400).
inline constexpr double kMostOfABelief = 60.0;

/// What is worth a refit: at most `most` variants of `least` nats or more (where an effect only gives up a belief: of
/// kLeastOfABelief, and of what can become `least`), few per kind, few starting points per variant. `promises` as
/// screen() sorts them.
std::vector<Starts> worth_refitting(const std::vector<Promise>& promises, const std::vector<Candidate>& candidates,
                                    double least, int most);

/// Starts that compete before one of them is climbed. The best two distances of a comb do not: where each begins says
/// little of where it ends (joints every 12 m began 3 nats behind those every 25 m, and brought 800 nats where those
/// brought 27).
std::vector<Starts> climbed_apart(const Starts& starts, const std::vector<Candidate>& candidates);

/// Adds to `chosen` what replaces a law wherever something else at its place is worth a refit, or one of the numbers
/// `released` there is worth giving up: a rail that shears looks like one that bends more easily.
void add_replacing(const std::vector<Promise>& promises, const std::vector<Candidate>& candidates,
                   const std::vector<std::string>& released, std::vector<Starts>& chosen);

/// Adds everything that replaces a law of the case: no derivative at nothing can promise it.
void add_unpromised(const std::vector<Promise>& promises, const std::vector<Candidate>& candidates,
                    std::vector<Starts>& chosen);

/// At most `most` numbers of a fit, not `released` already, whose belief the data push against by `least` nats to first
/// order.
std::vector<std::string> worth_releasing(const Fit& fit, const std::vector<std::string>& released, double least,
                                         int most);

}  // namespace railpem::diagnosis
