#!/usr/bin/env python3
"""What wrong physics gains on data that no fit has seen, against what the right one does.

    scripts/wrong_physics.py build/release/railpem docs/proof/wrong_physics.csv --trials 1

Recordings are those of hide_and_seek.py (three speeds, every number off within its tolerance). Each is diagnosed twice: with the whole catalogue,
and without what was hidden (`--without`): what is said then (`verdict_without`), and what the best set that the search keeps gains (`wrong_nats`),
nats of log-likelihood over retuning on the last quarter of every record; 0: nothing that was kept gains. What everything of equal freedom gains when
it is fitted to its end is asked by tests/benchmark/wrong_physics.cpp. Level of the irregularity and a wrong number are left out: retuning moves
them, and the test `BeliefKept.TellsWhetherTheBeliefWasWrong` asks that.
"""
import argparse
import json
import os
import subprocess
import tempfile

from hide_and_seek import CASE, HIDDEN, commit, fill, march

MOVED_BY_RETUNING = {"nothing", "parameter-error", "irregularity-spectrum", "contact-filter"}  # the last shows at no strength
COLUMNS = ["hidden", "seed", "verdict", "named", "right_nats", "verdict_without", "wrong", "wrong_nats", "program"]


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


def best_wrong(found):
    """Effects and nats on the unseen part of the best that the search without the right effect kept."""
    sets = [([own["effect"] for own in rival["instances"]], rival["nats_held_out"]) for rival in found["rivals"] if rival["nats_held_out"] is not None]
    if found["omitted"]:
        sets.append(([own["effect"] for own in found["omitted"]], gain_of_named(found)))
    effects, nats = max(sets, key=lambda own: own[1], default=([], 0.0))
    return (" + ".join(sorted(effects)), f"{nats:.4g}") if nats > 0.0 else ("", "0")


def compared(options, effect, seed):
    with tempfile.TemporaryDirectory() as folder:
        runs, truth, _ = march(options, effect, seed, folder)
        right = diagnosed(options.railpem, runs, set(), options.threads, folder)
        without = diagnosed(options.railpem, runs, {own["effect"] for own in truth}, options.threads, folder)
    wrong, nats = best_wrong(without)
    return {"hidden": effect, "seed": seed, "verdict": right["verdict"], "named": " + ".join(sorted(own["effect"] for own in right["omitted"])), "right_nats": f"{gain_of_named(right):.4g}",
            "verdict_without": without["verdict"], "wrong": wrong, "wrong_nats": nats, "program": commit()}


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
    fill(options, COLUMNS, compared, lambda line: (line["hidden"], line["right_nats"], "|", line["verdict_without"], line["wrong"], line["wrong_nats"]))


if __name__ == "__main__":
    main()
