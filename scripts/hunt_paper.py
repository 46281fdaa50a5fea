#!/usr/bin/env python3
"""Writes docs/paper/hunt.md and its figures: which choice, within what Wei et al. (2016) leave open, brings the twelve
quoted levels how close. Runs the program some 550 times and a finite-element model 40 times: two minutes."""
import argparse
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import hunt_choices
import paper_levels
from hunt_page import PAGE
from paper_levels import ROOT, VARIANTS

GOAL = 0.05
COLOURS = {"case3": "#dc2626", "case3_consistent": "#f59e0b"}

plt.rcParams.update({
    "figure.dpi": 110, "savefig.dpi": 150, "font.size": 11, "axes.titlesize": 12, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
    "grid.color": "#e5e7eb", "axes.axisbelow": True, "legend.frameon": False,
})


def percent(comparison):
    """The rms in per cent, bold where the goal is reached."""
    bold = "**" if comparison.rms_log_ratio <= GOAL else ""
    return f"{bold}{100 * comparison.rms_log_ratio:.1f} %{bold}"


class Row:
    """One choice: its label and the comparison with the paper for both static variants."""

    def __init__(self, choice):
        self.label = choice.label
        spectra = choice.spectra()
        self.comparison = {third: paper_levels.compare(spectra, third, **choice.places) for third in VARIANTS}

    def best(self):
        return min(c.rms_log_ratio for c in self.comparison.values())

    def cells(self):
        """rms, teeth and ranges of the ratios above 50 Hz, for the variants in turn."""
        cells = [self.label]
        for c in self.comparison.values():
            cells += [percent(c), str(c.teeth)]
        ratios = [level.ratio for level in next(iter(self.comparison.values())).levels]
        wheel, rail = ratios[:3], ratios[3:6]
        return cells + [f"{wheel[0]:.2f}, {wheel[1]:.2f}", f"{rail[0]:.2f}, {rail[1]:.2f}"]


HEADER = ["choice", "rms, published", "highest", "rms, Table 2", "highest", "wheel, cases 1, 2", "rail, cases 1, 2"]


def table(header, rows):
    return "\n".join(["| " + " | ".join(header) + " |", "|" + "---|" * len(header)] + ["| " + " | ".join(row) + " |" for row in rows])


def single_table(base, singles):
    rows = [base.cells()]
    for group, choices in singles.items():
        rows += [[f"*{group}*"] + [""] * (len(HEADER) - 1), *(row.cells() for row in choices)]
    return table(HEADER, rows)


def stated_factor(key, value):
    """The factor on a stated value at which the rms is smallest, for both variants: (factor, comparison)."""
    factors = np.linspace(0.90, 1.06, 17) if key.endswith("exponent") else np.exp(np.linspace(-0.6, 0.6, 25))
    found = {}
    for factor in factors:
        spectra = paper_levels.solve([*hunt_choices.COMMON, f"{key}={value * factor!r}"])
        for third in VARIANTS:
            comparison = paper_levels.compare(spectra, third)
            if third not in found or comparison.rms_log_ratio < found[third][1].rms_log_ratio:
                found[third] = (factor, comparison)
    return found


def stated_table():
    rows = []
    for label, (key, value) in hunt_choices.STATED.items():
        cells = [label, f"`{key}`"]
        for factor, comparison in stated_factor(key, value).values():
            cells += [f"{factor:.2f}", percent(comparison), str(comparison.teeth)]
        rows.append(cells)
    return table(["stated", "key", "factor, published", "rms", "highest", "factor, Table 2", "rms", "highest"], rows)


def tilt(comparison):
    """Exponent of the power of frequency that the absolute levels of cases 1 and 2 miss, and what it leaves (rms)."""
    absolute = [level for level in comparison.levels if level.label in
                ("wheel, case 1", "wheel, case 2", "rail, case 1", "rail, case 2", "bogie, case 1")]
    x, y = np.log([l.frequency_hz for l in absolute]), -np.log([l.ratio for l in absolute])
    slope, offset = np.polyfit(x, y, 1)
    return slope, float(np.sqrt(np.mean((y - slope * x - offset) ** 2)))


def absolute_ratios(comparison):
    """The bogie's relative levels made absolute, so that every one of the twelve has a frequency and a ratio."""
    points, reference = [], 1.0
    for level in comparison.levels:
        if "/" in level.label:
            points.append((level.frequency_hz, level.ratio * reference, level.label[:13]))
        else:
            reference = level.ratio
            points.append((level.frequency_hz, level.ratio, level.label))
    return points


def draw_levels(base, closest, path):
    figure, axes = plt.subplots(1, 3, figsize=(13.5, 4.6), sharey=True)
    markers, colours = {"wheel": "o", "rail": "s", "bogie": "^"}, {"1": "#6b7280", "2": "#2563eb", "3": "#dc2626"}
    panels = [(base.comparison["case3"], "As published, endless rail"),
              (base.comparison["case3_consistent"], "Table 2 throughout, endless rail"),
              (closest.comparison["case3"], "As published, 37 pads, 19 modes")]
    for axis, (comparison, title) in zip(axes, panels):
        for frequency, ratio, label in absolute_ratios(comparison):
            what, case = label.split(", case ")
            axis.plot(frequency, ratio, markers[what], color=colours[case], markersize=8, label=label)
        axis.axhline(1, color="black", linewidth=0.8)
        axis.set(xlabel="frequency, Hz")
        axis.set_title(f"{title}: {100 * comparison.rms_log_ratio:.1f} %", fontsize=11)
    f = np.linspace(37, 86, 50)
    slope, _ = tilt(base.comparison["case3"])
    for axis in axes[:2]:
        axis.plot(f, 1.02 * (f / 37) ** -slope, color="#9ca3af", linewidth=1, label=f"f$^{{-{slope:.2f}}}$")
    axes[0].set_ylabel("computed / paper")
    handles = dict(zip(*reversed(axes[1].get_legend_handles_labels())))  # by label: a bogie stands at two frequencies
    axes[1].legend(handles.values(), handles.keys(), fontsize=8, loc="lower left", ncols=2)
    figure.tight_layout()
    figure.savefig(path)
    plt.close(figure)


