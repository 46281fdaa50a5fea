#!/usr/bin/env python3
"""Measures how fast the program is on this machine, and writes docs/speed.csv, docs/speed.png and docs/speed.md.

    scripts/speed_page.py                         everything, half an hour of an idle machine
    scripts/speed_page.py --parts solver scipy    some of it; rows of other parts stay as they are
    scripts/speed_page.py --from docs/speed.csv   page and figure alone, from what was measured before

Needs the release preset with benchmarks, and python3 with NumPy, SciPy and Matplotlib.
"""
import argparse
import csv
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import speed_measure
from page_text import table, written_by

ROOT = speed_measure.ROOT
GOAL_S = 60.0
ON_TWO_THREADS = ("case_3_all_outputs/2",)
WORDS = {
    "core_peak_multiply_add": "independent chains of multiply-add, what the core can do",
    "coupled_line_exact": "one coupled line, every node eliminated: vehicle, contact, exact rail of 81 nodes, 18 responses",
    "rail_receptance_exact": "– of which the rail",
    "vehicle_receptance": "– of which the vehicle",
    "coupled_line_modal_200": "the same with a dense modal rail of 200 modes, error 2e-4",
    "case_1_all_outputs": "case 1 complete: all responses, uniform pads",
    "case_3_all_outputs/1": "case 3 complete: pads that load stiffens, static equilibrium included",
    "case_3_all_outputs/2": "– on two threads, wall time",
    "case_3_every_track_effect/0": "case 3 with every effect of the track, every 8th fastener failed",
    "case_3_every_track_effect/1": "– one fastener in eight failed at random",
    "passing_lines/0": "lines of passing sleepers alone, case 1",
    "passing_lines/2": "– where load stiffens the pads",
    "wheel_transfers_350/1/0": "what the diagnosis evaluates: transfers of 350 lines, case 1, wheels at rest",
    "wheel_transfers_350/1/1": "– wheels in motion",
    "wheel_transfers_350/3/0": "– case 3, wheels at rest",
    "wheel_transfers_350/3/1": "– case 3, wheels in motion",
    "moving_failed_350/1": "– case 1, wheels in motion, every 8th fastener failed",
    "receptance_uic60/0": "receptance of ballasted track, over a pad and mid-bay, with Bloch decay",
    "receptance_uic60/1": "– with the 29 transfer functions of EN 15461",
    "start": "`railpem --version`: what is there before anything is done",
    "solve": "`railpem solve`, case 3, tables included",
    "receptance": "`railpem receptance`, ballasted track, tables and decay rates included",
    "scipy": "banded SciPy, the same track with 241 supports, one receptance alone",
    "nothing": "nothing", "pair-of-the-paper": "both effects of Wei et al. (2016): exponent and preload of the pads",
    "support-compliance": "support that gives way", "suspension-friction": "friction of 1000 N",
    "axle-absorber": "an absorber on the axles, which the catalogue does not have",
    "pad-dead-band": "play of the fastenings, which the catalogue does not have",
    "wandering-subgrade": "ground that changes along the line, which the catalogue does not have"}
SHORT = {"coupled_line_modal_200": "modal rail", "coupled_line_exact": "every node eliminated", "case_1_all_outputs": "case 1", "case_3_all_outputs/1": "case 3",
         "case_3_every_track_effect/0": "case 3, every effect", "wheel_transfers_350/1/0": "transfers, at rest", "wheel_transfers_350/1/1": "transfers, in motion",
         "receptance_uic60/0": "receptance", "scipy": "SciPy, receptance"}


def in_unit(seconds):
    """`4.4 ms`: three digits at most."""
    for factor, unit in ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")):
        if seconds >= factor or unit == "ns":
            return f"{seconds / factor:.3g} {unit}"


def seconds(own):
    """Processor seconds of one thread; the wall's of two, and where nothing else was measured; nothing where neither was."""
    text = own["wall_s"] if own["job"] in ON_TWO_THREADS else own["cpu_s"] or own["wall_s"]
    return float(text) if text else None


def per_line(own):
    return seconds(own) / int(own["lines"]) if own.get("lines") and seconds(own) else None


def cell(value):
    return in_unit(value) if value else ""


def of(rows, group):
    return {own["job"]: own for own in rows if own["group"] == group}


