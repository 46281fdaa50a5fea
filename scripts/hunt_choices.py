"""What Wei et al. (2016) leave open, as settings of the case: the rows of docs/paper/hunt.md.

A choice is a label, the reason why it is one, and a function that gives the spectra of the four cases under it.
"""
import dataclasses
import math
from collections.abc import Callable

import numpy as np

import finite_track
import paper_levels
from paper_levels import CASES

WHEEL_LOAD_TABLE_1_N = (38500 + 2 * 2980 + 4 * 1350) / 8 * 9.81


def worn(radius):
    """Contact constant of a worn tread and of a new, conical one, m/N^(2/3) (Zhai 2007)."""
    return 3.86e-8 * radius**-0.115


def new(radius):
    return 4.57e-8 * radius**-0.149


def lighter(constant):
    """The contact constant that gives with 80 kN the stiffness (8) that `constant` gives with the masses of Table 1."""
    return constant * (80e3 / WHEEL_LOAD_TABLE_1_N) ** (1 / 3)


@dataclasses.dataclass
class Choice:
    label: str
    spectra: Callable[[], dict]
    places: dict = dataclasses.field(default_factory=dict)  # which columns are compared


def with_settings(label, *settings):
    return Choice(label, lambda: paper_levels.solve([*COMMON, *settings]))


def finite(label, places_m=(), places=None, **track):
    return Choice(label, lambda: finite_track.solve(finite_track.Track(**track), places_m=places_m), places or {})


COMMON = ["frequency.from_hz=20", "frequency.to_hz=100"]  # every quoted number lies between 37 and 85 Hz


def modal(pads, modes):
    return ["solver.rail=modal", f"solver.pads={pads}", f"solver.modes={modes}"]


def contact(constant):
    return f"contact.constant_m_per_n23={constant!r}"


def mean_of_wheels():
    spectra = paper_levels.solve(COMMON)
    for table in spectra.values():
        for place, count in (("wheel", 4), ("rail", 4), ("bogie", 2)):
            table[f"{place}_mean"] = np.mean([table[f"{place}_{i + 1}"] for i in range(count)], axis=0)
    return spectra


