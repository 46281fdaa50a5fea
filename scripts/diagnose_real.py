#!/usr/bin/env python3
"""Diagnoses measured track decay rates and the levels of Wei et al. (2016), and writes docs/recordings/.

usage: diagnose_real.py PATH     PATH: folder that holds sbb-niederwangen/track_decay_rate.csv

The measured tables stay where they are: the recordings are written to a temporary folder, only figures and figures' numbers
end up in the documentation.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import paper_values as paper
from page_text import folded, written_by

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/railpem"
PAGE = ROOT / "docs/recordings"
TRACK_CASE = ROOT / "cases/ballasted/uic60.toml"
HIGHEST_HZ = 4000.0      # above, decay rates of the section without dampers scatter by more than a factor of two from day to day
STATES = {"B3": "Vossloh dampers", "B4": "STRAIL dampers", "B5": "never damped"}
BEFORE = "2013"          # dampers were put on in the winter of 2012 to 2013; B5: what counts as earlier


def decay_rates(table):
    """Vertical decay rates {section: {(day, rail): {third-octave: dB/m}}}, days in order."""
    sections = {}
    with open(table, newline="") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            if row["dir"] == "v" and row["tdr"] not in ("", "NA") and float(row["tdr"]) > 0.0 and float(row["freq"]) <= HIGHEST_HZ:
                sections.setdefault(row["sec"], {}).setdefault((row["messdatum"], row["rail"]), {})[float(row["freq"])] = float(row["tdr"])
    return {section: dict(sorted(days.items())) for section, days in sections.items() if section in STATES}


def parted(days):
    """Earlier and later days of a section."""
    return {key: rates for key, rates in days.items() if key[0] < BEFORE}, {key: rates for key, rates in days.items() if key[0] >= BEFORE}


def repeatability(sections):
    """Standard deviation of the logarithm of one day and rail, by third-octave: the scatter within the states of all sections."""
    squares, freedom = {}, {}
    for days in sections.values():
        for state in parted(days):
            for frequency in next(iter(state.values())):
                logs = [math.log(rates[frequency]) for rates in state.values()]
                squares[frequency] = squares.get(frequency, 0.0) + float(np.sum((np.array(logs) - np.mean(logs)) ** 2))
                freedom[frequency] = freedom.get(frequency, 0) + len(logs) - 1
    return {frequency: math.sqrt(squares[frequency] / freedom[frequency]) for frequency in squares}


def mean_of(state):
    """Geometric mean over days and rails."""
    return {frequency: math.exp(np.mean([math.log(rates[frequency]) for rates in state.values()])) for frequency in next(iter(state.values()))}


def write_decay_recording(folder, rates, errors):
    folder.mkdir(parents=True)
    (folder / "recording.toml").write_text('kind = "decay-rate"\ndata = "decay.csv"\n')
    rows = ["centre_hz,decay_rate_db_per_m,standard_error_db_per_m"]
    rows += [f"{f:g},{rate:.6g},{rate * errors[f]:.6g}" for f, rate in sorted(rates.items())]
    (folder / "decay.csv").write_text("\n".join(rows) + "\n")
    return folder


def paper_points(case):
    """(channel, Hz, PSD) of one of the paper's cases: two of the bogie, one of the wheel, one of the rail."""
    points = [("bogie_1", f, levels[case]) for f, levels in paper.BOGIE_LEVELS.items()]
    for channel, peaks in (("axlebox_1", paper.WHEEL_PEAKS), ("rail_1", paper.RAIL_PEAKS)):
        points.append((channel, *peaks[case]))
    return points


def write_points_recording(folder, case):
    folder.mkdir(parents=True)
    text = f'kind = "points"\ndata = "points.csv"\nspeed_m_per_s = {80 / 3.6:.9g}\n'
    for name, location, index in (("bogie_1", "bogie", 1), ("axlebox_1", "wheel", 1), ("rail_1", "rail", 1)):
        text += f'[[channel]]\nname = "{name}"\nlocation = "{location}"\nindex = {index}\n'
    (folder / "recording.toml").write_text(text)
    rows = ["channel,frequency_hz,value"] + [f"{channel},{f:g},{value:.6g}" for channel, f, value in paper_points(case)]
    (folder / "points.csv").write_text("\n".join(rows) + "\n")
    return folder