def measured(rows):
    """Where and when, once for all rows of a table."""
    texts = dict.fromkeys(f"{own['measured']}; program {own['program']}" if own["program"] else own["measured"] for own in rows)
    return "*Measured: " + ". ".join(texts) + ".*"


def solver_table(rows):
    known = [own for own in rows if own["group"] in ("solver", "program") and own["job"] != "core_peak_multiply_add"]
    body = [(WORDS.get(own["job"], own["job"]), own["lines"], cell(seconds(own)), cell(per_line(own)), f"{float(own['peak_mb']):.1f} MB" if own["peak_mb"] else "") for own in known]
    return table(("job", "lines", "processor time", "per line", "peak memory"), body) + "\n\n" + measured(known)


def diagnosis_table(rows):
    known = list(of(rows, "diagnose").values())
    body = [(WORDS.get(own["job"], own["job"]), f"{float(own['wall_s']):.0f} s", f"{float(own['cpu_s']):.0f} s" if own["cpu_s"] else "",
             f"{float(own['peak_mb']) / 1000:.2f} GB" if own["peak_mb"] else "", own["said"]) for own in known]
    return table(("hidden", "wall time", "processor", "peak memory", "said"), body) + "\n\n" + measured(known)


def ratio_rows(rows):
    """What counts: ratios of two rows that were measured in one run."""
    solver, program = of(rows, "solver"), of(rows, "program")
    every = solver | program
    pairs = [("coupled_line_modal_200", "coupled_line_exact", per_line, "a dense modal rail over the exact one, a line"),
             ("case_3_all_outputs/1", "case_1_all_outputs", seconds, "case 3 over case 1: what load in the pads costs"),
             ("case_3_every_track_effect/0", "case_1_all_outputs", seconds, "every effect of the track over none"),
             ("wheel_transfers_350/1/1", "wheel_transfers_350/1/0", seconds, "wheels in motion over wheels at rest"),
             ("moving_failed_350/1", "wheel_transfers_350/1/1", seconds, "failed fasteners over sound ones, wheels in motion"),
             ("scipy", "receptance_uic60/0", seconds, "SciPy's one receptance over the solution"),
             ("scipy", "receptance", seconds, "SciPy's one receptance over the whole program")]
    for above, below, what, words in pairs:
        if above in every and below in every and what(every[above]) and what(every[below]):
            ratio = what(every[above]) / what(every[below])
            yield words, f"{ratio:.0f}" if ratio >= 10 else f"{ratio:.1f}"
    one, two = (solver.get(f"case_3_all_outputs/{n}", {}).get("wall_s") for n in (1, 2))
    if one and two:
        yield "one thread over two, case 3, wall time", f"{float(one) / float(two):.2f}"


def limit_text(rows):
    solver = of(rows, "solver")
    rail, core = (float(solver.get(job, {}).get("gflop_per_s") or 0) for job in ("rail_receptance_exact", "core_peak_multiply_add"))
    if not rail or not core:
        return ""
    return f"""## Distance to the limit

A node of the eliminated rail costs 452 floating-point operations a line, counted in the source of `track/rail/rail_receptance.cpp`: 244 to
condense it, 208 for the selected inversion. The benchmark reaches {rail:.3g} Gflop/s, {100 * rail / core:.0f} % of the {core:.3g} Gflop/s that independent
chains of multiply-add reach on the same core in the same run. A complex product is two multiplications and two multiply-adds, and every
node waits for the one before it, a division included.

The uniform track, and lines on which two waves coincide, go through the elimination of every node; other tracks scatter the Bloch waves of
the uniform one at the seats that differ. Cost depends neither on the length of the track nor on frequency.
"""


def page(rows):
    longest = max(float(own["wall_s"]) for own in of(rows, "diagnose").values())
    return f"""{written_by('scripts/speed_page.py')}
# How fast

A case of 2000 lines takes milliseconds, a diagnosis of three minutes of recordings {longest:.0f} s at most below. Absolute times belong to the
machine that is named under each table; ratios within one run are what counts. One machine differs by half from hour to hour.

![time of a line, and of a diagnosis](speed.png)

## Ratios

{table(('', 'times'), ratio_rows(rows))}

## Solving

One core; four or eight frequency lines side by side, as the processor allows (`RAILPEM_MARCH`).

{solver_table(rows)}

## Diagnosing

Three runs of 60 s at 15, 22.2 and 33 m/s, nine channels, against the whole catalogue, `--threads 2`. The goals are {GOAL_S:.0f} s and 1 GB on
two cores. A search ends at an effort that is counted, the same on every machine.

{diagnosis_table(rows)}

{limit_text(rows)}
## How it was measured

```sh
cmake --preset release && cmake --build build/release
scripts/speed_page.py                         # measures, on an idle machine
scripts/speed_page.py --from docs/speed.csv   # page and figure alone
```

[speed.csv](speed.csv) has wall time, processor time and peak memory of everything; `scripts/benchmark_scipy.py` is the comparison with SciPy,
`scripts/benchmark_python.py` that of the Python module with the command line.
"""


