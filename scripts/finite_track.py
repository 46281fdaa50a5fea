"""The paper's vehicle on a finite-element rail: a second solution that shares no code with the program.

It exists for what the program cannot be asked: rails that end free, pinned or clamped, trains of several cars, and the
rail between the wheels. Hermite elements of 0.3 m, half the pad spacing; e^{+iωt}; displacements positive downwards.
"""
import dataclasses
import tomllib

import numpy as np
from scipy.linalg import solve_banded

from paper_levels import ROOT

ELEMENT_M = 0.3
CAR_LENGTH_M = 22.8  # over the couplers, type A: the next car's first wheel is 2.4 m behind this car's last
BAND = 3             # two degrees of freedom per node, coupled to the neighbouring node


@dataclasses.dataclass
class Track:
    """`pads` pads, the middle one under the centre of the train; the rail goes `beyond_m` past the last of them."""

    pads: int = 61
    beyond_m: float = 0.3
    end: str = "free"  # free, pinned, clamped, sliding
    cars: int = 1
    car: int = 0       # the one that is observed, counted from the front


def read_case(name):
    with open(ROOT / f"cases/wei2016/{name}.toml", "rb") as file:
        return tomllib.load(file)


def wheels_m(case, track):
    v = case["vehicle"]
    one = np.array([b * v["bogie_distance_m"] / 2 + w * v["wheelbase_m"] / 2 for b in (1, -1) for w in (1, -1)])
    return np.concatenate([one + CAR_LENGTH_M * ((track.cars - 1) / 2 - car) for car in range(track.cars)])


def band_add(band, i, j, value):
    np.add.at(band, (BAND + i - j, j), value)


def beam(nodes, bending, mass):
    """Stiffness and consistent mass of the rail as bands (Przemieniecki 1968, sections 5.6 and 11.4)."""
    h = ELEMENT_M
    k = bending / h**3 * np.array([[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h],
                                   [-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]])
    m = mass * h / 420 * np.array([[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h],
                                   [54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]])
    bands = [np.zeros((2 * BAND + 1, 2 * nodes)) for _ in (k, m)]
    for matrix, band in zip((k, m), bands):
        for e in range(nodes - 1):
            i, j = np.meshgrid(2 * e + np.arange(4), 2 * e + np.arange(4), indexing="ij")
            band_add(band, i.ravel(), j.ravel(), matrix.ravel())
    return bands


def fix_ends(band, end):
    """Springs so stiff that the ends do not move: 1e-7 of a bay's bending stiffness is all they give."""
    held = {"free": [], "pinned": [0, -2], "clamped": [0, 1, -2, -1], "sliding": [1, -1]}[end]
    for i in held:
        band[BAND, i] += 1e16


