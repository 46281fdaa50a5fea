#pragma once
// Every number that steers how an expectation is computed, in one place.

namespace railpem::diagnosis {

/// Grids, reaches and thresholds of an expectation: its accuracy against its cost. What a caller chooses for a
/// recording is in ExpectationOptions.
struct ExpectationSettings {
    // The band and the grids.

    /// Hz, where the band of a diagnosis ends; the floor's last node stands there. Chosen; not calibrated
    double band_high_hz = 175.0;
    /// Hz, between the lines at which a rail on pads is solved: it is smoother than the vehicle. Chosen; not calibrated
    double rail_step_hz = 2.0;
    /// lines in the half-power width of the narrowest mode of the vehicle, until which the grid of the transfers is
    /// halved. Chosen; not calibrated
    double lines_per_width = 3.0;
    /// of that grid's step: it is not halved further. Chosen; not calibrated
    double finest_step = 1.0 / 16.0;
    /// of the mass that a mode hangs on (or of a mode's, the mass that feels it): lighter ones do not narrow the grid.
    /// Judged on probes of the screening, which are held against the case without them on the same grid
    double least_felt_mass = 1e-3;
    /// bins that the window's kernel reaches. Derived: a Hann window leaves 5e-8 outside
    int kernel_reach_bins = 6;

    // Sources.

    /// of the strongest order of the modulation by equal seats: weaker ones are left out, 20 dB below what is itself
    /// 30 dB below the irregularity. Derived from those levels
    double least_order = 0.1;
    /// deviations of a line's frequency beyond the kernel, to which it is smeared. Derived: the outermost node of the
    /// five-point rule lies at 2.857
    double line_reach_deviations = 3.0;
    /// ratio of power over a line's cell, from which on an edge of a band is sought in it. Chosen; not calibrated
    double suspicious_ratio = 1.2;
    /// ratio between neighbouring lines, from which on their cells are looked at; well below `suspicious_ratio`.
    /// Chosen; not calibrated
    double look_ratio = 1.1;
    /// ratio over next to nothing, that no smooth spectrum has: an edge. Chosen; not calibrated
    double edge_ratio = 1.01;
    /// halvings of a cell in search of an edge. Derived: 2^−50 of a cell is what rounding leaves
    int edge_halvings = 50;

    // A speed that changes.

    /// speeds of equal weight over which powers and lines are means. Derived: neighbours of a spread of one per cent
    /// are less than a bin apart below 500 Hz
    std::size_t speed_nodes = 24;
    /// s, between the times at which the speed of a record counts. Derived: a train changes it by 3e-4 meanwhile
    double speed_step_s = 0.1;
    /// factor and Hz beyond the band, to which the coherence of wheels is tabulated: fine lines reach beyond it, and a
    /// fit moves the speed. Derived from the kernel's reach and from the bound of a speed
    double coherence_reach = 1.3, coherence_reach_hz = 5.0;
    /// relative reach of frequency over which the slope of the irregularity's power is taken. Chosen; not calibrated
    double slope_reach = 0.03;
    /// bound of that slope, both ways: beyond is an edge of a band, which no power law describes. Chosen
    double steepest_slope = 8.0;

    // Channels.

    /// m: a sensor on the body counts as over the pivot or at the centre within this. Chosen; not calibrated
    double over_the_pivot_m = 0.25;
};

inline constexpr ExpectationSettings kExpectationSettings{};

}  // namespace railpem::diagnosis
