#pragma once
// Every number that steers how a recording becomes what the likelihood sees, in one place.

#include <cstddef>

#include "diagnosis/expectation/expectation_settings.hpp"

namespace railpem::diagnosis {

/// Bands, grids, accuracies that nobody states, and what is held out.
struct ObservationSettings {
    // Time series.

    /// of the end of a record, of the recordings of one quantity of the track, and of the third-octaves of a scalar
    /// recording: what no fit sees. Chosen; not calibrated
    double held_out_share = 0.25;
    /// relative standard deviation of a stated speed without a standard error. Chosen; not calibrated
    double speed_tolerance = 0.005;
    /// share of the weighted phases that a speed read from delays has to explain. Chosen: a third of what a sound
    /// record has
    double least_speed_agreement = 0.3;
    /// relative rms of a speed that counts as one speed: it costs 2e-4 of the coherence of wheels 160 cycles apart.
    /// Judged on records of constant speed, of which axle boxes read 1.3e-6 and bogies alone 7e-6
    double least_speed_change = 2e-5;
    /// largest over least speed of a piece in which a record is observed: what a train feels of the track's passing at
    /// one speed still holds. Chosen; not calibrated
    double widest_speed_range = 1.25;
    /// s, of a piece: its last quarter is one window. Chosen
    double shortest_piece_s = 20.0;
    /// relative amplitude by which every sensor errs by itself, and every simulator by its step: added to what was
    /// recorded and to what is expected, so that nothing is read from less than 50 dB below a level. Chosen: a third of
    /// the transverse sensitivity of a good accelerometer (ISO 5347-11)
    double sensor_error = 3e-3;
    /// bins of a usable band. Chosen; not calibrated
    std::size_t fewest_bins = 20;
    /// a band ends this much inside of what the irregularity excites. Chosen; not calibrated
    double band_edge = 0.9;
    /// of the sampling rate, up to which a channel is used. Chosen; not
    /// calibrated
    double highest_of_rate = 0.4;
    /// Hz, grid of the transfers: what an axle box leaves unsaid by the others, 1e-5 of its power, is met within 2 %.
    /// Judged, on expectations on finer grids (expectation_grid_test.cpp)
    double transfer_step_hz = 0.125;
    /// Hz, the same in short windows: it leaves out 3e-5 of that power, nothing where the floor is a tenth. Judged
    /// likewise
    double coarse_transfer_step_hz = 0.5;
    /// the quietest bin but one in so many is the first guess of a channel's noise. Chosen; not calibrated
    std::size_t quietest_of = 50;

    // What stands beside a time series.

    /// kg, what shakes as the bogies do, as the reference of forces of a suspension's own. Chosen: a ton
    double reference_mass_kg = 1000.0;
    /// factor of frequency to either side of a node of those forces. Derived: half an octave
    double reference_side = 1.41;
    /// factor of frequency to either side of a bin, over which recorded and believed power are compared. Derived: a
    /// sixth of an octave
    double comparison_side = 1.1225;

    // A measured irregularity.

    /// deviation in log power that no node goes below: what a running surface changes between two runs. Chosen; not
    /// calibrated
    double least_node_deviation = 0.02;
    /// deviation of a spectrum that does not say what it rests on. Chosen; not calibrated
    double table_deviation = 0.1;
    /// share of a node's band that a measurement has to reach. Chosen; not calibrated
    double covered_share = 0.9;

    // Scalar recordings: deviations are of the logarithm.

    double spectrum_deviation = 0.10;    ///< of a level whose accuracy nobody states. Chosen; not calibrated
    double receptance_deviation = 0.05;  ///< of a hammer test. Chosen; not calibrated
    double decay_deviation = 0.15;       ///< of a decay rate in a third-octave: reproducibility of EN 15461
    double least_deviation = 1e-3;       ///< that no value goes below. Chosen; not calibrated
    /// of the mean level of the third-octave, added to levels so that zeros between wheels do not count: 13 dB below
    /// it. Chosen; not calibrated
    double pedestal = 0.05;
    /// lines beside the passing of sleepers that are left out: they depend on the window. Chosen; not calibrated
    double passing_reach_lines = 3.0;
    int first_held_out_band = 2;  ///< counted from 0: the third-octave that is held out first. Chosen; not calibrated
    /// per octave, cells within which values share their discrepancy. Chosen; not calibrated
    double discrepancy_cells = 12.0;

    /// One third-octave in so many is held out.
    constexpr int held_out_band() const { return static_cast<int>(1.0 / held_out_share); }
};

inline constexpr ObservationSettings kObservationSettings{};

/// What a caller chooses for a recording.
struct ObservationOptions {
    /// long windows see finer differences; shorter ones forgive (diagnosis README). Chosen; not calibrated
    double window_s = 4.0;
    /// where the likelihood is tempered. Judged: in 1 s both effects of the paper are no longer told from one
    double coarse_window_s = 2.0;
    double low_hz = 2.0;  ///< below, a minute has too few waves. Chosen; the floor's first node stands there
    double high_hz = kExpectationSettings.band_high_hz;
    double held_out_share = kObservationSettings.held_out_share;  ///< of the end of the record, seen by no fit
};

}  // namespace railpem::diagnosis
