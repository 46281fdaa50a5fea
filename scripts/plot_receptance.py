#!/usr/bin/env python3
"""Receptance over a pad and in the middle of a bay, and the decay rates of EN 15461 and of the Bloch wave, from the tables of
`railpem receptance`.

    build/release/railpem receptance cases/ballasted/uic60.toml --out out/uic60
    scripts/plot_receptance.py out/uic60/uic60.receptance.csv --out out/uic60/figures
"""
import argparse
import csv
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

plt.rcParams.update({
    "figure.dpi": 110, "savefig.dpi": 150, "svg.hashsalt": "railpem", "font.size": 11, "axes.titlesize": 12,
    "axes.titleweight": "bold", "axes.titlelocation": "left", "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": "#e5e7eb", "grid.linewidth": 0.8, "axes.axisbelow": True, "legend.frameon": False,
    "lines.linewidth": 1.6,
})
BLUE, RED, GREY = "#2563eb", "#dc2626", "#6b7280"
TICKS = [20, 50, 100, 200, 500, 1000, 2000, 5000]


def read_table(path):
    """A CSV table as columns by name."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    values = np.array(rows[1:], dtype=float)
    return {name: values[:, i] for i, name in enumerate(rows[0])}


def frequency_axis(axes, low, high):
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    ticks = [tick for tick in TICKS if low <= tick <= high]
    axes.set_xticks(ticks, [f"{tick}" for tick in ticks])
    axes.minorticks_off()


def draw_receptance(magnitude, phase, table):
    f = table["frequency_hz"]
    for place, colour, label in (("over_pad", BLUE, "over a pad"), ("mid_bay", RED, "in the middle of a bay")):
        receptance = table[f"{place}_re_m_per_n"] + 1j * table[f"{place}_im_m_per_n"]
        magnitude.plot(f, np.abs(receptance), color=colour, label=label)
        phase.plot(f, np.degrees(np.unwrap(np.angle(receptance))), color=colour)
    magnitude.set_yscale("log")
    magnitude.set_ylabel("|receptance|, m/N")
    magnitude.legend(loc="lower left")
    phase.set_ylabel("phase, degrees")
    phase.set_yticks(range(-180, 1, 45))


def draw_decay(axes, table):
    f = table["centre_hz"]
    axes.plot(f, table["decay_rate_db_per_m"], color=BLUE, marker="o", markersize=4, label="EN 15461, from transfer functions")
    axes.plot(f, table["bloch_decay_rate_db_per_m"], color=GREY, marker="s", markersize=3.5, linestyle="--", label="far-reaching Bloch wave")
    axes.set_yscale("log")
    axes.set_ylabel("decay rate, dB/m")
    axes.set_xlabel("frequency, Hz")
    axes.legend(loc="lower left")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("receptance", type=pathlib.Path, help="<case>.receptance.csv, with <case>.decay.csv beside it")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    name = arguments.receptance.name.removesuffix(".receptance.csv")
    table = read_table(arguments.receptance)
    decay = read_table(arguments.receptance.with_name(f"{name}.decay.csv"))
    low, high = table["frequency_hz"][[0, -1]]
    figure, (magnitude, phase, rate) = plt.subplots(3, 1, figsize=(8.0, 9.4), height_ratios=[3, 1.6, 2.4], constrained_layout=True)
    draw_receptance(magnitude, phase, table)
    draw_decay(rate, decay)
    for axes in (magnitude, phase, rate):
        frequency_axis(axes, low, high)
    magnitude.set_title(f"{name}: receptance of the track, at rest")
    rate.set_title("Track decay rate in third-octaves")
    arguments.out.mkdir(parents=True, exist_ok=True)
    for ending in ("png", "svg"):
        figure.savefig(arguments.out / f"{name}.receptance.{ending}")


if __name__ == "__main__":
    main()
