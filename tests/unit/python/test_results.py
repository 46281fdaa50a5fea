"""Results: the numbers of the tables that the program writes, without copies."""
import csv
import json
import time

import numpy as np
import pytest

import railpem
from conftest import WEI


def table(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return {name: np.array([float(row[i]) for row in rows[1:]]) for i, name in enumerate(rows[0])}


def assert_as_written(values, column):
    np.testing.assert_allclose(values, column, rtol=5.1e-9, atol=0)  # nine significant digits in the tables


COARSE = ["--set", "frequency.step_hz=1.0"]


def test_solve(program, tmp_path, case):
    program("solve", WEI / "case3.toml", *COARSE, "--out", tmp_path)
    written = table(tmp_path / "case3.psd.csv")
    response = railpem.solve(case)
    assert_as_written(response.frequency_hz, written["frequency_hz"])
    for name, row in zip(response.columns, response.psd):
        assert_as_written(row, written[name])
    assert np.array_equal(response["wheel_1"], response.psd[response.names.index("wheel_1")])
    written = json.loads((tmp_path / "case3.summary.json").read_text())
    del written["provenance"]
    assert response.summary() == written


def test_pseudo_responses_make_the_spectra(case):
    response = railpem.solve(case)
    np.testing.assert_allclose(np.sum(np.abs(response.pseudo_response) ** 2, axis=0), response.psd, rtol=1e-14)


def test_threads_do_not_change_bits(case):
    assert np.array_equal(railpem.solve(case, threads=1).psd, railpem.solve(case, threads=3).psd)


def test_static(program, tmp_path, case):
    program("static", WEI / "case3.toml", "--out", tmp_path)
    written = table(tmp_path / "case3.static.csv")
    result = railpem.static(case)
    for name in ("position_m", "deflection_m", "static_stiffness_n_per_m", "dynamic_stiffness_n_per_m"):
        np.testing.assert_allclose(getattr(result, name), written[name], rtol=5.1e-9, atol=0)


def test_receptance(program, tmp_path, case):
    program("receptance", WEI / "case3.toml", "--lines", 200, "--out", tmp_path)
    written, decay = table(tmp_path / "case3.receptance.csv"), table(tmp_path / "case3.decay.csv")
    result = railpem.receptance(case, lines=200)
    assert_as_written(result.over_pad_m_per_n.real, written["over_pad_re_m_per_n"])
    assert_as_written(result.mid_bay_m_per_n.imag, written["mid_bay_im_m_per_n"])
    assert_as_written(result.decay_rate_db_per_m, decay["decay_rate_db_per_m"])
    with pytest.raises(railpem.InputError, match="from_hz"):
        railpem.receptance(case, from_hz=10.0, to_hz=5.0)


def test_arrays_look_at_the_result(case):
    response = railpem.solve(case)
    first, second = response.psd, response.psd
    assert first.base is response and not first.flags.owndata and not first.flags.writeable
    assert np.shares_memory(first, second) and np.shares_memory(first, response["wheel_1"])
    row = response["wheel_1"].copy()
    view = response["wheel_1"]
    del response, first, second
    assert np.array_equal(view, row)  # the array keeps the result alive


def test_several_speeds_are_asked_for_one_by_one(case):
    case["running.speeds_m_per_s"] = [15.0, 20.0]
    with pytest.raises(railpem.InputError, match="has 2 speeds"):
        railpem.solve(case)
    assert railpem.solve(case, speed_m_per_s=20.0).speed_m_per_s == 20.0
    with pytest.raises(railpem.InputError, match="speed_m_per_s"):
        railpem.solve(case, speed_m_per_s=-1.0)


def test_unknown_responses(case):
    with pytest.raises(KeyError, match="wheel_5.*wheel_4"):
        railpem.solve(case)["wheel_5"]


def best(function, count=300):
    times = []
    for _ in range(count):
        begin = time.perf_counter()
        function()
        times.append(time.perf_counter() - begin)
    return min(times)


def test_a_call_costs_less_than_50_microseconds(case):
    """What a call of next to no work costs is more than what crossing over costs: two lines of a case without a static equilibrium."""
    case = railpem.Case(WEI / "case1.toml", set=["frequency.from_hz=22.0", "frequency.to_hz=23.0", "frequency.step_hz=1.0"])
    seconds = best(lambda: railpem.solve(case, threads=1)["wheel_1"])
    print(f"a call of two lines: {1e6 * seconds:.1f} us")
    assert seconds < 50e-6 + 100e-6  # the lines and the model, 100 us on the slowest machine seen
