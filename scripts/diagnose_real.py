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

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/railpem"
PAGE = ROOT / "docs/recordings"
TRACK_CASE = ROOT / "cases/ballasted/uic60.toml"
LEAST_SCATTER = 0.10     # of a decay rate: two rails and one day do not show what another day would
HIGHEST_HZ = 2000.0      # above, the rail's section deforms, which no beam does
SECTIONS = {"B3": "Vossloh dampers", "B4": "STRAIL dampers"}


def decay_rates(table, section, damped):
    """Vertical decay rates by third-octave: geometric mean over rails and days, standard error from their scatter."""
    values = {}
    with open(table, newline="") as file:
        for row in csv.DictReader(file):
            if row["sec"] == section and row["dir"] == "v" and (row["damp"] == "TRUE") == damped:
                if row["tdr"] not in ("", "NA") and float(row["tdr"]) > 0.0 and float(row["freq"]) <= HIGHEST_HZ:
                    values.setdefault(float(row["freq"]), []).append(math.log(float(row["tdr"])))
    rates = {}
    for frequency, logs in sorted(values.items()):
        scatter = np.std(logs, ddof=1) / math.sqrt(len(logs)) if len(logs) > 1 else 0.0
        rates[frequency] = (math.exp(np.mean(logs)), max(scatter, LEAST_SCATTER))
    return rates


def write_decay_recording(folder, rates):
    folder.mkdir(parents=True)
    (folder / "recording.toml").write_text('kind = "decay-rate"\ndata = "decay.csv"\n')
    rows = ["centre_hz,decay_rate_db_per_m,standard_error_db_per_m"]
    rows += [f"{f:g},{rate:.6g},{rate * error:.6g}" for f, (rate, error) in rates.items()]
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


def diagnose(case, recording, out):
    subprocess.run([PROGRAM, "diagnose", case, recording, "--out", out], check=True, capture_output=True, text=True)
    return json.loads((out / "diagnosis.json").read_text())


def spectra(out, recording):
    """Columns of <recording>.spectra.csv."""
    with open(out / f"{recording}.spectra.csv", newline="") as file:
        rows = list(csv.DictReader(file))
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
    for axis, (title, columns) in zip(axes, stages):
        f, column = columns["frequency_hz"], lambda name: columns[f"{name}_decay_rate_db_per_m"]
        axis.fill_between(f, column("low"), column("high"), color="0.85", label="measured, 90 %")
        axis.loglog(f, column("measured"), "k.-", label="measured")
        for name, style in (("believed", "C0--"), ("retuned", "C1:"), ("diagnosed", "C3-")):
            axis.loglog(f, column(name), style, label=name)
        axis.set(title=title, xlabel="third-octave, Hz")
        axis.grid(True, which="both", alpha=0.3)
    axes[0].set_ylabel("decay rate, dB/m")
    axes[1].legend(fontsize=8, loc="lower left")  # where no curve runs
    figure.suptitle(f"Niederwangen, section {section}, vertical")
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def summary_row(label, result):
    fit = result["fit"]
    figures = [f"{fit[key]['rms_db']:.2f}" for key in ("before", "retuned", "after", "held_out_retuned", "held_out_after")]
    return f"| {label} | {result['verdict']} | {named(result)} | " + " | ".join(figures) + " |"


def study_section(table, section, folder):
    """The undamped state against the generic case, then the damped one against what that ended in."""
    stages, rows, results = [], [], []
    case = TRACK_CASE
    for damped in (False, True):
        name = f"{section}_{'damped' if damped else 'undamped'}"
        recording = write_decay_recording(folder / name, decay_rates(table, section, damped))
        out = folder / f"{name}_out"
        results.append(diagnose(case, recording, out))
        rows.append(summary_row(f"{section} {'with ' + SECTIONS[section] if damped else 'before'}", results[-1]))
        stages.append(("with dampers" if damped else "before", spectra(out, name)))
        case = out / "diagnosed.toml"
    plot(stages, section, PAGE / f"niederwangen_{section.lower()}.png")
    return rows, results


