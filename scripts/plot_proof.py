#!/usr/bin/env python3
"""Draws what `railpem prove` found: confusion matrix, calibration, concealment and detectability.

    scripts/plot_proof.py out/proof --out out/proof/figures
"""
import argparse
import csv
import json
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter
import numpy as np

CONCEALED_DB = 0.3  # by eye nothing is wrong
ENDS = ["nothing", "several", "ambiguous", "unexplained", "failed"]  # columns that are no effect stand last
GOOD, PLACE, NAME, MISSED, WRONG = "#1b7837", "#4393c3", "#f4a582", "#878787", "#b2182b"


def read_proof(folder):
    score = json.loads((folder / "score.json").read_text(encoding="utf-8"))
    with open(folder / "trials.csv", newline="", encoding="utf-8") as file:
        return score, list(csv.DictReader(line for line in file if not line.startswith("#")))


def order(names):
    """Effects by name, then what is no effect."""
    return sorted((n for n in names if n not in ENDS), key=str) + [n for n in ENDS if n in names]


def draw_confusion(score):
    confusion = score["confusion"]
    rows = order([*confusion["hidden"]])
    columns = order(confusion["returned"])
    counts = np.array([[confusion["trials"][confusion["hidden"].index(r)][confusion["returned"].index(c)] for c in columns] for r in rows])
    shares = counts / np.maximum(counts.sum(axis=1, keepdims=True), 1)
    figure, axes = plt.subplots(figsize=(2.5 + 0.42 * len(columns), 2.2 + 0.3 * len(rows)), layout="constrained")
    axes.imshow(shares, cmap="Blues", vmin=0.0, vmax=1.0, aspect="auto")
    for i, j in np.argwhere(counts > 0):
        axes.text(j, i, counts[i, j], ha="center", va="center", fontsize=8, color="white" if shares[i, j] > 0.6 else "black")
    for i, row in enumerate(rows):
        if row in columns:  # the right answer
            axes.add_patch(plt.Rectangle((columns.index(row) - 0.5, i - 0.5), 1.0, 1.0, fill=False, edgecolor=GOOD, linewidth=1.2))
    axes.set_xticks(range(len(columns)), columns, rotation=60, ha="right", fontsize=8)
    axes.set_yticks(range(len(rows)), [f"{row} ({n})" for row, n in zip(rows, counts.sum(axis=1))], fontsize=8)
    axes.set(xlabel="returned", ylabel="hidden (trials)", title="What was hidden, and what the diagnosis said")
    return figure


def draw_calibration(score):
    bins = [b for b in score["calibration"] if b["true"]["of"] > 0]
    figure, axes = plt.subplots(figsize=(5.0, 4.6), layout="constrained")
    axes.plot([0, 1], [0, 1], color="grey", linewidth=0.8, label="perfectly calibrated")
    x = [b["mean_probability"] for b in bins]
    y = [b["true"]["value"] for b in bins]
    low = [max(0.0, v - b["true"]["low"]) for v, b in zip(y, bins)]
    high = [max(0.0, b["true"]["high"] - v) for v, b in zip(y, bins)]
    axes.errorbar(x, y, yerr=[low, high], fmt="o", capsize=3, label="sets of effects, Wilson 95 %")
    for a, b, own in zip(x, y, bins):
        axes.annotate(own["true"]["of"], (a, b), textcoords="offset points", xytext=(6, -10), fontsize=8)
    axes.set(xlabel="probability that the diagnosis gave", ylabel="share that was true", xlim=(-0.02, 1.02), ylim=(-0.02, 1.02),
             title="Are the probabilities right?")
    axes.legend(fontsize=8, loc="upper left")
    return figure


def judged(row):
    """Legend entry and colour of a trial."""
    if row["verdict"] == "consistent":
        return "not detected", MISSED
    if row["right_effect"] == "1" or (row["verdict"] == "ambiguous" and row["truth_returned"] == "1"):
        return "named (or among the rivals)", GOOD
    if row["right_place"] == "1":
        return ("right place only", PLACE) if row["verdict"] == "unexplained" else ("right place, wrong name", NAME)
    return "wrong", WRONG


