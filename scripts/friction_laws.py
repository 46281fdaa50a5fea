#!/usr/bin/env python3
"""Friction that is constant, and friction that sticks harder than it slides, in marched recordings: what `railpem diagnose` says of its law, one line of a table each.

    scripts/friction_laws.py build/release/railpem docs/proof/friction_laws.csv

Case 1 of Wei et al. 2016 and others with another vehicle, every uncertain number off within its tolerance, by a seed; runs of 60 s, nine channels, noise 0.02 m/s^2. `power`: of the forces that
friction has beside its damping, in multiples of a constant force's where velocities are Gaussian; `expected`: what a constant force would seem to have (FrictionLaw). A line that is there
already is not made again.
"""
import argparse
import csv
import json
import os
import re
import subprocess
import tempfile

from hide_and_seek import CASE, UNCERTAIN, append, commit, march_hidden

CONSTANT, STICKS = "suspension-friction:stage={},force_n={}", "guidance-stick-slip:force_n={},static_to_kinetic={},stribeck_velocity_m_per_s={}"
THREE = ["15", "22.2222", "33"]
HEAVY = {"vehicle.bogie_mass_kg": 4500, "vehicle.primary.stiffness_n_per_m": 1.3e6, "vehicle.wheelset_mass_kg": 1800}
# Line: what is hidden, numbers of the vehicle that are others, speeds, seed.
LINES = {
    "constant 300": ([CONSTANT.format("primary", 300)], {}, THREE, 1), "constant 1000": ([CONSTANT.format("primary", 1000)], {}, THREE, 2),
    "constant 2500": ([CONSTANT.format("primary", 2500)], {}, THREE, 3), "constant 5000": ([CONSTANT.format("primary", 5000)], {}, THREE, 4),
    "constant 600 secondary": ([CONSTANT.format("secondary", 600)], {}, THREE, 6), "constant 2500 secondary": ([CONSTANT.format("secondary", 2500)], {}, THREE, 7),
    "constant 500, weak dampers": ([CONSTANT.format("primary", 500)], {"vehicle.primary.damping_n_s_per_m": 2e4}, THREE, 21),
    "constant 3000, strong dampers": ([CONSTANT.format("primary", 3000)], {"vehicle.primary.damping_n_s_per_m": 1e5}, THREE, 22),
    "constant 1500, heavy bogies": ([CONSTANT.format("primary", 1500)], HEAVY, THREE, 23),
    "constant 800, smoother track": ([CONSTANT.format("primary", 800), "irregularity-spectrum:level_db=-6"], {}, THREE, 24),
    "constant 1500, two speeds": ([CONSTANT.format("primary", 1500)], {}, ["20", "36"], 25),
    "constant 1000, ballast": ([CONSTANT.format("primary", 1000), "support-compliance"], {}, THREE, 26),
    "constant 400, one speed": ([CONSTANT.format("primary", 400)], {}, ["22.2222"], 5),
    "sticks 1500 x 1.6": ([STICKS.format(1500, 1.6, 0.01)], {}, THREE, 11), "sticks 400 x 1.6": ([STICKS.format(400, 1.6, 0.01)], {}, THREE, 12),
    "sticks 400 x 1.4": ([STICKS.format(400, 1.4, 0.03)], {}, THREE, 13), "sticks 1500 x 1.4": ([STICKS.format(1500, 1.4, 0.01)], {}, THREE, 14),
    "sticks 3000 x 2": ([STICKS.format(3000, 2, 0.01)], {}, THREE, 15), "sticks 1200 x 2, heavy bogies": ([STICKS.format(1200, 2, 0.01)], HEAVY, THREE, 27),
    "sticks 1000 x 1.8, two speeds": ([STICKS.format(1000, 1.8, 0.02)], {}, ["20", "36"], 28),
    "sticks 1500 x 2, one speed": ([STICKS.format(1500, 2, 0.01)], {}, ["22.2222"], 29)}
COLUMNS = ["hidden", "seed", "speeds_m_per_s", "verdict", "named", "force_n", "first_place", "power", "deviation", "expected", "program"]


def case_with(numbers, folder):
    """Case 1 with other numbers of the vehicle, as a file."""
    lines, table = [], ""
    for line in open(CASE):
        header, key = re.match(r"\[([\w.]+)\]", line), re.match(r"(\w+)\s*=", line)
        table = header.group(1) if header else table
        name = f"{table}.{key.group(1)}" if key else ""
        lines.append(f"{key.group(1)} = {numbers[name]:g}\n" if name in numbers else line)
    path = os.path.join(folder, "case.toml")
    with open(path, "w") as file:
        file.writelines(lines)
    return path


def judged(railpem, threads, name):
    hidden, numbers, speeds, seed = LINES[name]
    with tempfile.TemporaryDirectory() as folder:
        case = case_with(numbers, folder)
        uncertain = {key: (numbers.get(key, value), tolerance) for key, (value, tolerance) in UNCERTAIN.items()}
        runs, _, _ = march_hidden(argparse.Namespace(railpem=railpem, speeds=speeds, numbers="even"), name, hidden, seed, folder, case, uncertain)
        out = os.path.join(folder, "out")
        subprocess.run([railpem, "diagnose", case, *runs, "--threads", threads, "--out", out], check=True, capture_output=True)
        with open(os.path.join(out, "diagnosis.json")) as file:
            found = json.load(file)
    said = next((re.search(r"have ([-\d.]+) \+- ([\d.]+) times .* seem to have ([\d.]+):", own) for own in found["remains"] if own.startswith("friction: ")), None)
    instances = found["omitted"] or (found["rivals"][0]["instances"] if found["rivals"] else [])
    return {"hidden": name, "seed": seed, "speeds_m_per_s": " ".join(speeds), "verdict": found["verdict"],
            "named": " | ".join(" + ".join(own["effects"]) for own in found["rivals"]) if found["verdict"] == "ambiguous" else " + ".join(own["effect"] for own in found["omitted"]),
            "force_n": next((f"{own['parameters']['force_n']['value']:.0f}" for own in instances if own["effect"] == "suspension-friction"), ""),
            "first_place": found["places"][0]["element"], **dict(zip(COLUMNS[7:10], said.groups() if said else [""] * 3)), "program": commit()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("railpem")
    parser.add_argument("table")
    parser.add_argument("--threads", default="2")
    parser.add_argument("--lines", nargs="*", default=list(LINES))
    options = parser.parse_args()
    there = set()
    if os.path.exists(options.table):
        with open(options.table) as file:
            there = {row["hidden"] for row in csv.DictReader(line for line in file if not line.startswith("#"))}
    for name in options.lines:
        if name in there:
            continue
        row = judged(options.railpem, options.threads, name)
        append(options.table, COLUMNS, row)
        print(row, flush=True)


if __name__ == "__main__":
    main()
