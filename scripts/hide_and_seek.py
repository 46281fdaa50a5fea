#!/usr/bin/env python3
"""Every effect of the catalogue, those that only the simulator has, and nothing hidden in marched recordings and sought by `railpem diagnose`, one line of a table each.

    scripts/hide_and_seek.py build/release/railpem docs/proof/marched_three_speeds.csv --trials 2

The believed case is case 1 of Wei et al. 2016 with every uncertain number off within its tolerance, by a seed; three runs of 60 s, nine channels,
noise 0.02 m/s^2. A line that is there already is not made again, so that the table grows over several starts; several at once want files of
their own. Strengths are the catalogue's typical ones, or those of HIDDEN where the catalogue has choices or docs/proof/smallest_strengths.csv says that
the typical one does not show at three speeds (sleeper passing, the level of the irregularity; of a contact patch none does).
"""
import argparse
import csv
import json
import math
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
CASE = os.path.join(ROOT, "cases", "wei2016", "case1.toml")
# Value and relative tolerance (docs/case.md) of everything uncertain.
UNCERTAIN = {
    "vehicle.body_mass_kg": (38500, 0.05), "vehicle.body_pitch_inertia_kg_m2": (2.5e6, 0.05), "vehicle.bogie_mass_kg": (2980, 0.05),
    "vehicle.bogie_pitch_inertia_kg_m2": (3600, 0.05), "vehicle.wheelset_mass_kg": (1350, 0.05),
    "vehicle.primary.stiffness_n_per_m": (2.1e6, 0.1), "vehicle.primary.damping_n_s_per_m": (4.9e4, 0.15),
    "vehicle.secondary.stiffness_n_per_m": (2.5e6, 0.1), "vehicle.secondary.damping_n_s_per_m": (2e5, 0.15),
    "track.rail.second_moment_of_area_m4": (3.22e-5, 0.02), "track.rail.mass_kg_per_m": (60.64, 0.02),
    "track.pads.static_stiffness_n_per_m": (26.7e6, 0.3), "track.pads.damping_n_s_per_m": (7.5e4, 0.3), "contact.constant_m_per_n23": (4.265e-8, 0.15)}
HIDDEN = {
    "nothing": [], "pair-of-the-paper": ["pad-frequency-stiffening:exponent=0.1", "pad-preload-stiffening:strength=0.8"],
    "pad-frequency-stiffening": ["pad-frequency-stiffening:exponent=0.15"], "pad-preload-stiffening": ["pad-preload-stiffening"],
    "pad-hysteresis": ["pad-hysteresis"], "rail-shear": ["rail-shear"], "support-compliance": ["support-compliance"],
    "rail-damper": ["rail-damper:mass_kg_per_m=15,frequency_hz=120"], "failed-fasteners": ["failed-fasteners:every=8"],
    "sleeper-passing": ["sleeper-passing:amplitude_factor=6"], "wheel-out-of-roundness": ["wheel-out-of-roundness:wheel=2,order=3,amplitude_m=5e-5"],
    "rail-corrugation": ["rail-corrugation"], "rail-joints": ["rail-joints:spacing_m=12"], "irregularity-spectrum": ["irregularity-spectrum:level_db=-8"],
    "body-bending": ["body-bending:frequency_hz=9"], "wheelset-bending": ["wheelset-bending"], "bogie-mounted-mass": ["bogie-mounted-mass"],
    "primary-damper-series-stiffness": ["primary-damper-series-stiffness"], "secondary-damper-series-stiffness": ["secondary-damper-series-stiffness"],
    "suspension-friction": ["suspension-friction:stage=primary,force_n=1000"], "contact-nonlinearity": ["contact-nonlinearity"],
    "contact-filter": ["contact-filter"], "sensor-gain": ["sensor-gain:channel=bogie_1,gain=1.05"], "sensor-resonance": ["sensor-resonance:channel=axlebox_2"],
    "sensor-noise": ["sensor-noise:channel=bogie_2,slope_db_per_octave=-3"], "timing-skew": ["timing-skew:channel=axlebox_3,delay_s=0.001"],
    "parameter-error": ["parameter-error:parameter=vehicle.primary.stiffness_n_per_m,factor=1.6"]}
