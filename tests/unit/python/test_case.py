"""Cases: read, built, changed; refused with the words of the command line."""
import numpy as np
import pytest

import railpem
from conftest import WEI


def test_values_are_read_and_changed(case):
    assert case["vehicle.body_mass_kg"] == railpem.Case(WEI / "case3.toml")["vehicle.body_mass_kg"]
    case["vehicle.payload_kg"] = 8000
    case["running.speeds_m_per_s"] = np.array([15.0, 20.0])
    assert case["vehicle.payload_kg"] == 8000.0
    assert case.speeds_m_per_s == [15.0, 20.0]


def test_every_key_has_a_value(case):
    for key in case.keys():
        case[key]


def test_a_copy_is_its_own(case):
    other = case.copy()
    other["vehicle.payload_kg"] = 1.0
    assert case["vehicle.payload_kg"] == 0.0


def test_a_refused_change_changes_nothing(case):
    with pytest.raises(railpem.InputError):
        case.update({"vehicle.payload_kg": 100.0, "vehicle.body_mass_kg": -5.0})
    assert case["vehicle.payload_kg"] == 0.0


def test_dict_and_text_give_the_same_case(case):
    again = railpem.Case.from_dict(case.to_dict())
    assert again.to_toml() == case.to_toml()
    assert np.array_equal(railpem.solve(again).psd, railpem.solve(case).psd)


@pytest.mark.parametrize("option", ["vehicle.body_mass_kg=-5.0", "vehicle.body_mas_kg=5.0", "vehicle.body_mass_kg=[1.0]"])
def test_options_are_refused_as_on_the_command_line(program, tmp_path, option):
    with pytest.raises(railpem.InputError) as refused:
        railpem.Case(WEI / "case3.toml", set=[option])
    assert program("solve", WEI / "case3.toml", "--set", option, "--out", tmp_path / "none", status=2) == f"{refused.value}\n"


def test_a_change_is_refused_as_the_option(program, tmp_path, case):
    with pytest.raises(railpem.InputError) as refused:
        case["vehicle.body_mass_kg"] = -5.0
    command = program("solve", WEI / "case3.toml", "--set", "vehicle.body_mass_kg=-5.0", "--out", tmp_path / "none", status=2)
    assert command == f"{refused.value}\n"


def test_a_missing_file_is_refused_as_on_the_command_line(program, tmp_path):
    with pytest.raises(railpem.InputError) as refused:
        railpem.Case("no/such.toml")
    assert program("solve", "no/such.toml", "--out", tmp_path / "none", status=2) == f"{refused.value}\n"


def test_unknown_keys_name_the_nearest(case):
    with pytest.raises(railpem.InputError, match="did you mean 'vehicle.payload_kg'"):
        case["vehicle.payload"]


def test_a_dict_is_refused_with_its_line(case):
    tables = case.to_dict()
    tables["vehicle"]["body_mas_kg"] = 1.0
    with pytest.raises(railpem.InputError, match=r"(?s)mine:\d+:1: unknown key 'body_mas_kg' in \[vehicle\].*did you mean"):
        railpem.Case.from_dict(tables, name="mine")


def test_values_that_no_case_can_hold():
    with pytest.raises(TypeError, match="is not a value of a case"):
        railpem.Case.from_dict({"title": object()})


def test_texts_survive(case):
    tables = case.to_dict()
    tables["title"] = 'a "title" with \\ and ü'
    assert railpem.Case.from_dict(tables)["title"] == tables["title"]
