#pragma once
// Recordings without time series whose numbers are not what their description says: a factor of units, a sign, a
// conjugate, another quantity.

#include <string>
#include <vector>

#include "diagnosis/observations/believed_case.hpp"
#include "diagnosis/observations/observation.hpp"

namespace railpem::diagnosis {

/// What was done to the values of one channel: recorded = factor·(iω)^derivatives·right, conjugated where that is said.
struct SpoiledChannel {
    std::string recording, channel;
    double factor = 1.0;      ///< of amplitudes; of decay rates themselves. Negative: the sign is inverted
    int derivatives = 0;      ///< receptance: 1 a mobility, 2 an accelerance
    bool conjugated = false;  ///< receptance with its phase
    double off_db = 0.0;      ///< rms difference from the believed case as recorded
    double left_db = 0.0;     ///< and with all that undone
    std::string says;         ///< one sentence
};

/// Finds what such slips explain of the difference from the believed case, and undoes it in `observations`. A slip is
/// taken for one where it removes three quarters of a difference (rms over all values, a radian of phase counting as a
/// neper) that is larger than a factor of two in level or half a radian: physics bends a curve, a slip moves it as it
/// is.
std::vector<SpoiledChannel> undo_spoiling(const BelievedCase& believed, std::vector<Observation>& observations);

}  // namespace railpem::diagnosis