# What only the simulator knows: right is `unexplained`, with the place where it sits in front.
OUTSIDE = {name: [name] for name in ("bogie-coupling", "axle-absorber", "guidance-stick-slip", "body-coupling", "secondary-bump-stop", "pad-dead-band", "wandering-subgrade")}
COLUMNS = ["hidden", "seed", "speeds_m_per_s", "truth", "verdict", "named", "found", "rivals", "first_place", "set_right", "place_right", "intervals_right", "intervals",
           "numbers_right", "numbers", "held_out_gain_nats_per_s", "retuned_rms_db", "wall_s", "cpu_s", "program"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("railpem")
    parser.add_argument("table")
    parser.add_argument("--trials", type=int, default=2)
    parser.add_argument("--first-seed", type=int, default=7001)
    parser.add_argument("--effects", nargs="*", default=list(HIDDEN | OUTSIDE))
    parser.add_argument("--speeds", nargs="*", default=["15", "22.2222", "33"])
    parser.add_argument("--threads", default="1")
    parser.add_argument("--world", default="ideal", help="grade of the recordings, as for simulate")
    parser.add_argument("--keep", help="folder for every trial's diagnosis.json")
    parser.add_argument("--numbers", choices=["even", "believed"], default="even",
                        help="how the numbers are off: evenly within their tolerances, or as the fit believes them (the logarithm Gaussian, a tolerance its deviation)")
    return parser.parse_args()


def march(options, effect, seed, folder):
    """Records of one trial; (folders, truth of the effects, truth of the numbers)."""
    return march_hidden(options, effect, (HIDDEN | OUTSIDE)[effect], seed, folder)


def march_hidden(options, name, hidden, seed, folder, case=CASE, uncertain=UNCERTAIN):
    """The same of anything hidden in any case, drawn by name and seed."""
    draw = random.Random(f"{name} {seed}")
    off = {"even": lambda tolerance: 1 + tolerance * draw.uniform(-1, 1), "believed": lambda tolerance: math.exp(tolerance * draw.gauss(0, 1))}[options.numbers]
    numbers = {key: value * off(tolerance) for key, (value, tolerance) in uncertain.items()}
    hide = [word for one in hidden for word in ("--hide", one)]
    runs, truth = [], []
    for i, speed in enumerate(options.speeds):
        runs.append(os.path.join(folder, "run_" + speed))
        command = [options.railpem, "simulate", case, "--seconds", "60", "--seed", str(100 * seed + i), "--speed", speed, "--noise", "0.02",
                   "--world", options.world,
                   "--out", runs[-1], "--truth", runs[-1] + ".json"] + hide
        for key, value in numbers.items():
            command += ["--set", f"{key}={value:.9g}"]
        subprocess.run(command, check=True, capture_output=True)
        with open(runs[-1] + ".json") as file:
            truth = json.load(file)["effects"]
    return runs, *as_believed(truth, numbers)


def judged(options, effect, seed):
    with tempfile.TemporaryDirectory() as folder:
        runs, truth, numbers = march(options, effect, seed, folder)
        begin, used = time.time(), cpu_s()
        subprocess.run([options.railpem, "diagnose", CASE, *runs, "--threads", options.threads, "--out", os.path.join(folder, "out")], check=True, capture_output=True)
        cost = {"wall_s": f"{time.time() - begin:.0f}", "cpu_s": f"{cpu_s() - used:.0f}", "program": commit()}
        with open(os.path.join(folder, "out", "diagnosis.json")) as file:
            found = json.load(file)
        if options.keep:
            os.makedirs(options.keep, exist_ok=True)
            shutil.copy(os.path.join(folder, "out", "diagnosis.json"), os.path.join(options.keep, f"{effect}_{seed}.json"))
    return line_of(effect, seed, options, truth, numbers, found) | cost


def append(table, columns, line):
    fresh = not os.path.exists(table)
    with open(table, "a", newline="") as file:
        writer = csv.DictWriter(file, columns)
        if fresh:
            writer.writeheader()
        writer.writerow(line)


def cpu_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def commit():
    return subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], capture_output=True, text=True).stdout.strip()


def in_words(value):
    return f"{value['value']:.4g}[{value['low']:.4g},{value['high']:.4g}]" if "low" in value else str(value["value"] if isinstance(value, dict) else value)


