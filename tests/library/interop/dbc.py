"""Reads DBC files with cantools and canmatrix and decodes frames that are packed by the mapping of the nodes.

usage: dbc.py FOLDER

FOLDER holds the files and `cases.json`: a list of cases with `dbc`, the file, and `nodes`: each with `json`, the file of
its model, `node_id`, `omitted`, the places (index and sub-index) that the DBC does not have, and `counterpart`, whether it has
only the other sides of the PDOs of the other nodes. Prints a line for each difference; exit code 1 when there is one.
"""

import json
import math
import pathlib
import random
import re
import struct
import sys

import cantools
import canmatrix.formats

KINDS = {"BOOLEAN": ("u", 1), "REAL32": ("f", 32), "REAL64": ("f", 64)}
for _bits in range(8, 65, 8):
    KINDS[f"UNSIGNED{_bits}"] = ("u", _bits)
    KINDS[f"INTEGER{_bits}"] = ("s", _bits)
TIMES = ("TIME_OF_DAY", "TIME_DIFFERENCE")
MISSING = object()


def number(value, node_id):
    """The number of a value of the model, None if it is not one."""
    if not value:
        return None
    if "node_id_plus" in value:
        return value["node_id_plus"] + node_id
    numbers = [value[kind] for kind in ("unsigned", "signed", "boolean") if kind in value]
    return int(numbers[0]) if numbers else None


class Node:
    """The dictionary of a node."""

    def __init__(self, path, node_id, omitted, is_counterpart):
        self.is_counterpart = is_counterpart
        self.objects = json.loads(path.read_text())["device"]["objects"]
        self.node_id = node_id
        self.omitted = {tuple(place) for place in omitted}

    def entry(self, index, sub):
        found = self.objects.get(f"0x{index:04X}")
        if found is None:
            return None
        subs = found.get("subs", {})
        compact = found.get("compact")
        if f"0x{sub:02X}" in subs:
            return subs[f"0x{sub:02X}"]
        if compact:
            if sub > compact["count"]:
                return None
            if sub == 0:
                return {"data_type": "UNSIGNED8", "default": {"unsigned": compact["count"]}}
            values = {int(key, 16): value for key, value in compact.get("values", {}).items()}
            entry = dict(found)
            if sub in values:
                entry["configured"] = {"value": values[sub]}
            return entry
        is_single = found.get("object_type") not in ("ARRAY", "RECORD", "DEFSTRUCT")
        return found if sub == 0 and is_single and not found.get("orphan") else None

    def number(self, index, sub):
        entry = self.entry(index, sub) or {}
        configured = entry.get("configured", {}).get("value")
        return number(configured or entry.get("default"), self.node_id)

    def pdos(self):
        """Each PDO that is valid: CAN-ID, name, index of the mapping, fields (sub, index, sub, first bit, bits)."""
        for name, first in (("RPDO", 0x1400), ("TPDO", 0x1800)):
            for index in range(first, first + 0x200):
                cob_id = self.number(index, 1)
                if cob_id is None or cob_id >> 31 or cob_id < 0:
                    continue
                mapping = index + 0x200
                count = self.number(mapping, 0)
                subs = range(1, (64 if count is None else count) + 1 if count is None or count <= 64 else 1)
                fields, bit = [], 0
                for sub in subs:
                    mapped = self.number(mapping, sub)
                    if not mapped or mapped >> 32:
                        if count is None or mapped is None or mapped >> 32:
                            break
                        continue
                    if self.entry(mapping, sub) is None:
                        break
                    fields.append((sub, mapped >> 16, mapped >> 8 & 0xFF, bit, mapped & 0xFF))
                    bit += mapped & 0xFF
                extended = bool(cob_id >> 29 & 1)
                can_id = cob_id & (0x1FFFFFFF if extended else 0x7FF)
                yield (extended, can_id), f"{name}{index - first + 1}", mapping, fields, bit


class Value:
    """A known value of a mapped entry in its bits."""

    def __init__(self, entry, bits, source):
        kind, size = KINDS.get((entry or {}).get("data_type"), ("u", 64))
        self.kind, self.bits = kind, min(bits, size)
        if kind == "f":
            raw = struct.pack("<f" if size == 32 else "<d", source.uniform(-1e6, 1e6))
            self.raw = int.from_bytes(raw, "little")
            self.value, = struct.unpack("<f" if size == 32 else "<d", raw)
        else:
            self.raw = source.choice([0, 1, 1 << self.bits - 1, (1 << self.bits) - 1, source.getrandbits(self.bits)])
            self.raw &= (1 << self.bits) - 1
            self.value = signed(self.raw, self.bits) if kind == "s" else self.raw


def signed(raw, bits):
    return raw - (1 << bits) if raw >> bits - 1 else raw