def smoothed(width_hz):
    """Spectra averaged over `width_hz`, as a periodogram of a short record would give them."""
    spectra = paper_levels.solve(COMMON)
    for table in spectra.values():
        lines = round(width_hz / 0.1) | 1
        for place in ("wheel_1", "rail_1", "bogie_1"):
            padded = np.pad(table[place], lines // 2, mode="edge")
            table[place] = np.convolve(padded, np.full(lines, 1 / lines), mode="valid")
    return spectra


def without_dashpot():
    """The dashpot of Table 2 in case 1 only: (10) and (11) do not mention it."""
    growing = [case for case in CASES if case != "case1"]
    return {**paper_levels.solve(COMMON, cases=["case1"]),
            **paper_levels.solve([*COMMON, "track.pads.damping_n_s_per_m=0"], cases=growing)}


def everywhere(place):
    return {what: f"{what}_{place}" for what in ("wheel", "rail")}


SINGLE = {
    "Contact constant G, equations (4) to (8); not given": [
        with_settings("worn tread, R = 0.46 m", contact(worn(0.46))),
        with_settings("new tread, R = 0.42 m", contact(new(0.42))),
        with_settings("new tread, R = 0.46 m", contact(new(0.46))),
        with_settings("worn tread, diameter taken for the radius", contact(worn(0.84))),
        with_settings("worn tread, K_h with 61 kN (Table 1) for 80 kN", contact(lighter(worn(0.42)))),
        with_settings("new tread, K_h with 61 kN (Table 1) for 80 kN", contact(lighter(new(0.42)))),
        with_settings("2.5e-8 (no source; for scale)", contact(2.5e-8)),
    ],
    "Weight; Table 1 adds up to 489 kN, the text says 640 kN": [
        with_settings("61 kN per wheel in statics and contact", f"track.static.wheel_load_n={WHEEL_LOAD_TABLE_1_N}"),
        with_settings("car body loaded to 640 kN", f"track.static.wheel_load_n={WHEEL_LOAD_TABLE_1_N}", "vehicle.payload_kg=15400"),
        with_settings("rail weight 60.64 kg/m in the statics", "track.static.rail_weight_kg_per_m=60.64"),
    ],
    "Pads": [
        with_settings("Table 3's 37.4 kN/mm for 1.4 × 26.7", f"track.pads.static_stiffness_n_per_m={37.4e6 / 1.4}"),
        with_settings("causal form of (10), 1 + i·tan(πk/2)", "track.pads.causal=true"),
        Choice("no dashpot where the stiffness grows with frequency", without_dashpot),
    ],
    "Wheels and rail": [
        with_settings("wheels between the pads", "track.wheel_offset_m=0.3"),
        with_settings("moving wheels (the paper: none)", "solver.moving=true"),
    ],
    "Modes of the simply supported rail; 61 pads": [
        with_settings(f"{modes} modes", *modal(61, modes)) for modes in (30, 40, 50, 60, 80, 100)],
    "Length of the simply supported rail; 3 modes per metre": [
        with_settings(f"{pads} pads: the rail ends {(pads - 34) * 0.3 :.1f} m beyond the outer wheels", *modal(pads, round(1.8 * pads)))
        for pads in (35, 37, 39, 41, 43, 45, 51)],
    "Ends of the rail, by finite elements": [
        finite("61 pads, free (no choice: the endless rail once more)"),
        *(finite(f"{pads} pads, {end}", pads=pads, end=end) for pads in (37, 39, 41) for end in ("free", "pinned", "sliding", "clamped")),
    ],
    "Neighbouring cars, 22.8 m over the couplers, by finite elements": [
        finite("leading car of two", pads=99, cars=2, car=0),
        finite("second car of two", pads=99, cars=2, car=1),
        finite("middle car of three", pads=137, cars=3, car=1),
    ],
    "Place of the responses": [
        *(Choice(f"wheel {i} and its rail", lambda: paper_levels.solve(COMMON), everywhere(i)) for i in (2, 3, 4)),
        Choice("mean over the wheels, the rail under them, the bogies", mean_of_wheels, {**everywhere("mean"), "bogie": "bogie_mean"}),
        finite("rail half a bay ahead of wheel 1", places_m=[10.5], places={"rail": "place_1"}),
        finite("rail half a bay behind wheel 1", places_m=[9.9], places={"rail": "place_1"}),
        finite("rail between the wheels of a bogie", places_m=[9.0], places={"rail": "place_1"}),
    ],
    "Irregularity": [
        with_settings("(9) read as two-sided", "irregularity.band[2].coefficient_m3=0.072e-6"),
        with_settings("result two-sided", "irregularity.band[2].coefficient_m3=0.018e-6"),
        with_settings("(9) read per rad/m", f"irregularity.band[2].coefficient_m3={0.036e-6 * (2 * math.pi) ** -2.15}"),
        with_settings("FRA down to 0.1 m, (9) on top of it", "irregularity.band[1].shortest_wavelength_m=0.1"),
    ],
    "Frequency resolution": [
        with_settings("lines every 0.5 Hz", "frequency.step_hz=0.5"),
        Choice("averaged over 0.5 Hz", lambda: smoothed(0.5)),
        Choice("averaged over 1 Hz", lambda: smoothed(1.0)),
    ],
}


def combinations():
    """Contact × place of the wheels × end of the rail, each by the program."""
    constants = {"worn": worn(0.42), "worn, 61 kN": lighter(worn(0.42)), "new": new(0.42)}
    for name, constant in constants.items():
        for offset in (0.0, 0.3):
            for pads, per_metre in [(0, 0), *((pads, n) for pads in (37, 39, 43, 61) for n in (1.6, 3.0))]:
                rail = modal(pads, round(per_metre * pads * 0.6)) if pads else []
                track = f"{pads} pads, {per_metre:g} modes/m" if pads else "endless"
                yield with_settings(f"{name}; {'between' if offset else 'over'} pads; {track}",
                                    contact(constant), f"track.wheel_offset_m={offset}", *rail)


# What the paper states. Varied only to see which of them the residual points at; nothing of it is adopted.
STATED = {
    "C_p": ("track.pads.damping_n_s_per_m", 7.5e4),
    "1.4 × 26.7 and 1.4 × K(S)": ("track.pads.dynamic_to_static_ratio", 1.4),
    "I_r in the dynamics": ("track.rail.second_moment_of_area_m4", 3.22e-5),
    "m_r": ("track.rail.mass_kg_per_m", 60.64),
    "M_w": ("vehicle.wheelset_mass_kg", 1350.0),
    "M_t": ("vehicle.bogie_mass_kg", 2980.0),
    "J_t": ("vehicle.bogie_pitch_inertia_kg_m2", 3600.0),
    "K_pz": ("vehicle.primary.stiffness_n_per_m", 2.1e6),
    "C_pz": ("vehicle.primary.damping_n_s_per_m", 4.9e4),
    "coefficient of (9)": ("irregularity.band[2].coefficient_m3", 0.036e-6),
    "exponent of (9)": ("irregularity.band[2].exponent", 3.15),
}