def draw_rails(base, path):
    """rms over what is open about the rail: where it ends, and how many modes it has."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(12.5, 4.6), sharey=True)
    ends = [(n, over) for n in range(37, 54, 2) for over in (0.0, 0.3)]
    rows = [Row(hunt_choices.finite("", pads=n, beyond_m=over, end="pinned")) for n, over in ends]
    for third, name in VARIANTS.items():
        left.plot([(n - 35) * 0.3 + over for n, over in ends], [100 * row.comparison[third].rms_log_ratio for row in rows],
                  "o-", color=COLOURS[third], label=f"case 3 {name}")
    left.set(title="Pinned end, all modes", xlabel="rail beyond the outer wheels, m", ylabel="rms log ratio of the twelve levels, %")
    for pads, colour in ((37, "#dc2626"), (39, "#f59e0b"), (43, "#16a34a"), (61, "#2563eb")):
        modes = sorted({round(n * pads * 0.6) for n in np.arange(0.65, 1.65, 0.05)})
        rows = [Row(hunt_choices.with_settings("", *hunt_choices.modal(pads, n))) for n in modes]
        right.plot([n / (0.6 * pads) for n in modes], [100 * row.comparison["case3"].rms_log_ratio for row in rows],
                   ".-", color=colour, label=f"{pads} pads, {0.6 * pads:.1f} m")
    right.set(title="Modal rail, case 3 as published", xlabel="modes per metre of rail")
    for axis in (left, right):
        axis.axhline(100 * GOAL, color="black", linewidth=0.8)
        axis.set_ylim(0, 25)
        axis.legend()
    figure.tight_layout()
    figure.savefig(path)
    plt.close(figure)


def best_rows(combined, least, count):
    """The combinations with the smallest rms among those with at least `least` of six spectra highest where the paper says."""
    found = [(c.rms_log_ratio, row.label, name, c) for row in combined
             for name, c in zip(VARIANTS.values(), row.comparison.values()) if c.teeth >= least]
    rows = [[label, name, percent(c), str(c.teeth), f"{max(abs(p.local_hz - p.paper_hz) for p in c.peaks):.1f}"]
            for _, label, name, c in sorted(found, key=lambda entry: entry[0])[:count]]
    return table(["combination", "case 3", "rms", "highest", "largest distance, Hz"], rows)


def level_rows(base, closest):
    rows = [[a.label, f"{a.frequency_hz:.1f}", f"{a.ratio:.3f}", f"{b.ratio:.3f}", f"{c.ratio:.3f}"] for a, b, c in
            zip(base.comparison["case3"].levels, base.comparison["case3_consistent"].levels, closest.comparison["case3"].levels)]
    return table(["level", "at Hz", "endless, published", "endless, Table 2", "37 pads, 19 modes, published"], rows)


def numbers(base, closest, combined):
    """What the text of the page quotes."""
    def rms(row, third="case3"):
        return 100 * row.comparison[third].rms_log_ratio

    every = [c for row in combined for c in row.comparison.values()]
    long_rails = [row for row in combined if "endless" in row.label or "61 pads" in row.label]
    slope, left = tilt(base.comparison["case3"])
    peaks = closest.comparison["case3"].peaks
    return dict(
        base=rms(base), base_consistent=rms(base, "case3_consistent"), base_teeth=base.comparison["case3"].teeth,
        closest=rms(closest), closest_teeth=closest.comparison["case3"].teeth,
        closest_hz=max(abs(p.local_hz - p.paper_hz) for p in peaks), combined=len(every), reached=sum(c.rms_log_ratio <= GOAL for c in every),
        long_best=100 * min(row.best() for row in long_rails), long_count=2 * len(long_rails), slope=slope, left=100 * left)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs/paper", help="folder for hunt.md and its figures")
    folder = parser.parse_args().out
    folder.mkdir(parents=True, exist_ok=True)

    base = Row(hunt_choices.with_settings("**as shipped: endless rail, wheels over pads, worn tread**"))
    closest = Row(hunt_choices.with_settings("", *hunt_choices.CLOSEST))
    draw_levels(base, closest, folder / "hunt_levels.png")
    draw_rails(base, folder / "hunt_rail.png")
    singles = {group: [Row(choice) for choice in choices] for group, choices in hunt_choices.SINGLE.items()}
    combined = [Row(choice) for choice in hunt_choices.combinations()]
    (folder / "hunt.md").write_text(PAGE.format(
        levels=level_rows(base, closest), singles=single_table(base, singles), best=best_rows(combined, 0, 10),
        best_highest=best_rows(combined, 6, 4), stated=stated_table(), **numbers(base, closest, combined)))


if __name__ == "__main__":
    main()
