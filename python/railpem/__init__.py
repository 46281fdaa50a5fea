"""Vehicle-track dynamics: the verbs of `railpem` as functions, their results as numpy arrays.

    import railpem
    case = railpem.Case("cases/wei2016/case3.toml")
    case["vehicle.payload_kg"] = 8000.0
    response = railpem.solve(case)
    response.frequency_hz, response["wheel_1"]

Units, signs and names are those of the program (CONVENTIONS.md). What the command line refuses with exit status 2 raises
InputError with the same text. Arrays look at the memory of the result they belong to and keep it alive; they cannot be written.
"""
from __future__ import annotations

import json as _json
import os as _os
import tomllib as _tomllib
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Union

from . import _core
from ._core import (Case, Diagnosis, InputError, Inspection, OutputError, Receptance, Recording, Response, StaticEquilibrium, Sweep,
                    __version__, hidden_effects, inspect, receptance, solve, static)
from ._toml import document_text as _document_text
from ._toml import value_text as _value_text

__all__ = ["Case", "Diagnosis", "InputError", "Inspection", "OutputError", "Receptance", "Recording", "Response", "StaticEquilibrium", "Sweep",
           "diagnose", "hidden_effects", "inspect", "receptance", "simulate", "solve", "static", "sweep", "__version__"]

_Path = Union[str, _os.PathLike]


def _from_dict(tables: Mapping[str, Any], name: str = "case") -> Case:
    """A case from nested dicts with the keys of a case file; lists of dicts for its lists of tables."""
    return Case.from_toml(_document_text(tables), name)


def _options(changes: Mapping[str, Any]) -> list[str]:
    return [f"{key}={_value_text(value)}" for key, value in changes.items()]


def _changed(self: Case, changes: Mapping[str, Any]) -> Case:
    """A new case in which dotted keys have other values, checked like the file: all of them or none."""
    return self._changed(_options(changes))


def _update(self: Case, changes: Mapping[str, Any]) -> None:
    """Changes the case: all values or, when one is refused, none."""
    self._become(self._changed(_options(changes)))


def _set(self: Case, key: str, value: Any) -> None:
    _update(self, {key: value})


def _to_dict(self: Case) -> dict[str, Any]:
    """The case as nested dicts, which from_dict() takes."""
    return _tomllib.loads(self.to_toml())


# Words of Python for what C++ says in texts.
Case.from_dict = staticmethod(_from_dict)
Case.changed = _changed
Case.update = _update
Case.__getitem__ = lambda self, key: self._value(key)
Case.__setitem__ = _set
Case.to_dict = _to_dict
Response.summary = lambda self: _json.loads(self._summary())
Recording.truth = lambda self: _json.loads(self._truth())
Inspection.as_dict = lambda self: _json.loads(self._json())
Diagnosis.as_dict = lambda self: _json.loads(self._json())


def sweep(source: Union[Case, _Path], vary: Mapping[str, Any] | None = None, keep: Iterable[tuple[str, str]] | None = None, *, design: str = "grid",
          samples: int = 0, seed: int = 1, set: Mapping[str, Any] | None = None, threads: int = 0) -> Sweep:
    """Runs many cases and keeps a few quantities of each.

    Either a sweep file, with `set` changing its case, or a case with

    vary: dotted key -> values (designs "grid", "list"), or (from, to) (design "latin-hypercube"), or a dict of the keys of [[vary]];
    keep: pairs of response and quantity, ("wheel_1", "rms") for instance.
    """
    if not isinstance(source, Case):
        if vary is not None or keep is not None:
            raise InputError("sweep: a sweep file says itself what varies and what is kept\nallowed: a Case with vary and keep, or a file alone")
        return _core._sweep_file(source, _options(set or {}), threads)
    tables = []
    for key, values in (vary or {}).items():
        if isinstance(values, Mapping):
            tables.append({"key": key, **values})
        elif design == "latin-hypercube":
            low, high = values
            tables.append({"key": key, "from": low, "to": high})
        else:
            tables.append({"key": key, "values": [float(value) for value in values]})
    text = _document_text({"case": source.name, "design": design, "samples": samples, "seed": seed, "vary": tables,
                           "keep": [{"response": response, "quantity": quantity} for response, quantity in keep or []]})
    return _core._sweep_text(source.changed(set) if set else source, text, threads)


def _hide_option(effect: Union[str, tuple[str, Mapping[str, Any]]]) -> str:
    if isinstance(effect, str):
        return effect
    name, parameters = effect
    return name + ":" + ",".join(f"{key}={value if isinstance(value, str) else _value_text(value)}" for key, value in parameters.items())


def simulate(case: Case, seconds: float, seed: int, *, hide: Sequence[Union[str, tuple[str, Mapping[str, Any]]]] = (), speed_m_per_s: float | None = None,
             rate_hz: float = 1000.0, noise: float = 0.0, speed_fluctuation: float = 0.0, standing: bool = False, force: bool = False,
             profile: _Path | None = None, profile_seed: int | None = None, profile_length_m: float = 0.0) -> Recording:
    """A recording marched in time, with effects concealed in it: names, or (name, {parameter: value})."""
    return _core._simulate(case, seconds, seed, [_hide_option(effect) for effect in hide], speed_m_per_s, rate_hz, noise, speed_fluctuation, standing,
                           force, _os.fspath(profile) if profile is not None else "", profile_seed, profile_length_m)


def diagnose(case: Case, recordings: Union[_Path, Sequence[_Path]], *, window_s: float = 4.0, held_out: float = 0.25, most_effects: int = 3,
             without: Sequence[str] = (), threads: int = 0) -> Diagnosis:
    """What the case left out, told from recordings: folders or descriptions, several speeds or loads together; `without`: effects that the
    catalogue shall not have."""
    paths = [recordings] if isinstance(recordings, (str, _os.PathLike)) else list(recordings)
    return _core._diagnose(case, paths, window_s, held_out, most_effects, list(without), threads)
