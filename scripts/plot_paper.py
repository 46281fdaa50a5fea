#!/usr/bin/env python3
"""Figures 2 to 5 and 7 to 10 of Wei et al. (2016), redrawn from the tables of `railpem solve` and `railpem static`.

What the paper states in words or tables is marked with open black circles.
"""
import argparse
import csv
import pathlib
import tomllib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import paper_values as paper

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASES = {
    "case1": ("constant secant stiffness (case 1)", "#6b7280"),
    "case2": ("grows with frequency (case 2)", "#2563eb"),
    "case3": ("grows with load and frequency (case 3)", "#dc2626"),
}
CONSISTENT = ("case 3 with one rail in statics and dynamics", "#f59e0b")
PUBLISHED = dict(marker="o", markersize=8, markerfacecolor="none", markeredgecolor="black", markeredgewidth=1.4, linestyle="none")

plt.rcParams.update({
    "figure.figsize": (8.0, 4.6), "figure.dpi": 110, "savefig.dpi": 150, "svg.hashsalt": "railpem",
    "font.size": 11, "axes.titlesize": 12, "axes.titleweight": "bold", "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True, "grid.color": "#e5e7eb", "grid.linewidth": 0.8,
    "axes.axisbelow": True, "legend.frameon": False, "lines.linewidth": 1.6,
})


