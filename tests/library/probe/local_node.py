"""Runs a probe script against a LocalNode of python-canopen: `local_node.py SCRIPT EDS OUTPUT [DIFFERENCES]`.

Writes OUTPUT.csv, OUTPUT.json and OUTPUT.log, a candump log of the same transfers. DIFFERENCES is a JSON list of what the node
does otherwise than its EDS: `index`, `sub`, and `read` (bytes as hex digits, or an abort code) or `write` (an abort code, null for
a write that is accepted, or "ignored" for one that is accepted if it is right, and forgotten).
"""

import importlib.util
import json
import sys

import can
import canopen

# a bus in this process, or with `--socketcan` one of the kernel
BUS = ({"interface": "socketcan", "channel": "vcan0"} if "--socketcan" in sys.argv
       else {"interface": "virtual", "channel": "probe"})
NO_SUB_INDEX, TOO_LONG, TOO_SHORT, TOO_HIGH, TOO_LOW = 0x06090011, 0x06070012, 0x06070013, 0x06090031, 0x06090032


class Node(canopen.LocalNode):
    """A LocalNode that also checks limits, lengths and the sub-index of a VAR, which python-canopen does not."""

    def __init__(self, node_id, eds, differences):
        super().__init__(node_id, eds)
        self.otherwise = {(one["index"], one["sub"], kind): one[kind]
                          for one in differences for kind in ("read", "write") if kind in one}

    def get_data(self, index, subindex, check_readable=False):
        otherwise = self.otherwise.get((index, subindex, "read"))
        if isinstance(otherwise, int):
            raise canopen.SdoAbortedError(otherwise)
        if otherwise is not None:
            return bytes.fromhex(otherwise)
        return super().get_data(index, subindex, check_readable)

    def set_data(self, index, subindex, data, check_writable=False):
        otherwise = self.otherwise.get((index, subindex, "write"), "")
        if isinstance(otherwise, int):
            raise canopen.SdoAbortedError(otherwise)
        if otherwise is None:
            self.data_store.setdefault(index, {})[subindex] = bytes(data)
            return
        entry = self._find_object(index, subindex)
        if not entry.writable:
            raise canopen.SdoAbortedError(0x06010002)
        if entry.fixed_size and 8 * len(data) != len(entry):
            raise canopen.SdoAbortedError(TOO_LONG if 8 * len(data) > len(entry) else TOO_SHORT)
        if entry.data_type in canopen.objectdictionary.NUMBER_TYPES:
            value = entry.decode_raw(bytes(data))
            if entry.max is not None and value > entry.max:
                raise canopen.SdoAbortedError(TOO_HIGH)
            if entry.min is not None and value < entry.min:
                raise canopen.SdoAbortedError(TOO_LOW)
        if otherwise != "ignored":
            self.data_store.setdefault(index, {})[subindex] = bytes(data)

    def _find_object(self, index, subindex):
        entry = super()._find_object(index, subindex)
        members = getattr(self.object_dictionary[index], "subindices", [0])
        # python-canopen makes up the entries of an array
        if subindex not in members:
            raise canopen.SdoAbortedError(NO_SUB_INDEX)
        return entry


def main(script, eds, output, differences=None):
    spec = importlib.util.spec_from_file_location("probe_script", script)
    probe = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(probe)
    planted = []
    if differences:
        with open(differences, encoding="utf-8") as file:
            planted = json.load(file)
    device, client = canopen.Network(), canopen.Network()
    device.connect(**BUS)
    client.connect(**BUS)
    recorder = can.Bus(**BUS)
    notifier = can.Notifier(recorder, [can.Logger(output + ".log")])
    node_id = probe.NODE_ID
    is_checked = planted or "--checked" in sys.argv
    device.add_node(Node(node_id, eds, planted) if is_checked else canopen.LocalNode(node_id, eds))
    asked = probe.Probe(client, node_id, timeout=2)
    if "--scan" in sys.argv:
        asked.scan(0x1000, 0x2FFF)
        asked.scan(0x6000, 0x67FF)
    else:
        asked.ask()
    for ending in ".csv", ".json":
        probe.save(asked.rows, output + ending)
    client.disconnect()
    notifier.stop()
    recorder.shutdown()
    device.disconnect()
    # a virtual bus may hand the recorder an answer before its request, in the same microsecond too; the CAN-ID of requests is higher
    with open(output + ".log", encoding="utf-8") as file:
        frames = sorted(file, key=lambda line: (line[:line.index(")")], -int(line.split()[2].split("#")[0], 16)))
    with open(output + ".log", "w", encoding="utf-8") as file:
        file.writelines(frames)


main(*[argument for argument in sys.argv[1:] if not argument.startswith("--")])
