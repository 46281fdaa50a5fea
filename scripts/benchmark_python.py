#!/usr/bin/env python3
"""What Python costs: a call of next to no work, and a sweep of 10 000 cases against the same sweep of the command line, turn by turn.

Usage: PYTHONPATH=build/release/python scripts/benchmark_python.py build/release/railpem [--cases 10000] [--threads 2]
"""
import argparse
import pathlib
import subprocess
import tempfile
import time

import railpem

ROOT = pathlib.Path(__file__).resolve().parent.parent
CASE1 = ROOT / "cases/wei2016/case1.toml"
COARSE = "frequency.step_hz=5.0"
KEEP = [("wheel_1", "rms"), ("trackbed", "peak-frequency")]
SWEEP = """case = "{case}"
[[vary]]
key = "vehicle.payload_kg"
from = 0.0
to = 8000.0
count = {cases}
[[keep]]
response = "wheel_1"
quantity = "rms"
[[keep]]
response = "trackbed"
quantity = "peak-frequency"
"""


def seconds_of(function):
    begin = time.perf_counter()
    function()
    return time.perf_counter() - begin


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=10000)
    parser.add_argument("--threads", type=int, default=2)
    arguments = parser.parse_args()

    few = railpem.Case(CASE1, set=["frequency.from_hz=22.0", "frequency.to_hz=23.0", "frequency.step_hz=1.0"])
    call = min(seconds_of(lambda: railpem.solve(few, threads=1)["wheel_1"]) for _ in range(2000))
    print(f"a call of two lines, model and lines included: {1e6 * call:.1f} us")

    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "many.toml"
        file.write_text(SWEEP.format(case=CASE1, cases=arguments.cases))
        case = railpem.Case(CASE1, set=[COARSE])
        line, module, results = [], [], None
        for turn in range(3):
            out = pathlib.Path(folder) / f"out_{turn}"
            command = [arguments.program, "sweep", file, "--out", out, "--threads", arguments.threads, "--set", COARSE, "--format", "csv"]
            line.append(seconds_of(lambda: subprocess.run([str(word) for word in command], check=True, stderr=subprocess.DEVNULL)))

            def from_python():
                nonlocal results
                results = railpem.sweep(case, {"vehicle.payload_kg": {"from": 0.0, "to": 8000.0, "count": arguments.cases}}, KEEP, threads=arguments.threads)

            module.append(seconds_of(from_python))
        own = pathlib.Path(folder) / "own.csv"
        results.write_csv(own)
        same = own.read_bytes() == (pathlib.Path(folder) / "out_0/many.csv").read_bytes()
    print(f"{arguments.cases} cases: command line {min(line):.2f} s, module {min(module):.2f} s, ratio {min(module) / min(line):.3f}, tables {'the same' if same else 'DIFFER'}")


if __name__ == "__main__":
    main()
