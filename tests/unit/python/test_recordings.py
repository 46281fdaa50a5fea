"""Recordings: simulated, inspected and diagnosed as on the command line."""
import json

import numpy as np
import pytest

import railpem
from conftest import WEI


@pytest.fixture(scope="module")
def believed():
    return railpem.Case(WEI / "case1.toml")


@pytest.fixture(scope="module")
def recording(believed):
    return railpem.simulate(believed, seconds=20.0, seed=5, hide=[("sensor-gain", {"channel": "bogie_1", "gain": -1.0})], noise=0.02)


def test_simulate_gives_the_bits_of_the_command_line(program, tmp_path, recording):
    program("simulate", WEI / "case1.toml", "--hide", "sensor-gain:channel=bogie_1,gain=-1.0", "--noise", 0.02, "--seconds", 20, "--seed", 5,
            "--out", tmp_path / "program", "--truth", tmp_path / "truth.json")
    recording.save(tmp_path / "python")
    for name in ("recording.toml", "recording.csv"):
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "program" / name).read_bytes()
    truth = json.loads((tmp_path / "truth.json").read_text())
    del truth["provenance"]
    assert {**recording.truth(), "case": ""} == {**truth, "case": ""}


def test_channels_look_at_the_recording(recording):
    channel = recording["axlebox_1"]
    assert channel.base is recording and len(channel) == len(recording) == 20000
    with pytest.raises(KeyError, match="axlebox_4"):
        recording["axlebox_5"]


@pytest.mark.parametrize("arguments, option", [({"seconds": 1e9, "seed": 1}, "--seconds"), ({"seconds": 20.0, "seed": -1}, "--seed"),
                                               ({"seconds": 20.0, "seed": 1, "hide": ["no-effect"]}, "no-effect")])
def test_what_simulate_refuses(believed, arguments, option):
    with pytest.raises(railpem.InputError, match=option):
        railpem.simulate(believed, **arguments)


def test_inspect(program, tmp_path, believed, recording):
    folder = recording.save(tmp_path / "recording")
    report = railpem.inspect(folder, case=believed)
    wrong = any(fault["severity"] == "error" for fault in report.as_dict()["faults"])
    assert wrong  # a gain is hidden in it: the program ends with 3
    assert report.text() == program("inspect", folder, "--case", WEI / "case1.toml", status=3)
    assert report.as_dict() == json.loads(program("inspect", folder, "--case", WEI / "case1.toml", "--json", status=3))
    assert report["axlebox_1"].shape == report.frequency_hz.shape and report.duration_s == 20.0
    assert railpem.inspect(folder).verdict


def test_diagnose(tmp_path, believed, recording):
    result = railpem.diagnose(believed, recording.save(tmp_path / "recording"), window_s=2.0, most_effects=1, without=["rail-joints"])
    assert any(line.startswith("rail-joints: it was to be left out") for line in result.as_dict()["not_tested"])
    assert result.verdict == "recording-fault", result.statement
    assert [effect["effect"] for effect in result.as_dict()["omitted"]] == ["sensor-gain"]
    assert {channel["channel"] for channel in result.channels} == set(recording.names)
    assert result.channels[0]["measured"].base is result
    written = {path.name for path in result.save(tmp_path / "diagnosis").iterdir()}
    assert {"diagnosis.json", "report.html", "diagnosed.toml"} <= written
    railpem.solve(railpem.Case(tmp_path / "diagnosis/diagnosed.toml"))


def test_what_diagnose_refuses(tmp_path, believed):
    with pytest.raises(railpem.InputError, match="none"):
        railpem.diagnose(believed, [])
    with pytest.raises(railpem.InputError, match="no/such"):
        railpem.diagnose(believed, "no/such")


def test_a_folder_that_cannot_be_written(recording, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(railpem.InputError, match="cannot be written"):
        recording.save(tmp_path / "file")
