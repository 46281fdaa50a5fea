#!/usr/bin/env python3
"""Two kilometres of axle-box acceleration of one run against a generic car and track: writes docs/recordings/two_kilometres.md.

usage: diagnose_two_kilometres.py PATH [--work FOLDER]     PATH: folder that holds km1.csv and km2.csv

The data stay where they are: recordings are written to a temporary folder (or to FOLDER, which is kept: diagnoses that it holds
are not made again), only figures and figures' numbers end up in the documentation.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import tempfile
import tomllib

import numpy as np

import axlebox_bands as bands
import axlebox_figures as figures
import axlebox_lines as lines
import axlebox_page as page
import axlebox_recording as recording

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/recordings"
CASE = ROOT / "cases/generic/axlebox.toml"
SPEED_ERROR = 0.15           # m/s: the speed column has steps of 1 km/h
LOWERED = range(5, lines.HIGHEST_ORDER + 1)
SPACINGS_M = np.arange(0.50, 0.76, 0.005)
SAME_CAR = 0.02              # what a car's numbers change between two kilometres of one run, by judgement: springs and dampers that warm up
CAR_KNOWN = (0.0, 0.005, 0.01, SAME_CAR, 0.03, 0.05, 0.1, 0.3)  # the same question with a car known better or worse
OF_THE_CAR = ("vehicle.", "contact.")
STRETCHED = ((35.0, 85.0, 4.0), (180.0, 420.0, 1.0), (420.0, 900.0, 1.0))  # Hz, Hz, window in s


class Study:
    """What is known of every kilometre, by its name."""

    def __init__(self, path, work, program, threads):
        self.work, self.program, self.threads, self.same_car = work, program, threads, SAME_CAR
        self.kilometres = {name: recording.Kilometre(path / f"{name}.csv") for name in ("km1", "km2")}
        self.records, self.rotation, self.track = {}, {}, {}
        for name, own in self.kilometres.items():
            self.records[name], self.rotation[name], self.track[name] = recording.at_constant_rotation(own)
        radii = [own.speed_m_per_s.mean() / (2.0 * math.pi * self.rotation[name]) for name, own in self.kilometres.items()]
        self.radius, self.radius_range = float(np.mean(radii)), sorted(radii)
        self.broadband = {name: {side: self.without_lines(name, side) for side in recording.SIDES} for name in self.records}

    def without_lines(self, name, side):
        """Lines lowered in the seen and in the unseen part by themselves."""
        return np.concatenate([recording.lowered_lines(recording.part(self.records[name][side], of), self.rotation[name], LOWERED) for of in ("seen", "unseen")])

    def speed(self, name):
        return self.rotation[name] * 2.0 * math.pi * self.radius

    def parts(self, name, of):
        return {side: recording.part(x, of) for side, x in self.records[name].items()}

    def run(self, *arguments):
        done = subprocess.run([self.program, *map(str, arguments)], check=False, capture_output=True, text=True)
        if done.returncode not in (0, 3):  # 3: `inspect` found errors in the data
            done.check_returncode()
        return done.stdout


def inspected(study):
    """What the program says of the records as they came, and the lines that it finds at constant rotation."""
    faults, tested = {}, {}
    for name, own in study.kilometres.items():
        folder = study.work / f"{name}_as_measured"
        if not folder.exists():
            recording.write_as_measured(folder, own)
        faults[name] = json.loads(study.run("inspect", folder, "--json"))["faults"]
        for of in ("seen", "unseen"):
            folder = study.work / f"{name}_{of}"
            if not folder.exists():
                recording.write_recording(folder, f"{name}, {of}", study.parts(name, of), study.speed(name), SPEED_ERROR)
            report = json.loads(study.run("inspect", folder, "--json"))
            tested[name, of] = {c["name"]: [(line["frequency_hz"] / study.rotation[name], line["rms"]) for line in c["lines"]] for c in report["channels"]}
    return faults, tested


def found_lines(study):
    """Lines of the seen part, and those of them that the unseen part shows again."""
    result, tests = {}, {}
    for name in study.records:
        result[name], tests[name] = {}, {}
        result[name]["seen"], tests[name]["seen"] = lines.found(study.parts(name, "seen"), study.rotation[name], tests_more=lines.ROTATIONS_TRIED)
        near = {side: {line.order for line in own} for side, own in result[name]["seen"].items()}
        result[name]["unseen"], tests[name]["unseen"] = lines.found(study.parts(name, "unseen"), study.rotation[name], near, lines.ROTATIONS_TRIED)
    return result, tests


def support_order(study, tests):
    """The order of sleeper passing: the fundamental between supports of 0.50 and 0.75 m that is beyond chance, or None. Its line, kilometre and side."""
    low, high = (2.0 * math.pi * study.radius / s for s in (SPACINGS_M[-1], SPACINGS_M[0]))
    seen = [(line.false_alarm, line, name, side) for name in tests for side, own in tests[name]["seen"].items() for line in own
            if low <= line.order <= high and not lines.is_whole(line.order)]
    chance, line, name, side = min(seen, key=lambda entry: entry[0])
    return (line, name, side, min(1.0, chance * len(seen))) if chance * len(seen) <= lines.FALSE_ALARM else None


def diagnose(study, name, case, folder, settings=(), label=""):
    """The program's diagnosis of a kilometre, both rails, lines lowered; the last third is held out."""
    out = study.work / f"{folder.name}_against_{pathlib.Path(case).stem}{label}"
    if not (out / "diagnosis.json").exists():
        arguments = ["diagnose", case, folder, "--held-out", f"{1.0 - recording.SEEN:.4f}", "--out", out]
        arguments += ["--threads", study.threads] if study.threads else []
        for setting in settings:
            arguments += ["--set", setting]
        study.run(*arguments)
    result = json.loads((out / "diagnosis.json").read_text())
    result["unseen_s"] = len(recording.SIDES) * (1.0 - recording.SEEN) * study.kilometres[name].duration_s()  # both rails
    return result, out


