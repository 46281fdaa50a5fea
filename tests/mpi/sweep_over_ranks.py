#!/usr/bin/env python3
"""A sweep over 1, 2 and 4 processes gives the table of one process, byte for byte; so does one of which a process was killed.

Usage: sweep_over_ranks.py RAILPEM MPIRUN [CASES]
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Open MPI refuses root and more processes than cores unless it is told twice.
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                   OMPI_MCA_btl_vader_single_copy_mechanism="none", OMPI_MCA_hwloc_base_binding_policy="none", OMP_WAIT_POLICY="passive")
SWEEP = """case = "{case}"
design = "latin-hypercube"
samples = {cases}
[[vary]]
key = "track.pads.static_stiffness_n_per_m"
from = 16e6
to = 40e6
[[vary]]
key = "vehicle.payload_kg"
from = 0.0
to = 12000.0
[[keep]]
response = "wheel_1"
[[keep]]
response = "trackbed"
quantity = "peak-frequency"
"""


def rows_of(table):
    """The lines of a table without the comment that says where it comes from."""
    return [line for line in table.read_text().splitlines() if not line.startswith("#")]



def sweep(program, mpirun, folder, file, processes, **popen):
    command = [program, "sweep", file, "--out", folder, "--threads", "1", "--set", "frequency.step_hz=5.0", "--format", "csv"]
    if processes:
        command = [mpirun, "-n", str(processes), *command]
    return subprocess.Popen([str(word) for word in command], env=ENVIRONMENT, **popen)


def whole(*arguments):
    begin = time.monotonic()
    assert sweep(*arguments).wait() == 0
    return time.monotonic() - begin


def ranks_of(launcher):
    """Processes that the launcher has started, children of children included."""
    found, families = [], {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rsplit(")", 1)
        except OSError:
            continue
        families.setdefault(int(fields[1].split()[1]), []).append((int(stat.parent.name), fields[0].split("(", 1)[1]))
    level = [launcher]
    while level:
        children = [child for parent in level for child in families.get(parent, [])]
        found += [pid for pid, name in children if name == "railpem"]
        level = [pid for pid, _ in children]
    return found


def kill_one(program, mpirun, folder, file, after):
    """Starts three processes and kills one of them when `after` bytes of results are there."""
    launcher = sweep(program, mpirun, folder, file, 3, stderr=subprocess.PIPE, text=True)
    part = folder / "many.unfinished.1"
    while not part.exists() or part.stat().st_size < after:
        assert launcher.poll() is None, "it was over before a process could be killed"
        time.sleep(0.005)
    os.kill(ranks_of(launcher.pid)[1], signal.SIGKILL)
    launcher.communicate()
    assert launcher.returncode != 0
    assert not (folder / "many.csv").exists()


def main():
    program, mpirun = sys.argv[1:3]
    cases = int(sys.argv[3]) if len(sys.argv) > 3 else 400
    with tempfile.TemporaryDirectory() as temporary:
        top = pathlib.Path(temporary)
        file = top / "many.toml"
        file.write_text(SWEEP.format(case=ROOT / "cases/wei2016/case1.toml", cases=cases))
        print(f"alone: {whole(program, mpirun, top / 'alone', file, 0):.1f} s")
        expected = rows_of(top / "alone/many.csv")
        assert len(expected) == 2 * cases + 1
        for processes in (1, 2, 4):
            folder = top / f"of_{processes}"
            print(f"{processes} processes: {whole(program, mpirun, folder, file, processes):.1f} s")
            assert rows_of(folder / "many.csv") == expected
            assert sorted(path.name for path in folder.iterdir()) == ["many.csv", "many.warnings.csv"]
        for restart in (2, 0):  # with other processes, and without any
            folder = top / f"killed_{restart}"
            kill_one(program, mpirun, folder, file, after=24 * cases // 8)
            seconds = whole(program, mpirun, folder, file, restart)
            print(f"killed, restarted with {restart or 'no'} processes: {seconds:.1f} s")
            assert rows_of(folder / "many.csv") == expected
            assert sorted(path.name for path in folder.iterdir()) == ["many.csv", "many.warnings.csv"]
        refused = sweep(program, mpirun, top / "none", top / "no_such.toml", 2, stderr=subprocess.PIPE, text=True)
        message = refused.communicate()[1]
        assert refused.returncode == 2 and message.count("no_such.toml: cannot be read") == 1, message
        assert not (top / "none").exists()


if __name__ == "__main__":
    main()
