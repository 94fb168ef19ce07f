"""Reads every description of a folder with one tool and compares types, access and values.

usage: read_all.py dcf-tools|python-canopen FOLDER

FOLDER holds `expected.json`: a list of files with their node-ID and entries, each [index, sub, type, access, value, whether
that is a formula], where null is not compared. Prints a line of JSON for each file: why it is refused, or its differences.
"""

import json
import logging
import math
import pathlib
import sys
import warnings

logging.disable(logging.CRITICAL)
warnings.simplefilter("ignore")


def with_dcf_tools(path, node_id):
    import dcf

    device = dcf.Device.from_dcf(path, {"NODEID": node_id})

    def read(index, sub, has_value):
        entry = device[index][sub]
        return entry.data_type.index, entry.access_type.name, entry.parse_value() if has_value else None

    return read


def with_python_canopen(path, node_id):
    import canopen

    dictionary = canopen.import_od(path, node_id)

    def read(index, sub, _):
        found = dictionary[index]
        entry = found if isinstance(found, canopen.objectdictionary.ODVariable) else found[sub]
        value = entry.default if entry.value is None else entry.value
        return entry.data_type, entry.access_type, value

    return read


def is_same(expected, found):
    if isinstance(found, bytes):
        found = found.hex()
    elif isinstance(found, float) or isinstance(expected, float):
        return isinstance(found, (int, float)) and math.isclose(expected, found, rel_tol=1e-6)
    return expected == found


def differences(read, entries):
    for index, sub, *expected, _ in entries:
        place = f"{index:04X}sub{sub:X}"
        try:
            found = read(index, sub, expected[2] is not None)
        except Exception as error:  # an entry that is not read is a difference
            yield f"{place}: {type(error).__name__}: {error}"
            continue
        for what, wanted, has in zip(("type", "access", "value"), expected, found):
            if wanted is not None and not is_same(wanted, has):
                yield f"{place}: {what} {has!r} for {wanted!r}"


def main():
    tool, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    open_file = {"dcf-tools": with_dcf_tools, "python-canopen": with_python_canopen}[tool]
    for device in json.loads((folder / "expected.json").read_text()):
        try:
            read = open_file(str(folder / device["file"]), device["node_id"])
        except Exception as error:  # a crash refuses the file too
            answer = {"refused": f"{type(error).__name__}: {error}"}
        else:
            answer = {"differences": list(differences(read, device["entries"]))}
        print(json.dumps({"file": device["file"], **answer}))


main()