class Model:
    """One case on one track: the pads as they are compressed under the standing train."""

    def __init__(self, case, track):
        self.case, self.track = case, track
        self.pads_m = 0.6 * (np.arange(track.pads) - (track.pads - 1) / 2)
        self.start_m = self.pads_m[0] - track.beyond_m
        self.nodes = round((track.pads - 1) * 0.6 / ELEMENT_M + 2 * track.beyond_m / ELEMENT_M) + 1
        self.wheels_m = wheels_m(case, track)
        self.pads, self.wheels = self.place(self.pads_m), self.place(self.wheels_m)
        self.stiffness = self.dynamic_pads()

    def place(self, position_m):
        return 2 * np.round((np.asarray(position_m) - self.start_m) / ELEMENT_M).astype(int)

    def dynamic_pads(self):
        p, t = self.case["track"]["pads"], self.case["track"]["static"]
        secant = np.full(len(self.pads), p["dynamic_to_static_ratio"] * p["static_stiffness_n_per_m"])
        if p["preload_strength"] == 0.0:
            return secant
        curve = np.polynomial.Polynomial(p["force_polynomial_n"])
        rail = self.case["track"]["rail"]
        area = t.get("second_moment_of_area_m4", rail["second_moment_of_area_m4"])
        band, _ = beam(self.nodes, rail["youngs_modulus_pa"] * area, 1.0)
        load = np.zeros(2 * self.nodes)
        load[::2] += t["rail_weight_kg_per_m"] * 9.80665 * ELEMENT_M
        load[[0, -2]] /= 2
        np.add.at(load, self.pads, t["clip_preload_n"])
        np.add.at(load, self.wheels, t["wheel_load_n"])
        u = np.zeros(2 * self.nodes)
        u[::2] = 1.8e-3
        for _ in range(50):  # Newton; the ends are left free, as in the published statics nothing is said of them
            tangent = band.copy()
            band_add(tangent, self.pads, self.pads, curve.deriv()(u[self.pads]))
            right = load.copy()
            np.add.at(right, self.pads, curve.deriv()(u[self.pads]) * u[self.pads] - curve(u[self.pads]))
            step = solve_banded((BAND, BAND), tangent, right) - u
            u += step
            if np.abs(step).max() < 1e-13:
                return p["dynamic_to_static_ratio"] * curve.deriv()(u[self.pads])
        raise RuntimeError("the static equilibrium was not found")

    def responses(self, frequencies, places_m=()):
        """Acceleration PSD of the observed car's wheels, rail under them, bogies, and the rail at `places_m`."""
        case, rail, pads = self.case, self.case["track"]["rail"], self.case["track"]["pads"]
        stiffness, mass = beam(self.nodes, rail["youngs_modulus_pa"] * rail["second_moment_of_area_m4"], rail["mass_kg_per_m"])
        fix_ends(stiffness, self.track.end)
        g = 3.86e-8 * case["vehicle"]["wheel_radius_m"] ** -0.115
        contact = g / (1.5 * np.cbrt(case["track"]["static"]["wheel_load_n"]))
        speed = case["running"]["speeds_m_per_s"]
        lag = (self.wheels_m[0] - self.wheels_m) / speed
        forces = np.zeros((2 * self.nodes, len(self.wheels)))
        forces[self.wheels, np.arange(len(self.wheels))] = 1.0
        mine = slice(4 * self.track.car, 4 * self.track.car + 4)
        places = self.place(places_m)
        rows = []
        for f in frequencies:
            w = 2 * np.pi * f
            dynamic = (stiffness - w * w * mass).astype(complex)
            band_add(dynamic, self.pads, self.pads, self.stiffness * (f / pads["reference_frequency_hz"]) ** pads["exponent"]
                     + 1j * w * pads["damping_n_s_per_m"])
            under = solve_banded((BAND, BAND), dynamic, forces)
            vehicle = np.linalg.inv(vehicle_stiffness(case["vehicle"], w))
            total = under[self.wheels] + np.kron(np.eye(self.track.cars), vehicle[6:, 6:]) + contact * np.eye(len(lag))
            load = np.linalg.solve(total, np.exp(-1j * w * lag) * np.sqrt(irregularity(case, f, speed)))
            car = vehicle[:, 6:] @ load[mine]
            rows.append(np.abs(np.concatenate([car[6:], under[self.wheels[mine]] @ load, car[[2, 4]], under[places] @ load])) ** 2 * w**4)
        names = [f"{what}_{i}" for what in ("wheel", "rail") for i in (1, 2, 3, 4)] + ["bogie_1", "bogie_2"]
        columns = dict(zip(names + [f"place_{i + 1}" for i in range(len(places))], np.array(rows).T))
        return {"frequency_hz": np.asarray(frequencies), **columns}


def vehicle_stiffness(v, w):
    """Dynamic stiffness of half the car: body, two bogies (heave and pitch each), four wheels."""
    d = -w * w * np.diag(0.5 * np.array(
        [v["body_mass_kg"], v["body_pitch_inertia_kg_m2"]] + 2 * [v["bogie_mass_kg"], v["bogie_pitch_inertia_kg_m2"]]
        + 4 * [v["wheelset_mass_kg"]])).astype(complex)
    primary, secondary = (v[s]["stiffness_n_per_m"] + 1j * w * v[s]["damping_n_s_per_m"] for s in ("primary", "secondary"))
    for bogie, side in ((0, 1), (1, -1)):
        lever = np.zeros(10)
        lever[[0, 1, 2 + 2 * bogie]] = 1, side * v["bogie_distance_m"] / 2, -1
        d += secondary * np.outer(lever, lever)
        for axle, ahead in ((0, 1), (1, -1)):
            lever = np.zeros(10)
            lever[[2 + 2 * bogie, 3 + 2 * bogie, 6 + 2 * bogie + axle]] = 1, ahead * v["wheelbase_m"] / 2, -1
            d += primary * np.outer(lever, lever)
    return d


def irregularity(case, f, speed):
    """Equation (9) alone: all that is quoted lies above 22 Hz, where wavelengths are below 1 m."""
    band = case["irregularity"]["band"][1]
    n = f / speed
    inside = band["shortest_wavelength_m"] <= 1 / n <= band["longest_wavelength_m"]
    return inside * band["coefficient_m3"] * n ** -band["exponent"] / speed


def solve(track, frequencies=np.arange(200, 1001) / 10, places_m=()):
    """Spectra of the paper's cases in the form of paper_levels.read_spectra()."""
    return {name: Model(read_case(name), track).responses(frequencies, places_m)
            for name in ("case1", "case2", "case3", "case3_consistent")}