def draw_concealment(rows):
    rows = [r for r in rows if r["missing"] == "1" and r["verdict"] != "failed" and r["retuned_rms_db"] and r["before_rms_db"]]
    figure, axes = plt.subplots(figsize=(6.2, 4.8), layout="constrained")
    axes.axvspan(0.0, CONCEALED_DB, color="#fee8c8", zorder=0)
    groups = {}
    for row in rows:
        groups.setdefault(judged(row), []).append((float(row["retuned_rms_db"]), float(row["before_rms_db"])))
    for (label, colour), points in sorted(groups.items()):
        axes.scatter(*np.maximum(np.array(points).T, 1e-2), color=colour, s=26, label=f"{label} ({len(points)})")
    values = [v for points in groups.values() for point in points for v in point] or [0.1, 1.0]
    span = (0.8 * max(min(values), 1e-2), 1.25 * max(values))
    axes.plot(span, span, color="grey", linewidth=0.8)
    axes.set(xscale="log", yscale="log", xlim=span, ylim=span, xlabel="third-octave misfit after retuning, dB rms", ylabel="before retuning, dB rms",
             title="Shaded: by eye nothing is wrong after retuning")
    ticks = [t for t in (0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0) if span[0] <= t <= span[1]]
    for axis in (axes.xaxis, axes.yaxis):  # less than two decades: powers of ten alone would leave a single number
        axis.set_major_locator(FixedLocator(ticks))
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_formatter(NullFormatter())
    if groups:
        axes.legend(fontsize=8)
    return figure


def strength_of(effect, value):
    """Logarithm of the distance from where the effect fades."""
    if effect == "parameter-error":
        return abs(np.log(value))
    nothing = 1.0 if effect in ("sensor-gain", "sleeper-passing", "contact-nonlinearity") else 0.0
    return np.log(max(abs(value - nothing), 1e-12))


def draw_detectability(score, rows):
    """A line per effect: its trials from the weakest to the strongest that was drawn, on a logarithmic scale of its own."""
    inverted = {d["effect"] for d in score["detectability"] if d["weak_when_large"]}
    rows = [r for r in rows if r["kind"] in ("single", "sensor", "outside", "parameter-error") and r["strength"] and r["verdict"] != "failed"]
    effects = {}
    for row in rows:
        effects.setdefault(row["hidden"].split(" (")[0], []).append(row)
    names = sorted(effects, reverse=True)
    figure, axes = plt.subplots(figsize=(7.5, 1.4 + 0.32 * max(1, len(names))), layout="constrained")
    seen = {}
    for level, name in enumerate(names):
        sign = -1.0 if name in inverted else 1.0
        strengths = {row["trial"]: sign * strength_of(name, float(row["strength"])) for row in effects[name]}
        low, high = min(strengths.values()), max(strengths.values())
        for row in effects[name]:
            label, colour = judged(row)
            share = (strengths[row["trial"]] - low) / (high - low) if high > low else 0.5
            seen[label] = axes.scatter(share, level, color=colour, s=26, zorder=3)
        ends = sorted((float(row["strength"]) for row in effects[name]), key=lambda v: strength_of(name, v))
        if name in inverted:
            ends.reverse()
        axes.annotate(f"{ends[0]:.3g}", (-0.03, level), ha="right", va="center", fontsize=7)
        if len(ends) > 1:
            axes.annotate(f"{ends[-1]:.3g}", (1.03, level), ha="left", va="center", fontsize=7)
    axes.set_yticks(range(len(names)), names, fontsize=8)
    axes.set(xlim=(-0.4, 1.4), xticks=[], xlabel="weakest to strongest drawn, each on its own logarithmic scale", title="How strong an effect has to be")
    axes.hlines(range(len(names)), 0.0, 1.0, color="lightgrey", linewidth=0.8)
    if seen:
        axes.legend(seen.values(), seen.keys(), fontsize=8, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="--out of railpem prove")
    parser.add_argument("--out", type=pathlib.Path, help="folder for the figures; figures/ in the proof's own without it")
    arguments = parser.parse_args()
    score, rows = read_proof(arguments.folder)
    out = arguments.out or arguments.folder / "figures"
    out.mkdir(parents=True, exist_ok=True)
    figures = {"confusion": draw_confusion(score), "calibration": draw_calibration(score), "concealment": draw_concealment(rows), "detectability": draw_detectability(score, rows)}
    for name, figure in figures.items():
        path = out / f"{name}.png"
        figure.savefig(path, dpi=130)
        print(path)


if __name__ == "__main__":
    main()