def scaling(entry):
    """Factor and offset that the description itself states, without templates."""
    parameter = (entry or {}).get("parameter", {})
    if parameter.get("template") or not ({"multiplier", "offset", "unit"} & set(parameter)):
        return None
    try:
        factor = float(parameter.get("multiplier") or 1) or 1.0
        return factor, factor * float(parameter.get("offset") or 0)
    except ValueError:
        return None


def is_dummy(index):
    return 0 < index < 0x20


class Case:
    def __init__(self, folder, case):
        self.differences, self.entries = [], 0
        self.name = case["dbc"]
        path = folder / case["dbc"]
        self.nodes = [
            Node(folder / node["json"], node["node_id"], node["omitted"], node["counterpart"]) for node in case["nodes"]
        ]
        self.has_bits = case["bits"]
        self.random = random.Random(case["dbc"])
        try:
            self.database = cantools.database.load_file(path, encoding="latin-1", strict=True)
            (self.matrix,) = canmatrix.formats.loadp(str(path), dbcImportEncoding="latin-1").values()
        except Exception as error:  # whatever a reader raises is a difference
            self.differences.append(f"{self.name}: not read: {type(error).__name__}: {error}")
            return
        self.messages = {(m.is_extended_frame, m.frame_id): m for m in self.database.messages}
        self.frames = {(f.arbitration_id.extended, f.arbitration_id.id): f for f in self.matrix.frames}
        if self.messages.keys() != self.frames.keys():
            self.differ("", "the tools see other messages")
        for node in self.nodes:
            for key, name, mapping, fields, end in node.pdos():
                if node.is_counterpart:
                    self.check_counterpart(node, key, name, mapping)
                else:
                    self.check_pdo(node, key, name, mapping, fields, end)
                if name.startswith("TPDO") and key in self.messages:
                    self.check_cycle(node, key, name, mapping - 0x200)
            if case["sdo"]:
                self.check_sdo(node)

    def differ(self, place, text):
        self.differences.append(f"{self.name}: {place}: {text}")

    def check_pdo(self, node, key, name, mapping, fields, end):
        place = f"node {node.node_id} {name}"
        message = self.messages.get(key)
        if not fields or {(mapping - 0x200, 1), (mapping, 0)} & node.omitted:
            return
        if message is None:
            return self.differ(place, f"no message {key}")
        frame, values = 0, {}
        for sub, index, mapped_sub, first, bits in fields:
            entry = node.entry(index, mapped_sub)
            if is_dummy(index) or (mapping, sub) in node.omitted:
                continue
            if entry and entry.get("data_type") in TIMES:
                value = Value({}, 48, self.random)
                value.raw &= ~(0xF << 28)
            else:
                value = Value(entry, bits, self.random)
            frame |= value.raw << first
            values[sub] = value
        data = frame.to_bytes(8, "little")[: message.length]
        # cantools gives integers of floats without scaling, so both are asked
        plain = message.decode(data, decode_choices=False, scaling=False, allow_truncated=False)
        scaled = message.decode(data, decode_choices=False)
        other = self.frames[key].decode(data)
        for sub, index, mapped_sub, first, bits in fields:
            if sub in values:
                entry = node.entry(index, mapped_sub)
                mapped = f"{place}.{sub} {index:04X}h:{mapped_sub:02X}"
                self.check_entry(mapped, message, entry, values[sub], first, bits, (plain, scaled, other))
                self.entries += 1

    def check_entry(self, place, message, entry, value, first, bits, decoded):
        plain, scaled, other = decoded
        signals = [signal for signal in message.signals if first <= signal.start < first + bits]
        if not signals:
            return self.differ(place, "no signal")
        is_whole = len(signals) == 1 and (signals[0].start, signals[0].length) == (first, value.bits)
        is_time = (entry or {}).get("data_type") in TIMES
        if not is_whole and not self.has_bits and not is_time:
            return self.differ(place, f"the signals are {signals}")
        for signal in signals:
            if is_whole:
                expected = value.value
            else:
                expected = value.raw >> signal.start - first & (1 << signal.length) - 1
                expected = signed(expected, signal.length) if signal.is_signed else expected
            found = plain[signal.name]
            if found != expected:
                self.differ(place, f"{signal.name} is {expected}, cantools decodes {found}")
            if signal.is_float != (value.kind == "f"):
                self.differ(place, f"{signal.name}: floating point is {signal.is_float}")
            physical = expected * signal.scale + signal.offset
            if not math.isclose(scaled[signal.name], physical, rel_tol=1e-9, abs_tol=1e-12):
                self.differ(place, f"{signal.name} is {physical}, cantools scales {scaled[signal.name]}")
            found = other.get(signal.name, MISSING)
            if found is MISSING or float(found.raw_value) != float(expected):
                self.differ(place, f"{signal.name} is {expected}, canmatrix decodes {found}")
            stated = scaling(entry) if is_whole else None
            if stated and not all(map(math.isclose, stated, (signal.scale, signal.offset))):
                self.differ(place, f"{signal.name}: scaled by {signal.scale}, {signal.offset}, stated {stated}")

    def sync(self, node):
        """The SYNC period in microseconds that a node listens to; None without a producer."""
        cob_id = node.number(0x1005, 0)
        can_id = 0x80 if cob_id is None else cob_id & 0x1FFFFFFF
        for other in self.nodes:
            produced = other.number(0x1005, 0) or 0
            if produced >> 30 & 1 and produced & 0x1FFFFFFF == can_id and other.number(0x1006, 0):
                return other.number(0x1006, 0)
        return None

    def check_cycle(self, node, key, name, communication):
        """A synchronous TPDO has the time of so many SYNC, another one that of its event timer."""
        place = f"node {node.node_id} {name}"
        if {(communication, 1), (communication + 0x200, 0)} & node.omitted:
            return
        kind = node.number(communication, 2)
        expected = None
        if kind is not None and 1 <= kind <= 240:
            period = self.sync(node)
            expected = period * kind / 1000 if period else None
        elif kind is None or kind > 253:
            expected = node.number(communication, 5) or None
        if expected is not None and (expected != int(expected) or expected > 4294967):
            expected = None
        found = self.messages[key].cycle_time or None
        other = self.frames[key].cycle_time or None
        if (found, other) != (expected, expected):
            self.differ(place, f"cycle time of {expected}, cantools has {found} and canmatrix {other}")

    def check_counterpart(self, node, key, name, mapping):
        """It sends what a node receives, and receives what a node sends."""
        place, message = f"counterpart {name}", self.messages.get(key)
        if message is None:
            return self.differ(place, f"no message {key}")
        (own,) = [n.name for n in self.database.nodes if n.comment.startswith(f"node-ID {node.node_id}:")]
        if name.startswith("TPDO"):
            if message.senders != [own]:
                self.differ(place, f"sent by {message.senders}")
        elif any(own not in signal.receivers for signal in message.signals):
            self.differ(place, f"not received by {own}")

    def check_sdo(self, node):
        key = (False, 0x580 + node.node_id)
        message = self.messages.get(key)
        if message is None:
            return
        for signal in message.signals:
            if signal.multiplexer_signal != "Entry":
                continue
            (selected,) = signal.multiplexer_ids
            index, sub = selected & 0xFFFF, selected >> 16
            entry = node.entry(index, sub)
            if entry.get("data_type") in TIMES:
                continue
            value = Value(entry, 32, self.random)
            data = struct.pack("<BHBI", 0x43, index, sub, value.raw)
            found = message.decode(data, decode_choices=False, scaling=False)
            self.entries += 1
            if found[signal.name] != value.value or found["Command"] != 2:
                self.differ(f"{index:04X}h:{sub:02X}", f"SDO of {value.value} is decoded as {found}")
        for way in (0x580, 0x600):
            self.check_other_commands((False, way + node.node_id))

    def check_other_commands(self, key):
        """An abort has its code and the entry, and frames without an entry are decoded too."""
        message, frame = self.messages[key], self.frames[key]
        data = struct.pack("<BHBI", 0x80, 0x1000, 0, 0x06090011)
        expected = (4, 0x1000, 0x06090011)
        found = message.decode(data, decode_choices=False)
        plain = tuple(found[name] for name in ("Command", "Entry_without_value", "Abort_code"))
        named = str(message.decode(data)["Abort_code"])
        other = frame.decode(data)
        values = tuple(other[name].raw_value for name in ("Command", "Entry_without_value", "Abort_code"))
        if (plain, values) != (expected, expected) or len(found) != 3:
            self.differ(f"{key}", f"an abort is decoded as {found} and {values}")
        for text in (named, other["Abort_code"].named_value):
            if text != "the object has no such sub-index":
                self.differ(f"{key}", f"the abort code is called {text}")
        for command in (0, 3, 5, 6) if key[1] >= 0x600 else (0, 1, 5, 6):
            data = bytes([command << 5, 1, 2, 3, 4, 5, 6, 7])
            if message.decode(data)["Data"] != int.from_bytes(data[1:], "little"):
                self.differ(f"{key}", f"command {command} is decoded as {message.decode(data)}")


def main():
    folder = pathlib.Path(sys.argv[1])
    cases = [Case(folder, case) for case in json.loads((folder / "cases.json").read_text())]
    differences = [line for case in cases for line in case.differences]
    entries = sum(case.entries for case in cases)
    print("\n".join(differences))
    print(f"{len(cases)} DBC, {entries} entries, {len(differences)} differences")
    sys.exit(bool(differences))


if __name__ == "__main__":
    main()
