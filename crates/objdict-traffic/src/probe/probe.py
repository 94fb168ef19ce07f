#!/usr/bin/env python3
"""Asks a CANopen device what its description says of it, and writes down the answers. Needs python-canopen 2.

    python3 probe.py --channel can0
    python3 probe.py --interface pcan --channel PCAN_USBBUS1 --bitrate 250000 --output answers.json

Each row of the output is a transfer: index, sub-index, action (read or write), the bytes that were sent, and the answer: its size
in bytes and the bytes as they were transferred, or the abort code. A row without any of them had no answer in time.
"""

import argparse
import csv
import json
import struct
import sys

import canopen

NODE_ID = 1
COLUMNS = ["index", "sub", "action", "sent", "size", "bytes", "abort"]

# abort codes: no object, no sub-index
ABSENT = "0x06020000", "0x06090011"

# what is written instead of given bytes: the value that was read, with a zero byte more, without its last byte
READ, OWN, LONGER, SHORTER = "read", "own", "longer", "shorter"

# index, sub-index, and READ or what to write; of several values the first that is not the present one. What was accepted is
# read, and the value before is written back.
QUESTIONS = []


class Probe:
    """Transfers with one node, each of which becomes a row."""

    # so many transfers without an answer, before the first answer, mean that there is no node
    PATIENCE = 3

    def __init__(self, network, node_id=NODE_ID, timeout=0.5):
        # without a dictionary, because python-canopen cuts answers to the lengths that it knows
        self.node = network.add_node(node_id, canopen.ObjectDictionary())
        self.node.sdo.RESPONSE_TIMEOUT = timeout
        self.rows = []
        self.is_there = False

    def ask(self, questions=None):
        for index, sub, what in QUESTIONS if questions is None else questions:
            if what == READ:
                self.read(index, sub)
            else:
                self.write_and_restore(index, sub, what)
        return self.rows

    def scan(self, first, last):
        """Reads every object of a device whose dictionary is not known."""
        for index in range(first, last + 1):
            value = self.find(index, 0)
            # sub-index 0 of arrays and records is the highest sub-index; without it, sub-index 1 says that there are others
            if value is not None and len(value) == 1 and self.find(index, 1) is not None:
                for sub in range(2, value[0] + 1):
                    self.read(index, sub)

    def find(self, index, sub):
        """The value of an entry that is there, if it can be read."""
        value = self.read(index, sub)
        if self.rows[-1].get("abort") in ABSENT:
            self.rows.pop()
        return value

    def read(self, index, sub):
        row = {"index": f"0x{index:04X}", "sub": f"0x{sub:02X}", "action": "read"}
        return self.transfer(row, lambda: self.node.sdo.upload(index, sub))

    def write(self, index, sub, data):
        row = {"index": f"0x{index:04X}", "sub": f"0x{sub:02X}", "action": "write", "sent": data.hex(" ").upper()}
        return self.transfer(row, lambda: download(self.node.sdo, index, sub, data), len(data)) is not None

    def transfer(self, row, action, size=0):
        """The value that was read, or an empty one for a write that was accepted; None if there is none."""
        self.rows.append(row)
        try:
            value = action()
        except canopen.SdoAbortedError as error:
            row["abort"] = f"0x{error.code:08X}"
            self.is_there = True
            return None
        except canopen.SdoCommunicationError:
            if not self.is_there and len(self.rows) >= self.PATIENCE:
                raise TimeoutError(f"node {self.node.id} does not respond") from None
            return None
        self.is_there = True
        if value is None:
            row["size"] = size
            return b""
        row["size"] = len(value)
        row["bytes"] = value.hex(" ").upper()
        return value

    def write_and_restore(self, index, sub, what):
        before = self.read(index, sub)
        if not before:
            return
        if isinstance(what, tuple):
            what = next(value for value in what if bytes.fromhex(value) != before)
        words = {OWN: before, LONGER: before + b"\0", SHORTER: before[:-1]}
        data = words[what] if what in words else bytes.fromhex(what)
        if self.write(index, sub, data) and data != before:
            self.read(index, sub)
            self.write(index, sub, before)
            self.read(index, sub)


def download(sdo, index, sub, data):
    """Writes bytes; the streams of python-canopen send segments of a transfer that was refused."""
    if len(data) <= 4:
        sdo.request_response(struct.pack("<BHB", 0x23 | 4 - len(data) << 2, index, sub) + data.ljust(4, b"\0"))
        return
    sdo.request_response(struct.pack("<BHBL", 0x21, index, sub, len(data)))
    for at in range(0, len(data), 7):
        segment = data[at:at + 7]
        command = at // 7 % 2 << 4 | 7 - len(segment) << 1 | (at + 7 >= len(data))
        sdo.request_response(bytes([command]) + segment.ljust(7, b"\0"))


def save(rows, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        if path.endswith(".json"):
            json.dump(rows, file, indent=1)
            file.write("\n")
        else:
            writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Ask a CANopen device what its description says of it.")
    parser.add_argument("--interface", default="socketcan", help="as python-can names it (default: %(default)s)")
    parser.add_argument("--channel", default="can0", help="such as can0, vcan0, PCAN_USBBUS1 (default: %(default)s)")
    parser.add_argument("--bitrate", type=int, help="in bit/s, for interfaces that set it")
    parser.add_argument("--timeout", type=float, default=0.5, help="seconds for an answer (default: %(default)s)")
    parser.add_argument("--node-id", type=int, default=NODE_ID, help="the node (default: %(default)s)")
    parser.add_argument("--output", default="answers.csv", help="a .csv or .json file (default: %(default)s)")
    parser.add_argument("--scan", metavar="RANGES", help="read every object of these ranges, such as 1000-1FFF,6000-67FF, "
                        "instead of those of the description")
    options = parser.parse_args(arguments)
    scanned = [[int(index, 16) for index in part.split("-")] for part in options.scan.split(",")] if options.scan else []
    network = canopen.Network()
    bus = {"interface": options.interface, "channel": options.channel}
    if options.bitrate:
        bus["bitrate"] = options.bitrate
    network.connect(**bus)
    probe = Probe(network, options.node_id, options.timeout)
    try:
        for part in scanned:
            probe.scan(part[0], part[-1])
        if not scanned:
            probe.ask()
    except TimeoutError as error:
        print(error, file=sys.stderr)
        return 1
    finally:
        network.disconnect()
        save(probe.rows, options.output)
    print(f"{len(probe.rows)} transfers: {options.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