def draw(rows, path):
    every = of(rows, "solver") | of(rows, "program")
    lines = [(SHORT[job], per_line(every[job])) for job in SHORT if job in every and per_line(every[job])]
    runs = [(own["job"], float(own["wall_s"]), own["peak_mb"]) for own in of(rows, "diagnose").values()]
    figure, (left, right) = plt.subplots(1, 2, figsize=(11.0, 3.9), layout="constrained")
    left.barh([name for name, _ in lines][::-1], [1e6 * value for _, value in lines][::-1], color="#4393c3")
    for i, (_, value) in enumerate(lines[::-1]):
        left.text(1e6 * value * 1.15, i, in_unit(value), va="center", fontsize=8)
    left.set(xscale="log", xlabel="processor time of a line, µs", title="Solving")
    left.set_xlim(1.0, 1e6 * max(value for _, value in lines) * 8)
    right.barh([name for name, *_ in runs][::-1], [wall for _, wall, _ in runs][::-1], color="#1b7837")
    for i, (_, wall, peak) in enumerate(runs[::-1]):
        right.text(wall + 0.8, i, f"{wall:.0f} s" + (f", {float(peak) / 1000:.2f} GB" if peak else ""), va="center", fontsize=8)
    right.axvline(GOAL_S, color="#b2182b", linewidth=1.0, linestyle="--")
    right.text(GOAL_S - 0.6, len(runs) - 0.5, "goal", ha="right", va="bottom", fontsize=8, color="#b2182b")
    right.set(xlabel="wall time on two threads, s", title="Diagnosing three minutes of nine channels",
              xlim=(0, 1.25 * max(GOAL_S, *(wall for _, wall, _ in runs))))
    right.set_ylim(-0.6, len(runs) - 0.1)
    figure.savefig(path, dpi=130, metadata={"Software": None})


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, speed_measure.COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


GROUPS = {"solver": [("solver", None)], "program": [("program", "start"), ("program", "solve"), ("program", "receptance")], "scipy": [("program", "scipy")], "diagnosis": [("simulate", None), ("diagnose", None)]}


def kept(rows, parts):
    """Rows of earlier runs that the parts measured now do not make again."""
    again = [entry for part in parts for entry in GROUPS[part]]
    return [own for own in rows if not any(own["group"] == group and job in (None, own["job"]) for group, job in again)]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--from", dest="source", type=pathlib.Path, help="draw from this table, measure nothing")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/railpem")
    parser.add_argument("--benchmark", type=pathlib.Path, default=ROOT / "build/release/tests/benchmark_solve")
    parser.add_argument("--parts", nargs="*", choices=list(speed_measure.PARTS), default=list(speed_measure.PARTS))
    parser.add_argument("--hidden", nargs="*", default=speed_measure.HIDDEN, help="what is hidden in the recordings, as in hide_and_seek.py")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--runs", type=int, default=10, help="of a whole program")
    parser.add_argument("--repetitions", type=int, default=3, help="of a benchmark")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "docs", help="folder of speed.csv, speed.png and speed.md")
    return parser.parse_args()


def main():
    options = arguments()
    path = options.out / "speed.csv"
    if options.source:
        rows = read(options.source)
    else:
        before = kept(read(path), options.parts) if path.exists() else []
        groups, jobs = ["solver", "program", "simulate", "diagnose"], list(WORDS)
        place = lambda own: (groups.index(own["group"]), jobs.index(own["job"]) if own["job"] in jobs else len(jobs))
        rows = sorted([*before, *speed_measure.measure(options)], key=place)
        write(path, rows)
    (options.out / "speed.md").write_text(page(rows), encoding="utf-8")
    draw(rows, options.out / "speed.png")


if __name__ == "__main__":
    main()
