#pragma once
// The track alone as the files that the contract with the user names.

#include "app/number_table.hpp"
#include "pem/coupling/track_response.hpp"

namespace railpem::app {

/// The *.receptance.csv table: frequency_hz, then real and imaginary part over a pad and in the middle of a bay, m/N.
NumberTable receptance_table(const pem::TrackResponse& response);

/// The *.decay.csv table: nominal centre_hz of every third-octave (IEC 61260, base ten) that lies wholly within the
/// lines of the response and holds at least three of them, decay rate of EN 15461 and of the far-reaching Bloch wave,
/// dB/m.
NumberTable decay_table(const pem::TrackResponse& response, double spacing_m);

}  // namespace railpem::app