def spectra(out, observation):
    """Columns of <observation>.spectra.csv."""
    with open(out / f"{observation}.spectra.csv", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {key: np.array([float(row[key]) for row in rows]) for key in rows[0] if key != "channel"}


def unseen_errors(columns, x, cut=(20.0, 150.0)):
    """(model, rms dB of third-octaves, the same without the mean difference) of the unseen part."""
    result = {}
    recorded = bands.levels(x)[0]
    for model in ("believed", "retuned", "diagnosed"):
        differences = []
        for centre, level in zip(bands.CENTRES_HZ, recorded):
            inside = (columns["frequency_hz"] >= bands.edges(centre)[0]) & (columns["frequency_hz"] < bands.edges(centre)[1])
            if cut[0] <= centre <= cut[1] and inside.any():
                power = columns[f"{model}_psd_m2_per_s4_per_hz"][inside].mean() * (bands.edges(centre)[1] - bands.edges(centre)[0])
                differences.append(10.0 * math.log10(power) - level)
        result[model] = (float(np.sqrt(np.mean(np.square(differences)))), float(np.std(differences)))
    return result


def scale_of(study, columns_by_side, out):
    """By side, the factor that brings the first kilometre to the level of its diagnosed case: what the second is held against in the same unit."""
    study.run("solve", out / "diagnosed.toml", "--out", study.work / "solved")
    with open(study.work / "solved/diagnosed.psd.csv", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    f = np.array([float(row["frequency_hz"]) for row in rows])
    own = np.array([float(row["wheel_1_acceleration_psd_m2_per_s4_per_hz"]) for row in rows])
    factors = {}
    for side, columns in columns_by_side.items():
        ratio = np.log(np.interp(columns["frequency_hz"], f, own) / columns["diagnosed_psd_m2_per_s4_per_hz"])
        factors[side] = math.exp(0.5 * float(np.median(ratio)))
    return factors


def same_car(case, tolerance):
    """Settings by which nothing of a case's car, nor of its wheels on the rail, is known worse than `tolerance`: it is the car of the other kilometre. The track is another."""
    with open(case, "rb") as file:
        tolerances = tomllib.load(file)["tolerance"]
    return [f"tolerance.{key}={min(tolerance, own):g}" for key, own in tolerances.items() if key.startswith(OF_THE_CAR)]


def diagnoses(study):
    """Both kilometres against the generic case; the second against what the first ended in, for a car that is the same within SAME_CAR, and apart from the rest by how well the car is known."""
    settings = [f"vehicle.wheel_radius_m={study.radius:.4f}"]
    results = {}
    for name in study.records:
        folder = study.work / f"{name}_broadband"
        if not folder.exists():
            recording.write_recording(folder, f"{name}, lines lowered", study.broadband[name], study.speed(name), SPEED_ERROR)
        results[name] = diagnose(study, name, CASE, folder, settings)
    first = {side: spectra(results["km1"][1], f"km1_broadband_{side}") for side in recording.SIDES}
    factors = scale_of(study, first, results["km1"][1])
    folder = study.work / "km2_in_units_of_km1"
    if not folder.exists():
        recording.write_recording(folder, "km2 in the scale of km1", study.broadband["km2"], study.speed("km2"), SPEED_ERROR, scale="known", factor=factors)
    case = results["km1"][1] / "diagnosed.toml"
    after = {tolerance: diagnose(study, "km2", case, folder, same_car(case, tolerance), f"_{tolerance:g}") for tolerance in CAR_KNOWN}
    results["km2 after km1"] = after[SAME_CAR]
    return results, after


def compared(study):
    """Level differences of the two kilometres, lines lowered, by part and side."""
    count = len(bands.CENTRES_HZ) * len(recording.SIDES)
    return {of: {side: bands.differences(*(recording.part(study.broadband[name][side], of) for name in ("km1", "km2")), count) for side in recording.SIDES}
            for of in ("seen", "unseen")}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("path", type=pathlib.Path, help="folder that holds km1.csv and km2.csv")
    parser.add_argument("--work", type=pathlib.Path, help="folder for recordings and diagnoses; a temporary one without it")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/railpem")
    parser.add_argument("--threads", type=int, default=0, help="of a diagnosis; all without it")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        study = Study(arguments.path, (arguments.work or pathlib.Path(temporary)).resolve(), arguments.program, arguments.threads)
        answer = page.Answer(study)
        answer.faults, answer.inspected_lines = inspected(study)
        answer.lines, tests = found_lines(study)
        answer.support = support_order(study, tests)
        order = answer.support[0].order if answer.support else None
        answer.shares = {name: {side: bands.shares(x, answer.lines[name]["seen"][side], order) for side, x in study.parts(name, "seen").items()} for name in study.records}
        answer.differences = compared(study)
        answer.stretches = {(side, *band): bands.stretch_with_error(study.broadband["km1"][side], study.broadband["km2"][side], *band)
                            for side in recording.SIDES for band in STRETCHED}
        answer.diagnoses, answer.after_km1 = diagnoses(study)
        panels = []
        for name in study.records:
            for side in recording.SIDES:
                columns = spectra(answer.diagnoses[name][1], f"{name}_broadband_{side}")
                panels.append((f"{name}, {side}: {answer.diagnoses[name][0]['verdict']}", columns))
                answer.unseen[name, side] = unseen_errors(columns, recording.part(study.broadband[name][side], "unseen"))
        figures.overview(study.records, study.rotation, PAGE / "two_kilometres_spectra.png")
        figures.lines(answer.lines, tests, PAGE / "two_kilometres_lines.png")
        figures.shares(answer.shares, PAGE / "two_kilometres_shares.png")
        figures.difference(answer.differences, PAGE / "two_kilometres_difference.png")
        figures.diagnosed(panels, PAGE / "two_kilometres_diagnosed.png")
        (PAGE / "two_kilometres.md").write_text(answer.text())
    print(PAGE / "two_kilometres.md")


if __name__ == "__main__":
    main()
