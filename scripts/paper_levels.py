"""The twelve levels and six frequencies that Wei et al. (2016) quote, read off computed spectra in one defined way.

A level that the paper calls a maximum is the largest value within 1.5 Hz of its frequency: the spectra are a comb with a
tooth every v/2.4 m = 9.26 Hz, and two teeth of it may be nearly equal. A level at a stated frequency is interpolated there.
"""
import csv
import dataclasses
import math
import pathlib
import subprocess
import tempfile

import numpy as np

import paper_values as paper

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/railpem"
CASES = ["case1", "case2", "case3", "case3_consistent"]
VARIANTS = {"case3": "as published", "case3_consistent": "Table 2 throughout"}
PEAK_WINDOW_HZ = 1.5
CASE_NAMES = ("case1", "case2", "case3")


@dataclasses.dataclass
class Level:
    """One quoted number beside the computed one; `frequency_hz` is where the paper quotes it."""

    label: str
    frequency_hz: float
    paper: float
    computed: float
    unit: str = "m²/s⁴/Hz"

    @property
    def ratio(self):
        return self.computed / self.paper


@dataclasses.dataclass
class Peak:
    """One quoted dominant frequency, the local maximum next to it and the largest value of the whole spectrum."""

    label: str
    paper_hz: float
    local_hz: float
    global_hz: float

    @property
    def same_tooth(self):
        """Whether the spectrum is highest where the paper says."""
        return abs(self.global_hz - self.paper_hz) <= PEAK_WINDOW_HZ + 1e-9


@dataclasses.dataclass
class Comparison:
    levels: list
    peaks: list

    @property
    def rms_log_ratio(self):
        return math.sqrt(sum(math.log(level.ratio) ** 2 for level in self.levels) / len(self.levels))

    @property
    def teeth(self):
        """How many of the six spectra are highest where the paper says."""
        return sum(peak.same_tooth for peak in self.peaks)


def read_table(path):
    """A CSV table as columns by name."""
    with open(path, newline="") as file:
        names = next(csv.reader(line for line in file if not line.startswith("#")))
    values = np.loadtxt(path, delimiter=",", skiprows=1, ndmin=2)
    return {name: values[:, i] for i, name in enumerate(names)}


def read_spectra(folder, cases=CASES):
    """The acceleration spectra in the folder: by case, by place (wheel_1, …), with frequency_hz."""
    ending = "_acceleration_psd_m2_per_s4_per_hz"
    return {case: {name.removesuffix(ending): column for name, column in read_table(folder / f"{case}.psd.csv").items()}
            for case in cases}


def run_program(*arguments):
    """Runs the program; what it refuses is the caller's mistake and ends the script with its message."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)


def solve(settings=(), folder=None, cases=CASES):
    """The spectra of the paper's cases with `settings` (key=value) applied to every one of them."""
    if folder is None:
        with tempfile.TemporaryDirectory() as temporary:
            return solve(settings, pathlib.Path(temporary) / "out", cases)
    options = [part for setting in settings for part in ("--set", setting)]
    run_program("solve", *(ROOT / f"cases/wei2016/{case}.toml" for case in cases), "--out", folder, *options)
    return read_spectra(folder, cases)


def compare(spectra, third="case3", wheel="wheel_1", rail="rail_1", bogie="bogie_1"):
    """The twelve levels and six frequencies with the variant `third` as case 3, at the given places."""
    chosen = {"case1": spectra["case1"], "case2": spectra["case2"], "case3": spectra[third]}
    levels, peaks = [], []
    for place, name, quoted in ((wheel, "wheel", paper.WHEEL_PEAKS), (rail, "rail", paper.RAIL_PEAKS)):
        for case in CASE_NAMES:
            frequency, value = quoted[case]
            level, peak = _peak(chosen[case]["frequency_hz"], chosen[case][place], frequency, value)
            level.label = peak.label = f"{name}, case {case[-1]}"
            levels.append(level)
            peaks.append(peak)
    return Comparison(levels + _bogie_levels(chosen, bogie), peaks)


def _peak(frequencies, psd, frequency, value):
    near = np.flatnonzero(np.abs(frequencies - frequency) <= PEAK_WINDOW_HZ + 1e-9)
    highest = near[np.argmax(psd[near])]
    return (Level("", frequency, value, psd[highest]),
            Peak("", frequency, frequencies[highest], frequencies[np.argmax(psd)]))


def _bogie_levels(chosen, bogie):
    """One absolute level at each of the two frequencies, the other two cases relative to it, as the paper quotes them."""
    levels = []
    for (frequency, quoted), first, others in zip(paper.BOGIE_LEVELS.items(), ("case1", "case3"),
                                                  (("case2", "case3"), ("case2", "case1"))):
        computed = {case: np.interp(frequency, chosen[case]["frequency_hz"], chosen[case][bogie]) for case in quoted}
        levels.append(Level(f"bogie, case {first[-1]}", frequency, quoted[first], computed[first]))
        for case in others:
            levels.append(Level(f"bogie, case {case[-1]} / case {first[-1]}", frequency,
                                quoted[case] / quoted[first], computed[case] / computed[first], unit="1"))
    return levels
