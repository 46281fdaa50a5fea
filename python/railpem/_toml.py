"""Python values as TOML text, which is what the program reads: one reader, one set of messages."""
from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

_BARE = re.compile(r"[A-Za-z0-9_-]+\Z")


def _text(value: str) -> str:
    escaped = "".join(
        "\\" + c if c in '"\\' else f"\\u{ord(c):04x}" if ord(c) < 32 or ord(c) == 127 else c for c in value
    )
    return f'"{escaped}"'


def _key(key: str) -> str:
    return key if _BARE.match(key) else _text(key)


def _is_list(value: Any) -> bool:
    return hasattr(value, "tolist") and getattr(value, "ndim", 0) > 0 or isinstance(value, Sequence) and not isinstance(value, (str, bytes))


def value_text(value: Any) -> str:
    """A value as TOML, numpy scalars and arrays included. Floats read back to the same bits."""
    if hasattr(value, "tolist"):  # numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return "nan" if math.isnan(value) else "inf" if value == math.inf else "-inf" if value == -math.inf else repr(value)
    if isinstance(value, str):
        return _text(value)
    if _is_list(value):
        return "[" + ", ".join(value_text(element) for element in value) + "]"
    raise TypeError(f"{value!r} is not a value of a case; allowed: bool, int, float, str, or a sequence of them")


def _is_table_list(value: Any) -> bool:
    return _is_list(value) and len(value) > 0 and all(isinstance(element, Mapping) for element in value)


def document_text(tables: Mapping[str, Any], path: str = "") -> str:
    """Nested dicts as a TOML document: values first, then tables, then lists of tables."""
    text = ""
    for key, value in tables.items():
        if not isinstance(value, Mapping) and not _is_table_list(value):
            text += f"{_key(key)} = {value_text(value)}\n"
    for key, value in tables.items():
        inner = f"{path}.{_key(key)}" if path else _key(key)
        if isinstance(value, Mapping):
            text += f"\n[{inner}]\n" + document_text(value, inner)
        elif _is_table_list(value):
            for element in value:
                text += f"\n[[{inner}]]\n" + document_text(element, inner)
    return text