def sits_at(hidden, element):
    """Whether what was hidden sits in an element; a wrong number where its key says."""
    key = hidden["parameters"].get("parameter")
    return element in key.replace("wheelset", "wheel") if key else hidden["place"].startswith(element)


def as_believed(truth, numbers):
    """A wrong number is wrong by what was hidden and by what it was off anyhow: `diagnose` knows the product. (Effects, numbers) with it."""
    for own in truth:
        key = own["parameters"].get("parameter")
        if key:
            numbers = numbers | {key: numbers[key] * own["parameters"]["factor"]}
            own["parameters"]["factor"] = numbers[key] / UNCERTAIN[key][0]
    return truth, numbers


def line_of(effect, seed, options, truth, numbers, found):
    named = sorted(own["effect"] for own in found["omitted"])
    hidden = sorted(own["effect"] for own in truth)
    rivals = [sorted(rival["effects"]) for rival in found["rivals"]]
    right = {"nothing": found["verdict"] == "consistent"}.get(
        effect, found["verdict"] in ("explained", "recording-fault") and named == hidden or found["verdict"] == "ambiguous" and hidden in rivals)
    inside, total = 0, 0
    for own in truth:
        for other in found["omitted"]:
            if other["effect"] != own["effect"]:
                continue
            for name, value in own["parameters"].items():
                interval = other["parameters"].get(name, {})
                if isinstance(value, (int, float)) and "low" in interval:
                    total += 1
                    inside += interval["low"] <= value <= interval["high"]
    covered = [n for n in found["numbers"] if n["key"] in numbers]
    first = found["places"][0]["element"] if found["places"] else ""
    if effect in OUTSIDE:
        right = found["verdict"] == "unexplained" and first != "" and sits_at(truth[0], first)
    fit = found["fit"]
    return {
        "hidden": effect, "seed": seed, "speeds_m_per_s": " ".join(options.speeds),
        "truth": "; ".join(own["effect"] + " " + " ".join(f"{k}={v}" for k, v in own["parameters"].items()) for own in truth),
        "verdict": found["verdict"], "named": " + ".join(named),
        "found": "; ".join(own["effect"] + " " + " ".join(f"{k}={in_words(v)}" for k, v in own["parameters"].items()) + f" ({own['nats_fitted']:.0f} nats)" for own in found["omitted"]),
        "rivals": " | ".join(" + ".join(r) for r in rivals if found["verdict"] == "ambiguous"),
        "first_place": first, "set_right": int(right), "place_right": "" if not truth else int(any(sits_at(own, first) for own in truth)),
        "intervals_right": inside, "intervals": total, "numbers_right": sum(n["low"] <= numbers[n["key"]] <= n["high"] for n in covered), "numbers": len(covered),
        "held_out_gain_nats_per_s": f'{fit["held_out_after"]["log_likelihood_per_second"] - fit["held_out_retuned"]["log_likelihood_per_second"]:.3g}',
        "retuned_rms_db": f'{fit.get("freely_retuned", fit["retuned"])["rms_db"]:.3g}'}


def fill(options, columns, line_of_trial, said):
    """Appends a line for every seed and effect that the table does not have yet; what a trial's program refuses is said and left out."""
    names = [name for name in ("hidden", "seed", "speeds_m_per_s") if name in columns]
    done = set()
    if os.path.exists(options.table):
        with open(options.table) as file:
            done = {tuple(row[name] for name in names) for row in csv.DictReader(file)}
    for seed in range(options.first_seed, options.first_seed + options.trials):
        for effect in options.effects:
            if (effect, str(seed), " ".join(options.speeds))[:len(names)] in done:
                continue
            try:
                line = line_of_trial(options, effect, seed)
            except subprocess.CalledProcessError as error:
                print(f"{effect} {seed}: {error.stderr.decode(errors='replace').strip()[:300]}", file=sys.stderr)
                continue
            append(options.table, columns, line)
            print(*said(line), flush=True)


def main():
    fill(arguments(), COLUMNS, judged,
         lambda line: (line["hidden"], line["seed"], line["verdict"], line["named"], "right" if line["set_right"] else "WRONG", line["wall_s"], "s"))


if __name__ == "__main__":
    main()
