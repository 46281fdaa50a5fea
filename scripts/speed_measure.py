"""Measures for docs/speed.csv: benchmarks of the solver, whole programs, diagnoses of marched recordings. Times of one program on one machine."""
import argparse
import datetime
import json
import os
import pathlib
import platform
import re
import statistics
import subprocess
import sys
import tempfile
import time

import hide_and_seek

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = ["group", "job", "wall_s", "cpu_s", "peak_mb", "lines", "gflop_per_s", "said", "program", "measured"]
# Rows of tests/benchmark/solve.cpp that the page shows.
BENCHMARKS = ["core_peak_multiply_add", "coupled_line_exact", "rail_receptance_exact", "vehicle_receptance", "coupled_line_modal_200", "case_1_all_outputs",
              "case_3_all_outputs/1", "case_3_all_outputs/2", "case_3_every_track_effect/0", "case_3_every_track_effect/1", "passing_lines/0", "passing_lines/2",
              "wheel_transfers_350/1/0", "wheel_transfers_350/1/1", "wheel_transfers_350/3/0", "wheel_transfers_350/3/1", "moving_failed_350/1",
              "receptance_uic60/0", "receptance_uic60/1"]
# Nothing, both effects of Wei et al. 2016, one whose law is exact but slow, one that only the simulator has: such a search ends without a name.
HIDDEN = ["nothing", "pair-of-the-paper", "support-compliance", "axle-absorber"]
SEED = 9901
SECONDS_OF = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def machine():
    """Processor as the system calls it, and how many threads it has."""
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        name = next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        name = platform.processor() or platform.machine()
    return f"{name}, {os.cpu_count()} threads, {datetime.date.today()}"


def row(group, job, measured_by, **values):
    return dict.fromkeys(COLUMNS, "") | {"group": group, "job": job, **measured_by} | {key: f"{value:.4g}" if isinstance(value, float) else value for key, value in values.items()}


# Run by a small Python: Linux counts the memory of whoever starts a program as that program's.
STARTER = """import json, os, sys, time
begin = time.monotonic()
child = os.spawnvp(os.P_NOWAIT, sys.argv[1], sys.argv[1:])
_, status, used = os.wait4(child, 0)
print(json.dumps([os.waitstatus_to_exitcode(status), time.monotonic() - begin, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024.0]), file=sys.stderr)
"""


def timed(command):
    """Wall and processor seconds and peak resident memory in MB of a program."""
    words = [str(word) for word in command]
    run = subprocess.run([sys.executable, "-I", "-S", "-c", STARTER, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=True)
    said, _, last = run.stderr.rstrip().rpartition("\n")
    ended, wall, cpu, peak = json.loads(last)
    if ended != 0:
        raise RuntimeError(f"{' '.join(words)} ended with {ended}: {said[:300]}")
    return wall, cpu, peak


def benchmark_rows(options, measured_by):
    """Medians of three repetitions."""
    pattern = "^(" + "|".join(BENCHMARKS) + ")(/iterations:[0-9]+)?(/real_time)?$"
    command = [options.benchmark, f"--benchmark_filter={pattern}", "--benchmark_format=json", f"--benchmark_repetitions={options.repetitions}"]
    found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["benchmarks"]
    for job in BENCHMARKS:
        runs = [own for own in found if own["run_type"] == "iteration" and re.sub(r"(/iterations:[0-9]+)?(/real_time)?$", "", own["run_name"]) == job]
        if not runs:
            print(f"{job}: not among the benchmarks", file=sys.stderr)
            continue
        middle = lambda key: statistics.median(own[key] for own in runs)
        unit = SECONDS_OF[runs[0]["time_unit"]]
        clock = "real_time" if any("/real_time" in own["run_name"] for own in runs) else "cpu_time"
        lines = round(middle("items_per_second") * middle(clock) * unit) if "items_per_second" in runs[0] else ""
        flops = middle("flop_per_s") / 1e9 if "flop_per_s" in runs[0] else ""
        yield row("solver", job, measured_by, wall_s=middle("real_time") * unit, cpu_s=middle("cpu_time") * unit, lines=lines, gflop_per_s=flops)


def program_rows(options, measured_by):
    """Least wall time of some runs, with its processor time, and the most memory of any."""
    cases = ROOT / "cases"
    jobs = {"start": (["--version"], ""), "solve": (["solve", cases / "wei2016/case3.toml"], 1998),
            "receptance": (["receptance", cases / "ballasted/uic60.toml", "--from", 20, "--to", 3000, "--lines", 1500], 1500)}
    for job, (words, lines) in jobs.items():
        with tempfile.TemporaryDirectory() as folder:
            command = [options.program, *words] + (["--out", folder, "--threads", 1] if lines else [])
            runs = [timed(command) for _ in range(options.runs)]
        wall, cpu, _ = min(runs)
        yield row("program", job, measured_by, wall_s=wall, cpu_s=cpu, peak_mb=max(run[2] for run in runs), lines=lines)


def scipy_rows(options, measured_by):
    """The receptance of the same track by banded SciPy, in the same minute."""
    command = [sys.executable, ROOT / "scripts/benchmark_scipy.py", "--program", options.program]
    found = json.loads(subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout)
    yield row("program", "scipy", measured_by, wall_s=found["scipy_wall_s"], cpu_s=found["scipy_cpu_s"], lines=found["lines"],
              said=f"median difference {found['mid_bay_median_difference']:.0e}")


def diagnosis_rows(options, measured_by):
    """Three runs of 60 s and nine channels, marched and diagnosed, one after the other."""
    marching = argparse.Namespace(railpem=str(options.program), speeds=["15", "22.2222", "33"], numbers="even")
    for hidden in options.hidden:
        with tempfile.TemporaryDirectory() as folder:
            begin, used = time.monotonic(), hide_and_seek.cpu_s()
            runs, _, _ = hide_and_seek.march(marching, hidden, SEED, folder)
            yield row("simulate", hidden, measured_by, wall_s=time.monotonic() - begin, cpu_s=hide_and_seek.cpu_s() - used)
            out = pathlib.Path(folder) / "out"
            wall, cpu, peak = timed([options.program, "diagnose", hide_and_seek.CASE, *runs, "--threads", options.threads, "--out", out])
            found = json.loads((out / "diagnosis.json").read_text(encoding="utf-8"))
        names = " + ".join(own["effect"] for own in found["omitted"])
        yield row("diagnose", hidden, measured_by, wall_s=wall, cpu_s=cpu, peak_mb=peak, said=found["verdict"] + (f": {names}" if names else ""))


PARTS = {"solver": benchmark_rows, "program": program_rows, "scipy": scipy_rows, "diagnosis": diagnosis_rows}


def measure(options):
    measured_by = {"program": hide_and_seek.commit(), "measured": machine()}
    for part in options.parts:
        for found in PARTS[part](options, measured_by):
            print(found["group"], found["job"], found["wall_s"], "s", found["peak_mb"], flush=True)
            yield found