def page(rows, sections, paper_rows, texts):
    head = "| recording | verdict | named (90 %) | believed, dB | retuned, dB | diagnosed, dB | unseen, retuned, dB | unseen, diagnosed, dB |\n"
    rule = "|---|---|---|---|---|---|---|---|\n"
    figures = "\n\n".join(f"![decay rates of section {s}](niederwangen_{s.lower()}.png)" for s in sections)
    return f"""# Real recordings that are no time series

Written by `scripts/diagnose_real.py`; every verdict is the program's own, wrong or right. Time series:
[two kilometres of axle-box acceleration](two_kilometres.md).

## Track decay rates before and after rail dampers

Source: E. Scossa-Romano and J. Oertli, SBB report on rail dampers at Niederwangen, January 2016, data published as
[SDWirkungNi](https://github.com/mic-haf/SDWirkungNi) (CC0-1.0); measured by Müller-BBM. The measured tables are not in this
repository. Ballasted track, concrete sleepers, hard pads; rail section and spacing are not stated.

`cases/ballasted/uic60.toml`, a generic ballasted track, is believed first and held against the section without dampers. What that
ends in (its `diagnosed.toml`: retuned, with whatever was named) is believed when the same section is diagnosed
with its dampers. Vertical direction, geometric mean of both rails and all days, standard error from their scatter but at least {100 * LEAST_SCATTER:.0f} %,
third-octaves from 100 to {HIGHEST_HZ:.0f} Hz (above, the rail's section deforms, which no beam does). Differences are rms over third-octaves,
10 log10 of the ratio; "unseen" are the bands, one in four, that no fit has seen.

{head}{rule}{chr(10).join(rows)}

{figures}

{texts}

## Levels of Wei et al. (2016)

Each case of the paper quotes four levels: the bogie at two frequencies, wheel and rail at their maxima. They are the result of another
program, not a measurement. As `points` recordings against the case that ships under the same name (case 3: `case3_consistent`):

{head}{rule}{chr(10).join(paper_rows)}

Four values in three third-octaves, of which one is held out, are few: a verdict `consistent` says that no effect is called for beyond the
discrepancy that is fitted, not that the levels agree. [The comparison level by level](../paper/README.md) says how far they are off.
"""


def findings(results):
    """What the program said of each section, in its own words."""
    lines = []
    for section, (before, after) in results.items():
        for label, result in (("before", before), ("with dampers", after)):
            lines.append(f"- **{section} {label}.** {result['statement']}")
            for rival in result["rivals"][:2]:
                lines.append(f"  Rival: {' with '.join(rival['effects'])} ({rival['why_not']}).")
        found = [effect["effect"] for effect in after["omitted"]]
        right = "rail-damper" in found
        lines.append(
            f"  The dampers of {section} were {'named' if right and after['verdict'] == 'explained' else 'not named' if not right else 'found, without being all that is missing'}."
        )
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("path", type=pathlib.Path, help="folder that holds sbb-niederwangen/track_decay_rate.csv")
    arguments = parser.parse_args()
    table = arguments.path / "sbb-niederwangen/track_decay_rate.csv"
    PAGE.mkdir(parents=True, exist_ok=True)
    rows, results, paper_rows = [], {}, []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for section in SECTIONS:
            own_rows, results[section] = study_section(table, section, folder)
            rows += own_rows
        for case in ("case1", "case2", "case3"):
            file = "case3_consistent" if case == "case3" else case
            recording = write_points_recording(folder / f"levels_{case}", case)
            result = diagnose(ROOT / f"cases/wei2016/{file}.toml", recording, folder / f"levels_{case}_out")
            paper_rows.append(summary_row(f"levels of {case}", result))
    (PAGE / "README.md").write_text(page(rows, SECTIONS, paper_rows, findings(results)))
    print(PAGE / "README.md")


if __name__ == "__main__":
    main()
