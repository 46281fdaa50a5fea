#!/usr/bin/env python3
"""What wrong physics gains on data that no fit has seen, against what the right one does.

    scripts/wrong_physics.py build/release/railpem docs/proof/wrong_physics.csv --trials 1

Recordings are those of hide_and_seek.py (three speeds, every number off within its tolerance). Each is diagnosed twice: with the whole catalogue, and without what was hidden (`--without`): what
is said then (`verdict_without`), and what the sets that the search keeps gain, nats of log-likelihood over retuning on the last quarter of every record. A wrong set is of equal freedom if it has no more parameters than
what was named. 0: nothing that was kept gains. What everything of equal freedom gains when it is fitted to its end is asked by tests/benchmark/wrong_physics.cpp. Level of the irregularity and a wrong number are left out:
retuning moves them, and the test `BeliefKept.TellsWhetherTheBeliefWasWrong` asks that.
"""
import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile

from hide_and_seek import CASE, HIDDEN, append, commit, march

MOVED_BY_RETUNING = {"nothing", "parameter-error", "irregularity-spectrum", "contact-filter"}  # the last shows at no strength
COLUMNS = ["hidden", "seed", "verdict", "named", "right_nats", "verdict_without", "wrong_equal", "wrong_equal_nats", "wrong_any", "wrong_any_nats", "program"]


def diagnosed(railpem, runs, without, threads, folder):
    words = [word for effect in sorted(without) for word in ("--without", effect)]
    out = os.path.join(folder, "without" if without else "out")
    subprocess.run([railpem, "diagnose", CASE, *runs, *words, "--threads", threads, "--out", out], check=True, capture_output=True)
    with open(os.path.join(out, "diagnosis.json")) as file:
        return json.load(file)


def gain_of_named(found):
    fit, seconds = found["fit"], sum(own["held_out_seconds"] for own in found["recordings"])
    retuned = fit.get("held_out_freely_retuned", fit["held_out_retuned"])
    return seconds * (fit["held_out_after"]["log_likelihood_per_second"] - retuned["log_likelihood_per_second"])


def freedom(members):
    """Parameters with a value, choices apart, of members as `omitted` and `instances` have them."""
    return sum(isinstance(value["value"], float) for own in members for value in own["parameters"].values())


def wrong_sets(found):
    """(effects, freedom, nats on the unseen part) of everything that the search without the right effect kept."""
    sets = [([own["effect"] for own in rival["instances"]], freedom(rival["instances"]), rival["nats_held_out"]) for rival in found["rivals"]]
    if found["omitted"]:
        sets.append(([own["effect"] for own in found["omitted"]], freedom(found["omitted"]), gain_of_named(found)))
    return [own for own in sets if own[2] is not None]


def best_of(sets):
    effects, _, nats = max(sets, key=lambda own: own[2], default=([], 0, 0.0))
    return (" + ".join(sorted(effects)), f"{nats:.4g}") if nats > 0.0 else ("", "0")


def compared(options, effect, seed):
    with tempfile.TemporaryDirectory() as folder:
        runs, truth, _ = march(options, effect, seed, folder)
        hidden = {own["effect"] for own in truth}
        right = diagnosed(options.railpem, runs, set(), options.threads, folder)
        wrong = diagnosed(options.railpem, runs, hidden, options.threads, folder)
    equal = max(freedom(right["omitted"]), 1)
    sets = wrong_sets(wrong)
    line = {"hidden": effect, "seed": seed, "verdict": right["verdict"], "named": " + ".join(sorted(own["effect"] for own in right["omitted"])),
            "right_nats": f"{gain_of_named(right):.4g}", "verdict_without": wrong["verdict"], "program": commit()}
    line["wrong_equal"], line["wrong_equal_nats"] = best_of([own for own in sets if own[1] <= equal])
    line["wrong_any"], line["wrong_any_nats"] = best_of(sets)
    return line


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("railpem")
    parser.add_argument("table")
    parser.add_argument("--trials", type=int, default=1)
    parser.add_argument("--first-seed", type=int, default=9961)
    parser.add_argument("--effects", nargs="*", default=[effect for effect in HIDDEN if effect not in MOVED_BY_RETUNING])
    parser.add_argument("--threads", default="1")
    options = parser.parse_args()
    options.speeds, options.numbers = ["15", "22.2222", "33"], "even"
    done = set()
    if os.path.exists(options.table):
        with open(options.table) as file:
            done = {(row["hidden"], row["seed"]) for row in csv.DictReader(file)}
    for seed in range(options.first_seed, options.first_seed + options.trials):
        for effect in options.effects:
            if (effect, str(seed)) in done:
                continue
            try:
                line = compared(options, effect, seed)
            except subprocess.CalledProcessError as error:
                print(f"{effect} {seed}: {error.stderr.decode(errors='replace').strip()[:300]}", file=sys.stderr)
                continue
            append(options.table, COLUMNS, line)
            print(line["hidden"], line["right_nats"], "|", line["wrong_equal"], line["wrong_equal_nats"], "|", line["wrong_any"], line["wrong_any_nats"], flush=True)


if __name__ == "__main__":
    main()
