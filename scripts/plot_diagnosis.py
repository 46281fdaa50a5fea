#!/usr/bin/env python3
"""Figures of a diagnosis, from diagnosis.json and the tables beside it: the worst channel, the map of level differences, the
retuned parameters and the inferred dynamic stiffness, as PNG.

    build/release/railpem diagnose cases/wei2016/case1.toml run1 --out out/diagnosis
    scripts/plot_diagnosis.py out/diagnosis
"""
import argparse
import csv
import json
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

plt.rcParams.update({
    "figure.dpi": 110, "savefig.dpi": 150, "font.size": 11, "axes.titlesize": 12, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
    "grid.color": "#e5e7eb", "grid.linewidth": 0.8, "axes.axisbelow": True, "legend.frameon": False, "lines.linewidth": 1.6,
})
COLOURS = {"measured": "#1c2126", "believed": "#1f66c7", "retuned": "#c2620a", "diagnosed": "#14795a"}
DASHES = {"measured": "-", "believed": "--", "retuned": ":", "diagnosed": "-"}
MODELS = ("believed", "retuned", "diagnosed")
TICKS = [0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000]
PSD = "_psd_m2_per_s4_per_hz"
MOST_BARS = 14


def read_rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def column(rows, name):
    """Numbers; an empty cell is NaN."""
    return np.array([float(row[name]) if row[name] else np.nan for row in rows])


def by_channel(rows):
    channels = {}
    for row in rows:
        channels.setdefault(row["channel"], []).append(row)
    return channels


def frequency_axis(axes, low, high):
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    ticks = [tick for tick in TICKS if low <= tick <= high]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()


def worst(diagnosis, bands):
    """(recording, channel) of the most certain mismatch, or else of the largest level differences."""
    for mismatch in diagnosis["mismatch"]:
        for recording, channels in bands.items():
            if mismatch["channel"] in channels and mismatch.get("recording") in ("", None, recording):
                return recording, mismatch["channel"]

    def rms(rows):
        levels = column(rows, "believed_level_difference_db")
        return np.sqrt(np.nanmean(levels**2)) if np.isfinite(levels).any() else -1.0

    return max(((recording, channel) for recording, channels in bands.items() for channel in channels),
               key=lambda pair: rms(bands[pair[0]][pair[1]]))


def draw_spectra(folder, recording, channel, bands):
    rows = by_channel(read_rows(folder / f"{recording}.spectra.csv"))[channel]
    figure, (spectrum, level) = plt.subplots(2, 1, figsize=(8.6, 7.4), height_ratios=[2, 1], sharex=True, constrained_layout=True)
    f = column(rows, "frequency_hz")
    spectrum.fill_between(f, column(rows, "low" + PSD), column(rows, "high" + PSD), color=COLOURS["measured"], alpha=0.2, linewidth=0)
    for what in ("measured", "diagnosed", "retuned", "believed"):
        spectrum.plot(f, column(rows, what + PSD), color=COLOURS[what], linestyle=DASHES[what], linewidth=1.0 if what == "measured" else 1.6,
                      label="recorded, 90 %" if what == "measured" else what)
    spectrum.set_yscale("log")
    spectrum.set_ylabel("PSD, (m/s²)²/Hz")
    spectrum.set_title(f"Worst channel: {channel}, {recording}")
    spectrum.legend(loc="lower right")
    centres = column(bands, "centre_hz")
    for what in MODELS:
        level.plot(centres, column(bands, what + "_level_difference_db"), color=COLOURS[what], linestyle=DASHES[what], marker="o", markersize=3.5)
    level.axhline(0.0, color=COLOURS["measured"], linewidth=0.8)
    level.set_ylabel("recording over model, dB")
    level.set_xlabel("frequency, Hz")
    frequency_axis(level, f[f > 0][0], f[-1])
    return figure


