"""Sweeps: the table of the command line, bit for bit, and as fast."""
import os
import pathlib
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest

import railpem
from conftest import WEI

VARY = {"track.pads.exponent": [0.0, 0.1, 0.2], "vehicle.payload_kg": np.array([0.0, 5000.0])}
KEEP = [("wheel_1", "rms"), ("wheel_1", "peak-frequency"), ("trackbed", "bands")]



def rows_of(table):
    """The lines of a table without the comment that says where it comes from."""
    return [line for line in table.read_text().splitlines() if not line.startswith("#")]


def test_a_sweep_file_gives_the_table_of_the_command_line(program, tmp_path):
    path = WEI / "pads.sweep.toml"
    program("sweep", path, "--set", "frequency.step_hz=1.0", "--out", tmp_path)
    result = railpem.sweep(path, set={"frequency.step_hz": 1.0})
    result.write_csv(tmp_path / "python.csv")
    written = tmp_path / (path.stem + ".csv")
    assert rows_of(tmp_path / "python.csv") == rows_of(written)
    assert len(result) == 169 and result.parameters.shape == (169, 2) and result.values.shape == (169, len(result.rows))


def test_a_sweep_of_a_case_gives_what_solve_gives(case):
    result = railpem.sweep(case, VARY, KEEP)
    assert result.keys == list(VARY) and result.parameters.shape == (6, 2)
    for parameters, values in zip(result.parameters, result.values):
        response = railpem.solve(case.changed(dict(zip(result.keys, parameters))))
        assert values[0] == pytest.approx(response.summary()["speeds"][0]["acceleration"]["wheel_1"]["rms_m_per_s2"], rel=1e-12)
        step = response.frequency_hz[1] - response.frequency_hz[0]  # a peak is looked for between lines
        assert values[1] == pytest.approx(response.frequency_hz[response["wheel_1"].argmax()], abs=step)


def test_latin_hypercubes(case):
    result = railpem.sweep(case, {"vehicle.payload_kg": (0.0, 8000.0)}, KEEP[:1], design="latin-hypercube", samples=8, seed=3)
    strata = np.sort(np.floor(result.parameters[:, 0] / 1000.0))
    assert np.array_equal(strata, np.arange(8))


def test_what_a_sweep_refuses(case):
    with pytest.raises(railpem.InputError, match="did you mean 'track.pads.exponent'"):
        railpem.sweep(case, {"track.pads.exponents": [0.1]}, KEEP)
    with pytest.raises(railpem.InputError, match="there is no response 'wheel_9'"):
        railpem.sweep(case, VARY, [("wheel_9", "rms")])
    with pytest.raises(railpem.InputError, match="a sweep file says itself"):
        railpem.sweep(WEI / "pads.sweep.toml", VARY, KEEP)


def test_other_threads_run_meanwhile(case):
    """The interpreter is free while the program computes."""
    counted, over = 0, threading.Event()

    def count():
        nonlocal counted
        while not over.is_set():
            counted += 1
            time.sleep(0.001)

    beside = threading.Thread(target=count)
    beside.start()
    begin = time.perf_counter()
    railpem.sweep(case, {"vehicle.payload_kg": np.linspace(0.0, 8000.0, 400)}, KEEP, threads=1)
    seconds = time.perf_counter() - begin
    over.set()
    beside.join()
    assert counted > 100 * seconds


INTERRUPTED = {
    "sweep": "railpem.sweep(case, {'vehicle.payload_kg': np.linspace(0.0, 8000.0, 200000)}, [('wheel_1', 'rms')])",
    "simulate": "railpem.simulate(case, seconds=400.0, seed=1)",
    "solve": "case['frequency.step_hz'] = 1e-4; railpem.solve(case)",
}


@pytest.mark.parametrize("work", INTERRUPTED)
def test_ctrl_c_ends_long_work(work):
    code = f"""
        import sys, numpy as np, railpem
        case = railpem.Case({str(WEI / 'case3.toml')!r})
        print("ready", flush=True)
        try:
            {INTERRUPTED[work]}
        except KeyboardInterrupt:
            sys.exit(77)
    """
    child = subprocess.Popen([sys.executable, "-c", textwrap.dedent(code)], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "ready\n"
    time.sleep(1.0)
    assert child.poll() is None, "it was over before it could be interrupted"
    begin = time.monotonic()
    child.send_signal(signal.SIGINT)
    assert child.wait(timeout=60) == 77
    assert time.monotonic() - begin < 10.0
