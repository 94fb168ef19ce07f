"""`device.toml` of tables of Python."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

#: A table of `device.toml`. Numbers as keys are indexes, sub-indexes, values or bits; `_` is written as `-`.
Table = Any

#: How numbers are written that are keys in these tables.
NUMBERS = {"object": "{:04X}", "sub": "{:X}"}

#: Tables whose keys are those of other tools.
FOREIGN = {"extra", "raw"}


def source_of(profile: int | None, tables: Mapping[str, Any]) -> str:
    """The text of a `device.toml`."""
    lines = ['format = "objdict-device/1"']
    if profile is not None:
        lines.append(f'profile = "{profile}@1"')
    # what is no table comes first, or it would be in one
    for name, value in sorted(tables.items(), key=lambda item: isinstance(item[1], Mapping)):
        if not isinstance(value, Mapping):
            lines.append(f"{_key(name, '')} = {_value(value, '')}")
            continue
        name = _word(name)
        lines.append(f"[{name}]")
        lines += [f"{_key(key, name)} = {_value(item, _word(key))}" for key, item in value.items()]
    return "\n".join(lines) + "\n"


def _word(key: Any) -> str:
    return str(key).replace("_", "-")


def _key(key: Any, table: str) -> str:
    if isinstance(key, int):
        return _text(NUMBERS.get(table, "{}").format(key))
    return _text(str(key) if table in FOREIGN else _word(key))


def _text(text: str) -> str:
    # TOML escapes what JSON does, and DEL
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007F")


def _value(value: Any, table: str) -> str:
    if isinstance(value, Mapping):
        items = (f"{_key(key, table)} = {_value(item, _word(key))}" for key, item in value.items())
        return "{ " + ", ".join(items) + " }"
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, bytes):
        return _text(value.hex())
    if isinstance(value, Sequence):
        return "[" + ", ".join(_value(item, table) for item in value) + "]"
    if isinstance(value, (bool, int)):
        return json.dumps(value)
    return repr(float(value))
