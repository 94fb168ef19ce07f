"""What python-canopen and dcf-tools read in descriptions: a line of JSON for each path on standard input.

Each tool gives the reason why it refuses the file, as text, or its entries: type, access, mapping, limits and value, by index
and sub-index. The node-ID is 5.
"""

import json
import logging
import sys
import warnings

import canopen
import dcf

NODE_ID = 5

logging.disable(logging.CRITICAL)
warnings.simplefilter("ignore")


def plain(value):
    """A value as JSON can have it."""
    return value.hex() if isinstance(value, bytes) else str(value) if isinstance(value, float) else value


def read_python_canopen(path):
    for index, item in canopen.import_od(path, NODE_ID).items():
        # an array makes up the entries that the file lacks
        subs = item.subindices if isinstance(item, (canopen.objectdictionary.ODArray, canopen.objectdictionary.ODRecord)) else {0: item}
        for sub, entry in subs.items():
            value = entry.default if getattr(entry, "value", None) is None else entry.value
            yield index, sub, entry.data_type, entry.access_type, entry.pdo_mappable, (entry.min, entry.max), value


def value_of(value):
    """A value of dcf-tools; strings are Python literals for dcf2dev only."""
    try:
        return value.parse({"NODEID": NODE_ID})
    except (ValueError, SyntaxError):
        return value.value


def read_dcf_tools(path):
    for index, item in dcf.Device.from_dcf(path, {"NODEID": NODE_ID}).items():
        for sub, entry in item.items():
            limits = [value_of(limit) if limit else None for limit in (getattr(entry, "low_limit", None), getattr(entry, "high_limit", None))]
            yield index, sub, entry.data_type.index, entry.access_type.name, entry.pdo_mapping, limits, value_of(entry.value)


def reading(read, path):
    try:
        return {
            f"{index:04X}sub{sub:X}": [data_type, access, mapping, *map(plain, limits), plain(value)]
            for index, sub, data_type, access, mapping, limits, value in read(path)
        }
    except Exception as error:  # a crash refuses the file too
        return f"{type(error).__name__}: {error}"


for path in sys.stdin.read().splitlines():
    tools = {"dcf-tools": read_dcf_tools, "python-canopen": read_python_canopen}
    print(json.dumps({"path": path, **{tool: reading(read, path) for tool, read in tools.items()}}))