def draw_map(diagnosis, bands):
    """Believed, retuned and diagnosed beside each other; outlined: beyond chance after retuning."""
    rows = sorted(((channel, recording) for recording, channels in bands.items() for channel in channels))
    shown = [what for what in MODELS if any(np.isfinite(column(bands[r][c], what + "_level_difference_db")).any() for c, r in rows)]
    levels = {what: [column(bands[r][c], what + "_level_difference_db") for c, r in rows] for what in shown}
    largest = max(1.0, max(np.nanmax(np.abs(np.concatenate(values))) for values in levels.values()))
    norm = matplotlib.colors.SymLogNorm(linthresh=0.1 * largest, vmin=-largest, vmax=largest)  # small ones stay visible
    figure, panels = plt.subplots(1, len(shown), figsize=(4.6 * len(shown) + 1.2, 0.26 * len(rows) + 2.2), sharey=True, squeeze=False,
                                  constrained_layout=True)
    for axes, what in zip(panels[0], shown):
        for y, ((channel, recording), values) in enumerate(zip(rows, levels[what])):
            centres = column(bands[recording][channel], "centre_hz")
            edges = np.append(centres * 10**-0.05, centres[-1] * 10**0.05)
            image = axes.pcolormesh(edges, [y - 0.5, y + 0.5], values[None, :], cmap="RdBu_r", norm=norm)
        for mismatch in diagnosis["mismatch"] if what != "diagnosed" else []:
            for y, (channel, recording) in enumerate(rows):
                if channel in (mismatch["channel"], mismatch.get("other_channel")) and mismatch.get("recording") in ("", None, recording):
                    axes.add_patch(matplotlib.patches.Rectangle(
                        (mismatch["low_hz"], y - 0.45), mismatch["high_hz"] - mismatch["low_hz"], 0.9, fill=False, linewidth=1.4,
                        linestyle="--" if mismatch.get("other_channel") else "-"))
        frequency_axis(axes, edges[0], edges[-1])
        axes.set_yticks(range(len(rows)), [f"{channel}  {recording}" for channel, recording in rows])
        axes.grid(False)
        axes.set_xlabel("third octave, Hz")
        axes.set_title(f"Recording over {what}")
    panels[0][0].invert_yaxis()
    figure.colorbar(image, ax=panels[0][-1], label="dB", ticks=[-largest, -0.1 * largest, 0, 0.1 * largest, largest], format="%.2g")
    return figure


def draw_parameters(rows):
    away = {fit: {row["key"]: float(row["tolerances_away"]) for row in rows if row["fit"] == fit and row["tolerances_away"]}
            for fit in ("retuned", "diagnosed")}
    keys = sorted(away["retuned"], key=lambda key: -abs(away["retuned"][key]))[:MOST_BARS]
    if not keys:
        return None
    figure, axes = plt.subplots(figsize=(9.0, 0.5 * len(keys) + 1.6), constrained_layout=True)
    axes.axvspan(-2, 2, color="#e5e7eb", alpha=0.7, linewidth=0)
    for shift, fit in ((-0.18, "retuned"), (0.18, "diagnosed")):
        axes.barh([y + shift for y in range(len(keys))], [away[fit].get(key, 0.0) for key in keys], height=0.34, color=COLOURS[fit], label=fit)
    axes.axvline(0.0, color=COLOURS["measured"], linewidth=0.8)
    axes.set_yticks(range(len(keys)), keys)
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("tolerances away from what was believed (shaded: within two)")
    axes.set_title("What calibration would have hidden")
    axes.legend(loc="best")
    return figure


def draw_curve(element, rows):
    figure, panels = plt.subplots(1, 2, figsize=(10.4, 4.2), constrained_layout=True)
    f = column(rows, "frequency_hz")
    for axes, part in zip(panels, ("real", "imaginary")):
        axes.fill_between(f, column(rows, part + "_low"), column(rows, part + "_high"), color=COLOURS["measured"], alpha=0.2, linewidth=0)
        axes.plot(f, column(rows, part), color=COLOURS["measured"], label="inferred, 90 %")
        for what in ("retuned", "diagnosed"):
            axes.plot(f, column(rows, f"{what}_{part}"), color=COLOURS[what], linestyle=DASHES[what], label=what)
        axes.set_ylabel(f"{part} part, {rows[0]['unit']}")
        axes.set_xlabel("frequency, Hz")
        frequency_axis(axes, f[0], f[-1])
    panels[0].set_title(f"Dynamic stiffness inferred at: {element}")
    panels[0].legend(loc="best")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="folder that `railpem diagnose` wrote")
    folder = parser.parse_args().folder
    diagnosis = json.loads((folder / "diagnosis.json").read_text(encoding="utf-8"))
    bands = {path.name.removesuffix(".bands.csv"): by_channel(read_rows(path)) for path in sorted(folder.glob("*.bands.csv"))}
    figures = {"parameters": draw_parameters(read_rows(folder / "parameters.csv"))}
    if bands:
        recording, channel = worst(diagnosis, bands)
        figures["worst_channel"] = draw_spectra(folder, recording, channel, bands[recording][channel])
        figures["mismatch"] = draw_map(diagnosis, bands)
    curves = {}
    for row in read_rows(folder / "curves.csv"):
        curves.setdefault(row["element"], []).append(row)
    for element, rows in curves.items():
        figures[f"curve_{element}"] = draw_curve(element, rows)
    for name, figure in figures.items():
        if figure is not None:
            figure.savefig(folder / f"{name}.png")
            print(folder / f"{name}.png")


if __name__ == "__main__":
    main()
