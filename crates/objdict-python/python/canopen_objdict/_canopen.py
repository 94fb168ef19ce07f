"""Devices as object dictionaries of python-canopen, and back."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import canopen.objectdictionary as objectdictionary
from canopen.objectdictionary import datatypes

from ._native import Entry, Formula

if TYPE_CHECKING:
    from ._device import Device, Object

#: Data types that python-canopen encodes itself.
ENCODED = (*datatypes.NUMBER_TYPES, datatypes.BOOLEAN)

LAST_STATIC = datatypes.UNSIGNED64

#: The words of `device.toml` for data types.
WORDS = {
    datatypes.BOOLEAN: "bool",
    datatypes.REAL32: "f32",
    datatypes.REAL64: "f64",
    datatypes.VISIBLE_STRING: "string",
    datatypes.OCTET_STRING: "bytes",
    datatypes.UNICODE_STRING: "unicode",
    datatypes.TIME_OF_DAY: "time",
    datatypes.TIME_DIFFERENCE: "time-difference",
    datatypes.DOMAIN: "domain",
    **{kind: f"i{objectdictionary.ODVariable.STRUCT_TYPES[kind].size * 8}" for kind in datatypes.SIGNED_TYPES},
    **{kind: f"u{objectdictionary.ODVariable.STRUCT_TYPES[kind].size * 8}" for kind in datatypes.UNSIGNED_TYPES},
}

#: Attributes of the device information, by their keys in the JSON of a device.
INFORMATION = {
    "vendor_name": "vendor_name",
    "vendor_number": "vendor_number",
    "product_name": "product_name",
    "product_number": "product_number",
    "revision_number": "revision_number",
    "order_code": "order_code",
    "simple_boot_up_master": "simple_boot_up_master",
    "simple_boot_up_slave": "simple_boot_up_slave",
    "granularity": "granularity",
    "dynamic_channels_supported": "dynamic_channels_supported",
    "group_messaging": "group_messaging",
    "rpdo_count": "nr_of_RXPDO",
    "tpdo_count": "nr_of_TXPDO",
    "lss_supported": "LSS_supported",
}


def dictionary_of(device: Device, node_id: int | None) -> Any:
    """The object dictionary of a device, for a node."""
    od = objectdictionary.ObjectDictionary()
    facts = device.facts
    commissioning = facts.get("commissioning", {})
    od.node_id = node_id
    if "baud_rate" in commissioning:
        od.bitrate = commissioning["baud_rate"] * 1000
    od.comments = "\n".join(facts.get("comments") or ())
    information = facts.get("device_info", {})
    od.device_information.allowed_baudrates = {rate * 1000 for rate in device.bit_rates}
    for key, attribute in INFORMATION.items():
        if key in information:
            setattr(od.device_information, attribute, information[key])
    for name, is_used in facts.get("dummy_usage", {}).get("types", {}).items():
        _add_dummy(od, name, is_used)
    for item in device.values():
        # definitions of data types are no objects that a node serves
        if item.object_type != "DEFTYPE":
            od.add_object(_object(item, node_id))
    _add_mappings(od)
    return od


def _add_mappings(od: Any) -> None:
    """The mapping parameters that a description lacks, without entries: python-canopen's nodes look for each."""
    for index in [index for index in od if 0x1400 <= index < 0x1600 or 0x1800 <= index < 0x1A00]:
        mapping = index + 0x200
        if mapping not in od:
            od.add_object(objectdictionary.ODRecord(f"Mapping of {index:04X}h", mapping))


def _add_dummy(od: Any, name: str, is_used: bool) -> None:
    """The dummy entries of RPDOs, under the names that python-canopen's reader gives them."""
    data_type = getattr(datatypes, name, None)
    if is_used and data_type is not None:
        dummy = objectdictionary.ODVariable(f"Dummy{data_type:04d}", data_type, 0)
        dummy.data_type = data_type
        dummy.access_type = "const"
        od.add_object(dummy)


def _object(item: Object, node_id: int | None) -> Any:
    if item.is_single:
        entry = item[0] if 0 in item else None
        return _variable(item.index, item.name, entry, node_id)
    is_array = item.object_type == "ARRAY"
    kind = objectdictionary.ODArray if is_array else objectdictionary.ODRecord
    whole = kind(item.name, item.index)
    whole.description = item.description or ""
    for entry in item.values():
        whole.add_member(_variable(item.index, entry.name, entry, node_id))
    return whole


