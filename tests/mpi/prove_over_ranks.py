#!/usr/bin/env python3
"""A proof over 2 processes finds what one process finds, trial by trial; so does one of which a process was killed.

Usage: prove_over_ranks.py RAILPEM MPIRUN [TRIALS]      (minutes; not among the tests of every day)
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

from sweep_over_ranks import ENVIRONMENT, ranks_of

# What a trial takes is no result.
TIMES = ("seconds_simulated", "seconds_diagnosed")


def prove(program, mpirun, folder, trials, processes):
    command = [program, "prove", "--quick", "--seconds", "20", "--trials", trials, "--seed", "5", "--out", folder, "--threads", "1"]
    if processes:
        command = [mpirun, "-n", str(processes), *command]
    return subprocess.Popen([str(word) for word in command], env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def finish(process):
    message = process.communicate()[1]
    assert process.returncode == 0, message


def found_in(folder):
    """Trials without what they took, and the score without it."""
    trials = {path.name: json.loads(path.read_text()) for path in sorted((folder / "trials").glob("*.json"))}
    for trial in trials.values():
        for key in TIMES:
            trial.pop(key, None)
    rows = [line for line in (folder / "trials.csv").read_text().splitlines() if not line.startswith("#")]
    drop = [rows[0].split(",").index(key) for key in TIMES]
    table = [[cell for column, cell in enumerate(row.split(",")) if column not in drop] for row in rows]
    return trials, table


def kill_one(program, mpirun, folder, trials):
    """Starts two processes and kills the second when the first trial is there."""
    launcher = prove(program, mpirun, folder, trials, 2)
    while not list((folder / "trials").glob("*.json")):
        assert launcher.poll() is None, "it was over before a process could be killed"
        time.sleep(0.02)
    os.kill(ranks_of(launcher.pid)[1], signal.SIGKILL)
    launcher.communicate()
    assert launcher.returncode != 0
    kept = {path: path.stat().st_mtime_ns for path in (folder / "trials").glob("*.json")}
    assert 0 < len(kept) < trials
    assert not (folder / "score.json").exists()
    return kept


def main():
    program, mpirun = sys.argv[1:3]
    trials = int(sys.argv[3]) if len(sys.argv) > 3 else 6
    with tempfile.TemporaryDirectory() as temporary:
        top = pathlib.Path(temporary)
        finish(prove(program, mpirun, top / "alone", trials, 0))
        expected = found_in(top / "alone")
        assert len(expected[0]) == trials
        finish(prove(program, mpirun, top / "of_2", trials, 2))
        assert found_in(top / "of_2") == expected
        kept = kill_one(program, mpirun, top / "killed", trials)
        finish(prove(program, mpirun, top / "killed", trials, 2))
        assert found_in(top / "killed") == expected
        assert all(path.stat().st_mtime_ns == when for path, when in kept.items()), "a trial that was there was made again"
        print(f"{trials} trials, the same alone, over 2 processes, and after a kill that left {len(kept)}")


if __name__ == "__main__":
    main()
