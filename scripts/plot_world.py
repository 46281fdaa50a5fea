#!/usr/bin/env python3
"""Draws what the good and the worn world do to a recording, and writes the table of their numbers into docs/world.md.

Speed against time, stiffness of the seats along the line and the noise of a channel come from recordings that the
program makes for this; the table is what `railpem simulate --list` says.

    scripts/plot_world.py build/release/railpem
"""
import argparse
import csv
import json
import pathlib
import re
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "cases/wei2016/case1.toml"
GRADES = {"good": "#1b6ca8", "worn": "#c4572b"}
BEGIN, END = "<!-- world: begin -->", "<!-- world: end -->"


def record(program, folder, world, *options):
    """Columns of a recording by name, and the truth about it."""
    out = pathlib.Path(folder) / world.split(":")[0]
    subprocess.run([program, "simulate", CASE, "--seconds", "60", "--seed", "3", "--world", world, "--out", out, "--truth", out / "truth.json",
                    *options], check=True)
    with open(out / "recording.csv", newline="", encoding="utf-8") as file:
        names = next(csv.reader(line for line in file if not line.startswith("#")))
        columns = np.loadtxt(file, delimiter=",", unpack=True)
    return dict(zip(names, columns)), json.loads((out / "truth.json").read_text(encoding="utf-8"))


def welch(samples, rate, length=4000):
    """One-sided spectral density: Hann windows of `length` samples, half overlapping."""
    window = np.hanning(length)
    parts = [samples[i:i + length] - samples[i:i + length].mean() for i in range(0, len(samples) - length + 1, length // 2)]
    power = np.mean([np.abs(np.fft.rfft(window * part)) ** 2 for part in parts], axis=0)
    return np.fft.rfftfreq(length, 1.0 / rate)[1:], 2.0 * power[1:] / (rate * np.sum(window ** 2))


def draw(program, folder):
    figure, (speed, seats, noise) = plt.subplots(3, 1, figsize=(8.0, 9.0), constrained_layout=True)
    for grade, colour in GRADES.items():
        columns, truth = record(program, folder, grade, "--speed-channel")
        speed.plot(columns["time_s"], columns["speed"], color=colour, label=grade)
        drawn = truth["world"]["drawn"]["seats"]
        along = 0.6 * (drawn["first"] + np.arange(len(drawn["pad_stiffness"])))
        near = (along >= 0.0) & (along <= 150.0)
        seats.plot(along[near], np.array(drawn["pad_stiffness"])[near], ".", markersize=4, color=colour, label=f"{grade}: pads")
        seats.plot(along[near], np.array(drawn["support_stiffness"])[near], color=colour, linewidth=2, label=f"{grade}: ground")
        # A car that stands on a line without irregularity records the noise alone.
        columns, truth = record(program, folder, grade + ":impacts_per_km=0", "--standing", "--set", "irregularity.level_db=-60")
        frequency, density = welch(columns["body_centre"], 1000.0)
        noise.loglog(frequency, np.sqrt(density), color=colour, linewidth=0.8, alpha=0.7, label=grade)
        world = truth["world"]["parameters"]
        white = world["noise_rms_m_per_s2"] ** 2 / (499.5 + world["noise_corner_hz"] * np.log(1000.0))
        noise.loglog(frequency, np.sqrt(white * (1.0 + world["noise_corner_hz"] / frequency)), color="black", linewidth=1.0, linestyle="--")
    speed.set(xlabel="time, s", ylabel="speed, m/s", xlim=(0, 60))
    seats.set(xlabel="along the line, m", ylabel="stiffness over the case's", xlim=(0, 150))
    noise.set(xlabel="frequency, Hz", ylabel="noise, (m/s²)/√Hz", xlim=(0.5, 450))
    noise.plot([], [], color="black", linewidth=1.0, linestyle="--", label="white and 1/f")
    for axes in (speed, seats, noise):
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8, ncols=2)
    figure.savefig(ROOT / "docs/world.png", dpi=110)


def table(program):
    """The numbers of a world as `simulate --list` says them, in Markdown."""
    listed = subprocess.run([program, "simulate", "--list"], check=True, capture_output=True, text=True).stdout
    listed = listed[listed.index("How imperfect the world is"):]
    rows = re.findall(r"^    (\w+) +(\S+), (\S+), (\S+?)(?: (\S+))?; between (\S+) and (\S+)(?: \S+)?: (.*)\n        (.*)$", listed, re.MULTILINE)
    lines = ["| number | unit | ideal | good | worn | allowed | what it is | source |", "|---|---|---|---|---|---|---|---|"]
    for name, ideal, good, worn, unit, low, high, says, source in rows:
        lines.append(f"| `{name}` | {unit} | {ideal} | {good} | {worn} | {low} to {high} | {says} | {source} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="railpem")
    program = str(pathlib.Path(parser.parse_args().program).resolve())
    with tempfile.TemporaryDirectory() as folder:
        draw(program, folder)
    page = ROOT / "docs/world.md"
    text = page.read_text(encoding="utf-8")
    before, after = text[:text.index(BEGIN) + len(BEGIN)], text[text.index(END):]
    page.write_text(f"{before}\n\n{table(program)}\n\n{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
