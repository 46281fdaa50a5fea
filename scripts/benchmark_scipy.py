#!/usr/bin/env python3
"""The receptance of cases/ballasted/uic60.toml once by `railpem receptance` and once by banded SciPy, in one run.

SciPy solves what a finite-element user would write in an afternoon: 241 supports, exact Timoshenko dynamic-stiffness elements of
half a bay, a banded complex solve per line, force in the middle of the bay in the middle. Its ends are free, not infinite, so
the two agree where vibration has decayed over 72 m. Prints wall and processor times of one core, their ratios, and the
difference of the receptances. railpem's time is that of the whole program: start, static equilibrium,
both receptances, the decay rates with their 29 positions, and the tables; SciPy's is the one receptance alone.

    scripts/benchmark_scipy.py --program build/release/railpem
"""
import argparse
import csv
import json
import os
import pathlib
import subprocess
import tempfile
import time
import tomllib

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(name, "1")  # LAPACK's banded solver gains nothing from threads

import numpy as np
from scipy.linalg import solve_banded

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "cases/ballasted/uic60.toml"


def support_stiffness(track, omega):
    """Pad in series with a sleeper on ballast, N/m."""
    pads, support = track["pads"], track["support"]
    pad = pads["static_stiffness_n_per_m"] * (1 + 1j * pads["loss_factor"])
    below = support["stiffness_n_per_m"] * (1 + 1j * support["loss_factor"]) - support["mass_kg"] * omega**2
    return 1 / (1 / pad + 1 / below)


def timoshenko_element(rail, omega, length):
    """Exact 4×4 dynamic stiffness of (w0, ψ0, w1, ψ1), from the four waves of the beam: forces of the waves times the inverse
    of their displacements."""
    loss = 1 + 1j * rail["loss_factor"]
    b = rail["youngs_modulus_pa"] * loss * rail["second_moment_of_area_m4"]
    s = rail["shear_coefficient"] * rail["shear_modulus_pa"] * loss * rail["cross_section_m2"]
    mu = rail["mass_kg_per_m"] * omega**2
    rotary = mu * rail["second_moment_of_area_m4"] / rail["cross_section_m2"]
    # w = e^{λx}, ψ = gλw: B S λ⁴ + (B μ + S r)λ² − μ(S − r) = 0
    half = 0.5 * (mu / s + rotary / b)
    root = np.sqrt(half**2 + mu / b * (1 - rotary / s))
    waves = np.array([np.sqrt(-half + root), -np.sqrt(-half + root), np.sqrt(-half - root + 0j), -np.sqrt(-half - root + 0j)])
    slope = waves + mu / s / waves  # ψ = w' + μ/(S λ) w from S(w' − ψ)' = −μw
    # Waves that grow are written from the far end, so that no entry is large.
    start = np.where(waves.real > 0, np.exp(-waves * length), 1.0)
    end = np.where(waves.real > 0, 1.0, np.exp(waves * length))
    displacement = np.array([start, slope * start, end, slope * end])
    shear = s * (waves - slope)
    moment = b * slope * waves
    force = np.array([-shear * start, -moment * start, shear * end, moment * end])
    return force @ np.linalg.inv(displacement)


def receptance(track, frequencies, supports):
    """Receptance at the middle node, the middle of a bay (supports even) or over a support (odd), by one banded solve per line."""
    nodes = 2 * supports - 1  # a node over every support and in every bay
    middle = nodes // 2
    size = 2 * nodes
    result = np.empty(len(frequencies), complex)
    for line, frequency in enumerate(frequencies):
        omega = 2 * np.pi * frequency
        element = timoshenko_element(track["rail"], omega, 0.5 * track["spacing_m"])
        band = np.zeros((7, size), complex)
        for row in range(4):
            for column in range(4):
                first = slice(column, column + 2 * (nodes - 1), 2)
                band[3 + row - column, first] += element[row, column]
        band[3, 0::4] += support_stiffness(track, omega)
        load = np.zeros(size)
        load[2 * middle] = 1.0
        result[line] = solve_banded((3, 3), band, load, overwrite_ab=True, check_finite=False)[2 * middle]
    return result


class Stopwatch:
    """Wall and processor time of what runs within, own process and children."""

    def __enter__(self):
        self.begin = (time.perf_counter(), self.processor())
        return self

    def __exit__(self, *unused):
        self.wall = time.perf_counter() - self.begin[0]
        self.cpu = self.processor() - self.begin[1]

    @staticmethod
    def processor():
        times = os.times()
        return times.user + times.system + times.children_user + times.children_system


def run_program(program, lines, low, high, folder):
    """Best wall and mean processor time of some runs, and the table."""
    command = [program, "receptance", CASE, "--out", folder, "--from", str(low), "--to", str(high), "--lines", str(lines), "--threads", "1"]
    runs, best = 10, np.inf
    with Stopwatch() as all_runs:
        for _ in range(runs):
            with Stopwatch() as one:
                subprocess.run(command, check=True)
            best = min(best, one.wall)
    with open(pathlib.Path(folder) / "uic60.receptance.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    columns = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    return best, all_runs.cpu / runs, columns


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=ROOT / "build/release/railpem")
    parser.add_argument("--lines", type=int, default=1500)
    parser.add_argument("--supports", type=int, default=241)
    arguments = parser.parse_args()
    with open(CASE, "rb") as file:
        track = tomllib.load(file)["track"]
    low, high = 20.0, 3000.0
    with tempfile.TemporaryDirectory() as folder:
        wall, cpu, table = run_program(arguments.program, arguments.lines, low, high, folder)
    frequencies = low * (high / low) ** (np.arange(arguments.lines) / (arguments.lines - 1))
    with Stopwatch() as scipy:
        mid_bay = receptance(track, frequencies, arguments.supports + 1)
    over_pad = receptance(track, frequencies, arguments.supports)
    figures = {
        "lines": arguments.lines, "supports": arguments.supports,
        "railpem_wall_s": wall, "scipy_wall_s": scipy.wall, "ratio_wall": scipy.wall / wall,
        "railpem_cpu_s": cpu, "scipy_cpu_s": scipy.cpu, "ratio_cpu": scipy.cpu / cpu,
    }
    for name, reference in (("mid_bay", mid_bay), ("over_pad", over_pad)):
        ours = table[f"{name}_re_m_per_n"] + 1j * table[f"{name}_im_m_per_n"]
        difference = np.abs(ours - reference) / np.abs(reference)
        figures[f"{name}_median_difference"] = float(np.median(difference))
        figures[f"{name}_largest_difference"] = float(difference.max())
        figures[f"{name}_largest_difference_hz"] = float(frequencies[difference.argmax()])
    print(json.dumps(figures, indent=2))


if __name__ == "__main__":
    main()
