"""Reads descriptions with python-canopen and uploads every entry over a virtual bus.

usage: read_back.py FOLDER

FOLDER holds the descriptions and `expected.json`: a list of files with their node-ID and entries, each with index, sub,
and the bytes (hex) that an SDO upload shall give. Prints a line for each difference; exit code 1 when there is one.
"""

import json
import pathlib
import sys

import canopen


def upload(remote, index, sub):
    """The bytes of an entry, or the text of what stopped the upload."""
    try:
        return remote.sdo.upload(index, sub).hex()
    except (canopen.SdoAbortedError, canopen.SdoCommunicationError) as error:
        return f"{type(error).__name__}: {error}"


def check(folder, device):
    """The differences of one description."""
    path = folder / device["file"]
    node_id = device["node_id"]
    try:
        dictionary = canopen.import_od(str(path), node_id=node_id)
    except Exception as error:  # whatever the reader raises is a difference
        return [f"{path.name}: not read: {type(error).__name__}: {error}"]
    bus, other = canopen.Network(), canopen.Network()
    bus.connect(interface="virtual", channel=path.name)
    other.connect(interface="virtual", channel=path.name)
    differences = []
    try:
        bus.add_node(canopen.LocalNode(node_id, dictionary))
        remote = other.add_node(canopen.RemoteNode(node_id, canopen.ObjectDictionary()))
        remote.sdo.RESPONSE_TIMEOUT = 5
        for entry in device["entries"]:
            found = upload(remote, entry["index"], entry["sub"])
            if found != entry["bytes"]:
                place = f"{entry['index']:04X}sub{entry['sub']:X}"
                differences.append(f"{path.name}: {place}: expected {entry['bytes']}, uploaded {found}")
    finally:
        bus.disconnect()
        other.disconnect()
    return differences


def main():
    folder = pathlib.Path(sys.argv[1])
    devices = json.loads((folder / "expected.json").read_text())
    differences = [line for device in devices for line in check(folder, device)]
    entries = sum(len(device["entries"]) for device in devices)
    print("\n".join(differences))
    print(f"{len(devices)} descriptions, {entries} entries, {len(differences)} differences")
    sys.exit(bool(differences))


if __name__ == "__main__":
    main()