def _variable(index: int, name: str, entry: Entry | None, node_id: int | None) -> Any:
    variable = objectdictionary.ODVariable(name, index, 0 if entry is None else entry.sub)
    variable.data_type = datatypes.DOMAIN
    if entry is None:
        return variable
    data_type = entry.data_type_index
    # a type that python-canopen does not know is bytes
    if data_type is not None and data_type <= LAST_STATIC:
        variable.data_type = data_type
    variable.access_type = entry.access or "rw"
    variable.pdo_mappable = entry.pdo_mapping != "no"
    variable.unit = entry.unit or ""
    variable.factor = entry.factor if entry.offset == 0 else 1
    variable.description = entry.description or ""
    variable.value_descriptions = entry.value_names
    variable.bit_definitions = entry.bit_names
    variable.min = _number(entry.low_limit, node_id)
    variable.max = _number(entry.high_limit, node_id)
    variable.relative = entry.formula is not None
    variable.default = _value(entry, entry.default, node_id)
    if entry.formula is not None:
        # what an export to EDS writes
        variable.default_raw = repr(entry.formula)
    if entry.is_configured:
        variable.value = _value(entry, entry.value, node_id)
    return variable


def _number(value: Any, node_id: int | None) -> Any:
    resolved = _resolved(value, node_id)
    return resolved if isinstance(resolved, (int, float)) else None


def _resolved(value: Any, node_id: int | None) -> Any:
    if isinstance(value, Formula):
        return None if node_id is None else value.on_node(node_id)
    return value


def _value(entry: Entry, value: Any, node_id: int | None) -> Any:
    """A value as python-canopen encodes it; else the bytes of an SDO transfer."""
    value = _resolved(value, node_id)
    data_type = entry.data_type_index
    if value is None or data_type in ENCODED or data_type == datatypes.UNICODE_STRING:
        return value
    if data_type == datatypes.VISIBLE_STRING and value.isascii():
        return value
    if isinstance(value, bytes):
        return value
    try:
        return entry.encode(value)
    except (TypeError, ValueError):
        # the text of a type that is not static
        return None


def tables_of(od: Any) -> dict[str, Any]:
    """The tables of `device.toml` that describe an object dictionary."""
    information = od.device_information
    device = {key.replace("_", "-"): getattr(information, attribute) for key, attribute in INFORMATION.items()}
    device = {key: value for key, value in device.items() if value is not None}
    rates = sorted(rate // 1000 for rate in information.allowed_baudrates)
    tables: dict[str, Any] = {"device": {**device, "bit-rates": rates}}
    if od.comments:
        tables = {"comments": od.comments.splitlines(), **tables}
    if od.node_id is not None:
        tables["node"] = {"node-id": od.node_id, **({"baud-rate": od.bitrate // 1000} if od.bitrate else {})}
    tables["object"] = {index: _table(od[index]) for index in od if index >= 0x1000}
    return tables


def _table(item: Any) -> dict[str, Any]:
    if isinstance(item, objectdictionary.ODVariable):
        return _table_of_variable(item)
    kind = "array" if isinstance(item, objectdictionary.ODArray) else "record"
    subs = {sub: _table_of_variable(item[sub]) for sub in item}
    table: dict[str, Any] = {"name": item.name, "type": kind, "sub": subs}
    return {**table, "description": item.description} if item.description else table


def _table_of_variable(variable: Any) -> dict[str, Any]:
    table = {
        "name": variable.name,
        "type": WORDS.get(variable.data_type, "domain"),
        "access": variable.access_type,
        "map": "optional" if variable.pdo_mappable else "no",
        "default": getattr(variable, "default_raw", None) if variable.relative else _stated(variable, variable.default),
        "value": _stated(variable, variable.value),
        "min": variable.min,
        "max": variable.max,
        "unit": variable.unit or None,
        "factor": None if variable.factor == 1 else variable.factor,
        "description": variable.description or None,
        "enum": variable.value_descriptions or None,
        "bits": {_range(bits): name for name, bits in variable.bit_definitions.items()} or None,
    }
    return {key: value for key, value in table.items() if value is not None}


def _stated(variable: Any, value: Any) -> Any:
    """A value as `device.toml` writes it; times have no form in python-canopen."""
    is_time = variable.data_type in (datatypes.TIME_OF_DAY, datatypes.TIME_DIFFERENCE)
    return None if is_time and not isinstance(value, str) else value


def _range(bits: list[int]) -> str:
    return str(bits[0]) if len(bits) == 1 else f"{min(bits)}-{max(bits)}"
