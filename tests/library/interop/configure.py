"""Configures simulated nodes on a virtual bus with their concise DCFs, and compares them with their DCFs.

usage: configure.py FOLDER NAME...

FOLDER holds NAME.eds, NAME.cdcf and NAME.dcf of each node. Prints a line for each difference; exit code 1 when there is one.
"""

import pathlib
import struct
import sys

import canopen


def downloads(stream):
    """The downloads of a concise DCF."""
    (count,) = struct.unpack_from("<L", stream)
    offset = 4
    for _ in range(count):
        index, sub, size = struct.unpack_from("<HBL", stream, offset)
        yield index, sub, stream[offset + 7 : offset + 7 + size]
        offset += 7 + size
    if offset != len(stream):
        raise ValueError(f"{len(stream) - offset} bytes after the last download")


def check(folder, name):
    """The differences of one node."""
    wanted = canopen.import_od(str(folder / f"{name}.dcf"))
    dictionary = canopen.import_od(str(folder / f"{name}.eds"), node_id=wanted.node_id)
    bus, other = canopen.Network(), canopen.Network()
    bus.connect(interface="virtual", channel=f"{folder.name}-{name}")
    other.connect(interface="virtual", channel=f"{folder.name}-{name}")
    differences = []
    try:
        bus.add_node(canopen.LocalNode(wanted.node_id, dictionary))
        remote = other.add_node(canopen.RemoteNode(wanted.node_id, dictionary))
        remote.sdo.RESPONSE_TIMEOUT = 5
        last = {}
        for index, sub, data in downloads((folder / f"{name}.cdcf").read_bytes()):
            remote.sdo.download(index, sub, data)
            last[index, sub] = data
        compared = 0
        for entry in wanted.values():
            for variable in [entry] if isinstance(entry, canopen.objectdictionary.ODVariable) else entry.values():
                if variable.value is None or variable.value == variable.default:
                    continue
                compared += 1
                place = variable.index, variable.subindex
                expected = variable.encode_raw(variable.value)
                found = remote.sdo.upload(*place)
                # what is sent after the values counts more
                if found != last.get(place, expected):
                    differences.append(f"{name}: {place[0]:04X}sub{place[1]:X}: expected {expected.hex()}, is {found.hex()}")
        if last and not compared:
            differences.append(f"{name}: the DCF has no values")
    finally:
        bus.disconnect()
        other.disconnect()
    return differences


def main():
    folder = pathlib.Path(sys.argv[1])
    differences = [line for name in sys.argv[2:] for line in check(folder, name)]
    print("\n".join(differences))
    sys.exit(bool(differences))


main()