def read_table(path):
    """A CSV table as columns by name."""
    with open(path, newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    values = np.array(rows[1:], dtype=float)
    return {name: values[:, i] for i, name in enumerate(rows[0])}


class Data:
    """The tables of the four cases and the static curve of the pad."""

    def __init__(self, folder):
        names = [*CASES, "case3_consistent"]
        self.psd = {name: read_table(folder / f"{name}.psd.csv") for name in names}
        self.statics = {name: read_table(folder / f"{name}.static.csv") for name in names}
        with open(ROOT / "cases/wei2016/case3.toml", "rb") as file:
            pads = tomllib.load(file)["track"]["pads"]
        self.curve = np.polynomial.Polynomial(pads["force_polynomial_n"])

    def spectrum(self, case, where):
        table = self.psd[case]
        return table["frequency_hz"], table[f"{where}_acceleration_psd_m2_per_s4_per_hz"]


def published(axes, x, y, label="stated in the paper"):
    axes.plot(x, y, label=label, zorder=5, **PUBLISHED)


def note(axes, text, at, shift, align="left"):
    axes.annotate(text, at, xytext=shift, textcoords="offset points", ha=align, va="center", fontsize=10,
                  arrowprops=dict(arrowstyle="-", color="#9ca3af", linewidth=0.8, shrinkB=5))


def figure_2(axes, data):
    s = np.linspace(0.0, 3.85e-3, 400)
    axes.plot(1e3 * s, 1e-3 * data.curve(s), color="#dc2626", label="F(S), equation (2)")
    low, high = paper.FAR_DEFLECTION_M, paper.LARGEST_DEFLECTION_M
    published(axes, [1e3 * low], [1e-3 * paper.CLIP_PRELOAD_N])
    note(axes, "clips alone: 20 kN at 1.8 mm", (1e3 * low, 20.0), (30, -22))
    axes.axvline(1e3 * high, color="#9ca3af", linewidth=1, linestyle=":")
    note(axes, "under a wheel: 3.4 mm", (1e3 * high, 1e-3 * data.curve(high)), (-40, 18), "right")
    axes.set(xlabel="compression S, mm", ylabel="force F, kN", xlim=(0, 3.9), ylim=(0, 90), title="Figure 2: the pad stiffens under load")


def figure_3(axes, data):
    s = np.linspace(0.0, 3.85e-3, 400)
    axes.plot(1e3 * s, 1e-6 * data.curve.deriv()(s), color="#dc2626", label="K(S) = dF/dS, equation (3)")
    axes.axhline(1e-6 * paper.SECANT_STIFFNESS_N_PER_M, color="#6b7280", linestyle="--", label="secant stiffness, 26.7 kN/mm")
    published(axes, [1.8, 3.4], [19.1, 37.9])
    note(axes, "clips alone: 19.1", (1.8, 19.1), (18, -20))
    note(axes, "under a wheel: 37.9", (3.4, 37.9), (-18, 18), "right")
    axes.set(xlabel="compression S, mm", ylabel="static stiffness K, kN/mm", xlim=(0, 3.9), ylim=(0, 50),
             title="Figure 3: one secant stiffness stands for 19 to 38 kN/mm")


def static_lines(axes, data, column, scale, **style):
    for name, (label, colour) in (("case3", ("as published (lateral I in the statics)", CASES["case3"][1])), ("case3_consistent", CONSISTENT)):
        table = data.statics[name]
        axes.plot(table["position_m"], scale * table[column], marker=".", color=colour, label=label, **style)


def figure_4(axes, data):
    static_lines(axes, data, "deflection_m", 1e3)
    axes.axhline(1e3 * paper.LARGEST_DEFLECTION_M, color="black", linewidth=1, linestyle=":", label="stated in the paper: 3.4 and 1.8 mm")
    axes.axhline(1e3 * paper.FAR_DEFLECTION_M, color="black", linewidth=1, linestyle=":")
    axes.set(xlabel="position along the rail, m", ylabel="pad compression, mm", xlim=(-14, 14), ylim=(3.8, 1.4),
             title="Figure 4: each wheel compresses about three pads")


def figure_5(axes, data):
    static_lines(axes, data, "static_stiffness_n_per_m", 1e-6)
    axes.axhline(1e-6 * paper.SECANT_STIFFNESS_N_PER_M, color="#6b7280", linestyle="--", label="secant stiffness, 26.7 kN/mm")
    axes.axhline(37.9, color="black", linewidth=1, linestyle=":", label="stated in the paper: 37.9 and 19.1 kN/mm")
    axes.axhline(19.1, color="black", linewidth=1, linestyle=":")
    axes.set(xlabel="position along the rail, m", ylabel="static stiffness, kN/mm", xlim=(4.5, 13.5), ylim=(15, 47),
             title="Figure 5: pad stiffness under the front bogie")


def spectra(axes, data, where, widths=(1.6, 1.6, 1.6)):
    for (case, (label, colour)), width in zip(CASES.items(), widths):
        axes.plot(*data.spectrum(case, where), color=colour, label=label, linewidth=width)
    axes.set(xlabel="frequency, Hz", ylabel="PSD of acceleration, (m/s²)²/Hz", xlim=(0, 200))


def figure_7(axes, data):
    spectra(axes, data, "body", widths=(4.5, 2.5, 0.9))  # one over the other, so that all three are seen
    axes.set_yscale("log")
    axes.set(xlim=(0, 100), ylim=(1e-7, 1e-1))
    axes.set_title("Figure 7, car body: up to 60 Hz the pads make no difference")


def figure_8(axes, data):
    spectra(axes, data, "bogie_1")
    for (frequency, levels), letter in zip(paper.BOGIE_LEVELS.items(), "AB"):
        published(axes, [frequency] * len(levels), list(levels.values()), "stated in the paper" if letter == "A" else None)
        note(axes, f"{letter}: {frequency:g} Hz", (frequency, max(levels.values())), (-22, 20) if letter == "A" else (26, 12), "right" if letter == "A" else "left")
    axes.set(ylim=(0, 0.16), title="Figure 8, bogie: stiffer pads, more vibration above 50 Hz")


def peak_figure(axes, data, where, peaks, top, title):
    spectra(axes, data, where)
    for case, (frequency, level) in peaks.items():
        published(axes, [frequency], [level], "stated in the paper" if case == "case1" else None)
    shifts = {"case1": ((-40, 14), "right"), "case2": ((-40, 18), "right"), "case3": ((-30, 30), "right")}
    for case, (frequency, level) in peaks.items():
        note(axes, f"case {case[-1]}: {level:.1f} at {frequency:.1f} Hz", (frequency, level), *shifts[case])
    axes.set(ylim=(0, top), title=title)


def figure_9(axes, data):
    peak_figure(axes, data, "wheel_1", paper.WHEEL_PEAKS, 10.0, "Figure 9, wheel 1: the peak doubles and moves up by 17 Hz")


def figure_10(axes, data):
    peak_figure(axes, data, "rail_1", paper.RAIL_PEAKS, 9.0, "Figure 10, rail under wheel 1: stiffer pads, more vibration from 65 to 150 Hz")


FIGURES = {2: figure_2, 3: figure_3, 4: figure_4, 5: figure_5, 7: figure_7, 8: figure_8, 9: figure_9, 10: figure_10}


def draw(number, data, folder):
    figure, axes = plt.subplots(layout="constrained")
    FIGURES[number](axes, data)
    axes.legend(fontsize=10)
    for kind in ("png", "svg"):
        figure.savefig(folder / f"figure_{number}.{kind}", metadata={"Date": None} if kind == "svg" else None)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tables", type=pathlib.Path, required=True, help="folder with the tables of the four cases")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the figures")
    arguments = parser.parse_args()
    data = Data(arguments.tables)
    arguments.out.mkdir(parents=True, exist_ok=True)
    for number in FIGURES:
        draw(number, data, arguments.out)


if __name__ == "__main__":
    main()
