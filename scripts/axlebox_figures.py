"""Figures of the study of two kilometres of axle-box acceleration."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.signal import welch

from axlebox_bands import CENTRES_HZ, nominal
from axlebox_lines import is_whole
from axlebox_recording import RATE_HZ, SIDES

COLOURS = {"km1": "C0", "km2": "C3"}
PARTS = {"wheel": ("out-of-round wheel", "C1"), "supports": ("sleeper passing", "C2"),
         "places": ("single places: joints, switches, dips", "C4"), "steady": ("steady: rail surface through car and track", "0.65")}


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=100)
    plt.close(figure)


def overview(records, rotation, path):
    """Spectra of both kilometres; what is common to both and what is in one only is marked."""
    figure, axes = plt.subplots(2, 1, figsize=(11, 8), sharex=True)
    for axis, side in zip(axes, SIDES):
        for name, x in reversed(records.items()):  # the first in front
            f, p = welch(x[side], RATE_HZ, nperseg=8192)
            axis.loglog(f[1:], p[1:], color=COLOURS[name], lw=0.8, label=name)
        axis.set(xlim=(10, 900), ylim=(1e-4, 8.0), title=f"{side} side", ylabel="PSD, unit²/Hz")
        axis.axvspan(45, 82, color="C3", alpha=0.10)
        for order in range(11, 30):
            axis.axvline(order * rotation["km1"], color="C1", lw=0.5, alpha=0.7, zorder=0)
        axis.grid(True, which="major", alpha=0.3)
    axes[0].annotate("km2 only: 45 to 82 Hz,\nten times the power", (51, 0.3), (13, 1.0), arrowprops={"arrowstyle": "->"})
    axes[0].annotate("both: multiples of the rotation,\none wheelset out of round", (139, 0.35), (220, 0.7), arrowprops={"arrowstyle": "->"})
    axes[1].annotate("both: peaks near 475 Hz,\ndo not move with the speed", (472, 0.05), (230, 0.6), arrowprops={"arrowstyle": "->"})
    axes[0].legend(loc="lower left")
    axes[1].set_xlabel("frequency at constant rotation of the wheel, Hz")
    save(figure, path)


def lines(found, tests, path):
    """Amplitudes of the wheel's orders in the seen and the unseen part of both kilometres."""
    figure, axes = plt.subplots(2, 1, figsize=(11, 7), sharex=True, sharey=True)
    marks = {("km1", "seen"): ("o", 7, "full"), ("km1", "unseen"): ("o", 11, "none"), ("km2", "seen"): ("s", 7, "full"), ("km2", "unseen"): ("s", 11, "none")}
    for axis, side in zip(axes, SIDES):
        for (name, part), (mark, size, fill) in marks.items():
            own = [line for line in found[name][part][side] if is_whole(line.order)]
            axis.semilogy([round(line.order) for line in own], [line.rms for line in own], mark, ms=size, fillstyle=fill, color=COLOURS[name], label=f"{name}, {part}")
        axis.set(title=f"{side} wheel", ylabel="rms of the line, unit")
        axis.grid(True, which="both", alpha=0.3)
    axes[0].legend(loc="lower left", ncol=2, fontsize=8)
    axes[1].set(xlabel="order: waves around the wheel", xticks=range(5, 31))
    figure.suptitle("The same wheel in both kilometres: lines beyond chance (1 % over the whole search)")
    save(figure, path)


def shares(parts, path):
    """Share of the whole mean square by third-octave and cause, sides averaged."""
    figure, axes = plt.subplots(1, 2, figsize=(12, 4.5), sharey=True)
    places = np.arange(len(CENTRES_HZ))
    for axis, (name, sides) in zip(axes, parts.items()):
        base = np.zeros(len(places))
        for key, (label, colour) in PARTS.items():
            heights = np.mean([100.0 * sides[s][key] / sum(v.sum() for v in sides[s].values()) for s in SIDES], axis=0)
            axis.bar(places, heights, bottom=base, color=colour, label=f"{label}: {heights.sum():.1f} %", width=0.85)
            base += heights
        axis.set(title=name, xlabel="third-octave, Hz", xticks=places)
        axis.set_xticklabels([nominal(c) for c in CENTRES_HZ], rotation=90)
        axis.legend(fontsize=8, loc="upper left")
        axis.set_ylim(0, 60)
        axis.grid(True, axis="y", alpha=0.3)
    axes[0].set_ylabel("share of the mean square, %")
    save(figure, path)


def difference(rows, path):
    """Level of the second kilometre over the first; filled where it is beyond chance."""
    figure, axes = plt.subplots(1, 2, figsize=(12, 4.5), sharey=True)
    places = np.arange(len(CENTRES_HZ))
    for axis, side in zip(axes, SIDES):
        for part, colour, shift in (("seen", "k", -0.15), ("unseen", "C0", 0.15)):
            value, half, chance = rows[part][side]
            axis.errorbar(places + shift, value, half, fmt="none", color=colour, lw=1)
            for sure in (True, False):
                inside = (chance <= 0.01) == sure
                label = f"{part} {'two thirds' if part == 'seen' else 'third'}" if sure else None
                axis.plot((places + shift)[inside], value[inside], "o", color=colour, fillstyle="full" if sure else "none", label=label)
        axis.axhline(0.0, color="0.5", lw=0.8)
        axis.set(title=f"{side}: km2 over km1, lines lowered", xlabel="third-octave, Hz", xticks=places)
        axis.set_xticklabels([nominal(c) for c in CENTRES_HZ], rotation=90)
        axis.grid(True, alpha=0.3)
    axes[0].set_ylabel("dB, with 90 % interval\nfilled: beyond chance (1 % over all)")
    axes[0].legend(loc="upper right")
    save(figure, path)


def diagnosed(panels, path):
    """Recorded against believed, retuned and diagnosed, one panel per kilometre and side."""
    figure, axes = plt.subplots(2, 2, figsize=(12, 8), sharex=True)
    for axis, (title, columns) in zip(axes.flat, panels):
        f = columns["frequency_hz"]
        column = lambda name: columns[f"{name}_psd_m2_per_s4_per_hz"]
        axis.fill_between(f, column("low"), column("high"), color="0.8", label="recorded, 90 %")
        for name, style in (("believed", "C0--"), ("retuned", "C1:"), ("diagnosed", "C2-")):
            axis.semilogy(f, column(name), style, lw=1.2, label=name)
        axis.set(title=title, ylim=(0.3 * np.percentile(column("low"), 5), 4.0 * column("high").max()))
        axis.grid(True, which="major", alpha=0.3)
    for axis in axes[1]:
        axis.set_xlabel("frequency, Hz")
    axes[0, 0].legend(fontsize=8, loc="lower center")
    axes[0, 0].set_ylabel("PSD, unit²/Hz")
    axes[1, 0].set_ylabel("PSD, unit²/Hz")
    figure.suptitle("Whole records, lines of the wheel lowered; models fitted to the first two thirds")
    save(figure, path)
