#!/usr/bin/env python3
"""A figure per effect of the library: what it does to the spectra of axle box, bogie and car body of case 1 of Wei et al. (2016).

Every effect acts at its typical strength unless the figure says otherwise. Run after a change of the library or of the physics:

    /usr/bin/python3 scripts/plot_effects.py [EFFECT …]
"""
import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from effect_figures import FIGURES

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE = ROOT / "cases/wei2016/case1.toml"
PLACES = {"wheel_1": "axle box 1", "wheel_2": "axle box 2", "bogie_1": "bogie 1", "body_front": "car body over bogie 1", "body": "car body, centre"}
WITHOUT = "#9ca3af"
COLOURS = ("#dc2626", "#2563eb")

plt.rcParams.update({
    "font.size": 9, "axes.formatter.useoffset": False, "axes.titlesize": 10, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
    "grid.color": "#e5e7eb", "grid.linewidth": 0.7, "axes.axisbelow": True, "legend.frameon": False, "lines.linewidth": 1.1,
})


def table_text(identifier, values):
    """The [[effect]] table of a case file."""
    lines = [f"{name} = {value!r}".replace("'", '"') for name, value in values.items()]
    return "\n".join(["", "[[effect]]", f'id = "{identifier}"', *lines, ""])


def solve(program, folder, name, text, options):
    """Spectra of the case by column, as `railpem solve` writes them."""
    case = folder / f"{name}.toml"
    case.write_text(text)
    command = [program, "solve", case, "--out", folder / name]
    for option in options:
        command += ["--set", option]
    subprocess.run(command, check=True)
    with open(folder / name / f"{name}.psd.csv", newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    values = np.array(rows[1:], dtype=float)
    return {column: values[:, i] for i, column in enumerate(rows[0])}


def spectrum(table, where):
    return table[f"{where}_acceleration_psd_m2_per_s4_per_hz"]


def smooth(f, psd):
    """The spectrum averaged over 3 % of the frequency, at least 0.7 Hz: where the wheels of a bogie cancel each other exactly a
    single line is rounding and its ratio says nothing."""
    running = np.concatenate(([0.0], np.cumsum(psd)))
    half = np.maximum(0.015 * f, 0.35) / (f[1] - f[0])
    middle = np.arange(len(f))
    first = np.maximum(0, np.round(middle - half)).astype(int)
    last = np.minimum(len(f), np.round(middle + half).astype(int) + 1)
    return (running[last] - running[first]) / (last - first)


def draw_place(axes, where, without, with_effect, low_hz, mean):
    """Spectra above, differences of level below."""
    above, below = axes
    seen = without["frequency_hz"] >= low_hz
    f = without["frequency_hz"][seen]
    without, with_effect = ({name: column[seen] for name, column in without.items()},
                            {label: {name: column[seen] for name, column in table.items()} for label, table in with_effect.items()})
    above.loglog(f, spectrum(without, where), color=WITHOUT, label="believed case", linewidth=1.6)
    for (label, table), colour in zip(with_effect.items(), COLOURS):
        above.loglog(f, spectrum(table, where), color=colour, label=label)
        below.semilogx(f, 10 * np.log10(mean(f, spectrum(table, where)) / mean(f, spectrum(without, where))), color=colour)
    top = max(spectrum(table, where).max() for table in [without, *with_effect.values()])
    above.set(title=PLACES[where], ylim=(2e-6 * top, 3 * top), xlim=(f[0], f[-1]))
    largest = max(np.abs(line.get_ydata()).max() for line in below.lines)
    span = max(1.15 * largest, 0.1)
    below.set(xlabel="frequency, Hz", ylim=(-span, span), xlim=(f[0], f[-1]))
    below.axhline(0.0, color=WITHOUT, linewidth=1.2, zorder=1)
    below.set_xticks([tick for tick in (0.5, 1, 2, 5, 10, 20, 50, 100, 200) if tick >= f[0]])
    below.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    below.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def draw(identifier, figure, without, with_effect, target):
    places = figure.get("places", ("wheel_1", "bogie_1", "body_front"))
    drawing, axes = plt.subplots(2, 3, figsize=(10.8, 5.6), sharex=True, height_ratios=(3, 2))
    mean = (lambda f, psd: psd) if figure.get("lines") else smooth
    for column, where in enumerate(places):
        draw_place(axes[:, column], where, without, with_effect, figure.get("from_hz", 0.3), mean)
    axes[0, 0].set_ylabel("acceleration PSD, (m/s²)²/Hz")
    axes[1, 0].set_ylabel("with over without, dB")
    axes[0, 0].legend(loc="lower left", fontsize=8)
    drawing.suptitle(f"{identifier}: {figure['title']}", x=0.01, y=0.99, ha="left", fontsize=11.5, fontweight="bold")
    drawing.text(0.01, 0.94, figure["text"], ha="left", va="top", fontsize=9, linespacing=1.35)
    drawing.tight_layout(rect=(0, 0, 1, 0.955 - 0.030 * (figure["text"].count("\n") + 1)))
    drawing.savefig(target, dpi=85, metadata={"Software": None})
    plt.close(drawing)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("effects", nargs="*", help="identifiers; without any, all")
    parser.add_argument("--program", default=ROOT / "build/release/railpem", type=pathlib.Path)
    parser.add_argument("--out", default=ROOT / "docs/effects", type=pathlib.Path)
    arguments = parser.parse_args()
    if unknown := [name for name in arguments.effects if name not in FIGURES]:
        sys.exit(f"no figure for {', '.join(unknown)}; there are {', '.join(FIGURES)}")
    arguments.out.mkdir(parents=True, exist_ok=True)
    believed = CASE.read_text()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for identifier in arguments.effects or FIGURES:
            figure = FIGURES[identifier]
            options = figure.get("believed", ())
            text = believed + figure.get("believed_effects", "")
            without = solve(arguments.program, folder, "without", text, options)
            with_effect = {label: solve(arguments.program, folder, f"with_{number}", text + table_text(identifier, values), options)
                           for number, (label, values) in enumerate(figure["variants"].items())}
            target = arguments.out / f"{identifier}.png"
            draw(identifier, figure, without, with_effect, target)
            print(target)


if __name__ == "__main__":
    main()