def diagnose(case, recordings, out):
    subprocess.run([PROGRAM, "diagnose", case, *recordings, "--out", out], check=True, capture_output=True, text=True)
    return json.loads((out / "diagnosis.json").read_text())


def spectra(out, recording):
    """Columns of <recording>.spectra.csv."""
    with open(out / f"{recording}.spectra.csv", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {key: np.array([float(row[key]) for row in rows]) for key in rows[0] if key != "channel"}


def named(result):
    """What was named, with its fitted values."""
    effects = []
    for effect in result["omitted"]:
        values = [
            f"{name} {p['value']:.3g} [{p['low']:.3g}, {p['high']:.3g}]" if "low" in p else f"{name} {p['value']}"
            for name, p in effect["parameters"].items()
        ]
        effects.append(f"`{effect['effect']}` ({', '.join(values)})")
    return "; ".join(effects) if effects else "nothing"


def plot(stages, section, path):
    figure, axes = plt.subplots(1, 2, figsize=(10, 4), sharey=True)
    for axis, (title, recordings, held) in zip(axes, stages):
        for i, columns in enumerate(recordings):
            unseen = i >= len(recordings) - held
            label = ("measured" if held == 0 else "measured, each day and rail") if i == 0 else "measured, unseen" if i == len(recordings) - 1 and held else None
            axis.loglog(columns["frequency_hz"], columns["measured_decay_rate_db_per_m"], color="C2" if unseen else "0.45", marker=".", lw=0.7, label=label)
        for name, style in (("believed", "C0--"), ("retuned", "C1:"), ("diagnosed", "C3-")):
            axis.loglog(columns["frequency_hz"], columns[f"{name}_decay_rate_db_per_m"], style, lw=2, label=name)
        axis.set(title=title, xlabel="third-octave, Hz")
        axis.grid(True, which="both", alpha=0.3)
    axes[0].set_ylabel("decay rate, dB/m")
    axes[1].legend(fontsize=8, loc="lower left")  # where few curves run
    figure.suptitle(f"Niederwangen, section {section}, vertical")
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def summary_row(label, result):
    fit = result["fit"]
    figures = [f"{fit[key]['rms_db']:.2f}" for key in ("before", "retuned", "after", "held_out_retuned", "held_out_after")]
    return f"| {label} | {result['verdict']} | {named(result)} | " + " | ".join(figures) + " |"


def study_section(days, section, errors, folder):
    """The earlier state against the generic case, then the later one against what that ended in."""
    earlier, later = parted(days)
    mean = write_decay_recording(folder / f"{section}_earlier", mean_of(earlier), {f: error / math.sqrt(len(earlier)) for f, error in errors.items()})
    each = [write_decay_recording(folder / f"{section}_{day}_{rail}", rates, errors) for (day, rail), rates in later.items()]
    stages, rows, results = [], [], []
    case = TRACK_CASE
    for name, recordings in (("earlier", [mean]), ("later", each)):
        out = folder / f"{section}_{name}_out"
        results.append(diagnose(case, recordings, out))
        label = f"{section}, 2012" if name == "earlier" else f"{section}, 2013 to 2015: {STATES[section]}"
        rows.append(summary_row(label, results[-1]))
        held = max(1, round(len(recordings) / 4)) if len(recordings) > 1 else 0
        stages.append((label, [spectra(out, recording.name) for recording in recordings], held))
        case = out / "diagnosed.toml"
    plot(stages, section, PAGE / f"niederwangen_{section.lower()}.png")
    return rows, results


def page(rows, sections, paper_rows, texts, errors):
    head = "| recording | verdict | named (90 %) | believed, dB | retuned, dB | diagnosed, dB | unseen, retuned, dB | unseen, diagnosed, dB |\n"
    rule = "|---|---|---|---|---|---|---|---|\n"
    figures = "\n\n".join(f"![decay rates of section {s}](niederwangen_{s.lower()}.png)" for s in sections)
    return folded(f"""{written_by('scripts/diagnose_real.py PATH')}
# Real recordings that are no time series

Every verdict is the program's own, wrong or right. Time series:
[two kilometres of axle-box acceleration](two_kilometres.md).

## Track decay rates before and after rail dampers

Source: E. Scossa-Romano and J. Oertli, SBB report on rail dampers at Niederwangen, January 2016, data published as
[SDWirkungNi](https://github.com/mic-haf/SDWirkungNi) (CC0-1.0); measured by Müller-BBM. The measured tables are not in this
repository. Ballasted track, concrete sleepers, hard pads; rail section and spacing are not stated.

`cases/ballasted/uic60.toml`, a generic ballasted track, is believed first. It is held against each section as it was in 2012, without dampers
(geometric mean of both rails, one third-octave in four held out). What that ends in, its `diagnosed.toml`, is believed when the same section is
diagnosed as it was from 2013 to 2015. It is retuned, has whatever was named, and the ratios of measured to predicted decay rates that it leaves
(`decay_rate_reference`). Every day and rail is a recording. The last quarter of them, another day and the other rail, is seen by no fit.
B5 never had dampers. The error of a day and rail is the scatter within the states of all three sections, third-octave by third-octave: from {100 * min(errors.values()):.0f} to
{100 * max(errors.values()):.0f} %. Third-octaves from 100 to {HIGHEST_HZ:.0f} Hz. Differences are rms over third-octaves, 10 log10 of the ratio.

{head}{rule}{chr(10).join(rows)}

{figures}

{texts}

## Levels of Wei et al. (2016)

Each case of the paper quotes four levels: the bogie at two frequencies, wheel and rail at their maxima. They are the result of another
program, not a measurement. They are `points` recordings against the case that ships under the same name. Those of case 3 are held against the case as
published, whose static analysis bends the rail about the wrong axis, and against `case3_consistent`, which does not:

{head}{rule}{chr(10).join(paper_rows)}

Four values in three third-octaves, of which one is held out, are few. A verdict `consistent` says that no effect is called for beyond the
discrepancy that is fitted, not that the levels agree. [The comparison level by level](../paper/README.md) says how far they are off.
""")


def findings(results):
    """What the program said of each section, in its own words."""
    lines = []
    for section, pair in results.items():
        for label, result in zip(("2012", f"2013 to 2015, {STATES[section]}"), pair):
            lines.append(f"- **{section}, {label}.** {result['statement']}")
            for rival in result["rivals"][:2]:
                lines.append(f"  Rival: {' with '.join(rival['effects'])} ({rival['why_not']}).")
        after = pair[1]
        found = "rail-damper" in [effect["effect"] for effect in after["omitted"]]
        said = "named" if found and after["verdict"] == "explained" else "found, without being all that is missing" if found else "not named"
        lines.append(f"  Dampers were {said}{'' if section != 'B5' else ', and there were none'}.")
    return "\n".join(lines)


def study_paper(folder):
    """The levels of every case against the case itself; those of case 3 both as published and with one bending stiffness throughout."""
    rows = []
    for case, file in (("case1", "case1"), ("case2", "case2"), ("case3", "case3_consistent"), ("case3", "case3")):
        recording = write_points_recording(folder / f"levels_{file}", case)
        result = diagnose(ROOT / f"cases/wei2016/{file}.toml", [recording], folder / f"levels_{file}_out")
        rows.append(summary_row(f"levels of {case} against `{file}`", result))
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("path", type=pathlib.Path, help="folder that holds sbb-niederwangen/track_decay_rate.csv")
    sections = decay_rates(parser.parse_args().path / "sbb-niederwangen/track_decay_rate.csv")
    errors = repeatability(sections)
    PAGE.mkdir(parents=True, exist_ok=True)
    rows, results = [], {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for section in STATES:
            own_rows, results[section] = study_section(sections[section], section, errors, folder)
            rows += own_rows
        paper_rows = study_paper(folder)
    (PAGE / "README.md").write_text(page(rows, STATES, paper_rows, findings(results), errors))
    print(PAGE / "README.md")


if __name__ == "__main__":
    main()
