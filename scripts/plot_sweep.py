#!/usr/bin/env python3
"""Draws the long table of `railpem sweep`: one panel per quantity and response.

With one varied parameter a line; with two of them a map, or a family of lines where the second takes few values; with bands or spectra
the frequency is the horizontal axis and the first parameter the colour.

    scripts/plot_sweep.py out/pads.sweep.csv --out out/figures
"""
import argparse
import csv
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

FIXED = {"case", "speed_m_per_s", "quantity", "response", "frequency_hz", "value"}
WORDS = {
    "peak_level_m2_per_s4_per_hz": "peak of the acceleration PSD, (m/s²)²/Hz",
    "peak_level_n2_per_hz": "peak of the force PSD, N²/Hz",
    "peak_frequency_hz": "frequency of the peak, Hz",
    "rms_m_per_s2": "rms acceleration, m/s²",
    "rms_n": "rms force, N",
    "level_db": "third-octave level, dB re 1e-6 m/s²",
    "level_db_re_1_n": "third-octave level, dB re 1 N",
    "psd_m2_per_s4_per_hz": "acceleration PSD, (m/s²)²/Hz",
    "psd_n2_per_hz": "force PSD, N²/Hz",
}


def read_table(path):
    """Rows of the table with numbers as numbers, and the names of the varied keys."""
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(line for line in file if not line.startswith("#"))
        keys = [name for name in reader.fieldnames if name not in FIXED]
        rows = []
        for row in reader:
            for name in [*keys, "value"]:
                row[name] = float(row[name])
            row["frequency_hz"] = float(row["frequency_hz"]) if row["frequency_hz"] else None
            rows.append(row)
    return rows, keys


def short(key):
    """The last two parts of a dotted key, enough to know it by."""
    return ".".join(key.split(".")[-2:])


def draw_map(axes, rows, keys, label):
    xs, ys = (sorted({row[key] for row in rows}) for key in keys[:2])
    grid = np.full((len(ys), len(xs)), np.nan)
    for row in rows:
        grid[ys.index(row[keys[1]]), xs.index(row[keys[0]])] = row["value"]
    if np.isnan(grid).any():  # a hypercube or a list: points
        points = axes.scatter([row[keys[0]] for row in rows], [row[keys[1]] for row in rows], c=[row["value"] for row in rows], s=12, cmap="viridis")
        axes.figure.colorbar(points, ax=axes, label=label)
    else:
        mesh = axes.pcolormesh(xs, ys, grid, cmap="viridis", shading="nearest")
        axes.figure.colorbar(mesh, ax=axes, label=label)
        lines = axes.contour(xs, ys, grid, colors="white", linewidths=0.8)
        axes.clabel(lines, fontsize=7, fmt="%g")
    axes.set_xlabel(short(keys[0]))
    axes.set_ylabel(short(keys[1]))


def draw_frequencies(axes, rows, keys, label):
    """Curves over frequency, one per value of the first key; further keys at the middle of their values."""
    for key in keys[1:]:
        values = sorted({row[key] for row in rows})
        rows = [row for row in rows if row[key] == values[len(values) // 2]]
    values = sorted({row[keys[0]] for row in rows})
    colours = plt.get_cmap("viridis")(np.linspace(0, 0.95, len(values)))
    for value, colour in zip(values, colours):
        curve = sorted((row["frequency_hz"], row["value"]) for row in rows if row[keys[0]] == value)
        axes.plot(*zip(*curve), color=colour, linewidth=1.2)
    axes.set_xscale("log")
    if "psd" in rows[0]["quantity"]:
        axes.set_yscale("log")
    axes.set_xlabel("frequency, Hz")
    axes.set_ylabel(label)
    span = plt.Normalize(values[0], values[-1] if len(values) > 1 else values[0] + 1)
    axes.figure.colorbar(plt.cm.ScalarMappable(span, "viridis"), ax=axes, label=short(keys[0]))
    if len(keys) > 1:
        axes.text(0.01, 0.01, "others at the middle of their values", transform=axes.transAxes, fontsize=7, color="0.4")


def draw_panel(axes, rows, keys):
    label = WORDS.get(rows[0]["quantity"], rows[0]["quantity"])
    axes.set_title(f"{rows[0]['response']}: {label.split(',')[0]}", fontsize=10)
    if rows[0]["frequency_hz"] is not None:
        draw_frequencies(axes, rows, keys, label)
    elif len(keys) > 1:
        draw_map(axes, rows, keys, label)
    else:
        curve = sorted((row[keys[0]], row["value"]) for row in rows)
        axes.plot(*zip(*curve), marker="o", markersize=3)
        axes.set_xlabel(short(keys[0]))
        axes.set_ylabel(label)
        axes.grid(alpha=0.3)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("table", type=pathlib.Path, help="DIR/<sweep>.csv")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the figure")
    arguments = parser.parse_args()
    rows, keys = read_table(arguments.table)
    panels = {}
    for row in rows:
        panels.setdefault((row["response"], row["quantity"], row.get("speed_m_per_s")), []).append(row)
    columns = min(2, len(panels))
    lines = -(-len(panels) // columns)
    figure, axes = plt.subplots(lines, columns, figsize=(6.4 * columns, 4.4 * lines), squeeze=False, constrained_layout=True)
    for panel, place in zip(panels.values(), axes.flat):
        draw_panel(place, panel, keys)
    for place in list(axes.flat)[len(panels):]:
        place.remove()
    arguments.out.mkdir(parents=True, exist_ok=True)
    for ending in ("png", "svg"):
        figure.savefig(arguments.out / f"{arguments.table.stem}.{ending}", dpi=110)
    print(arguments.out / f"{arguments.table.stem}.png")


if __name__ == "__main__":
    main()
