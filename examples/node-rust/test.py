"""canopen for Python as the master of the node: `python test.py PROGRAM EDS [CONFORMANCE]`.

Reads and writes every entry by expedited, segmented and block transfers, maps a TPDO and an RPDO anew, and uses both.
"""

import json
import re
import socket
import subprocess
import sys
import threading
import time

import can
import canopen

NODE = 5
BEYOND_LIMITS = 0x06090031, 0x06090032
READ_ONLY, WRITE_ONLY, NOT_MAPPABLE, VALID = 0x06010002, 0x06010001, 0x06040041, 0x06010000
CANNOT_STORE, NO_DATA = 0x08000020, 0x08000024


class Slcan(can.BusABC):
    """The bus of the node: one frame a line. With pyserial, the interface `slcan` of python-can does the same."""

    def __init__(self, address):
        super().__init__(channel=address)
        self.stream = socket.create_connection(address)
        self.stream.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.text = b""

    def send(self, msg, timeout=None):
        self.stream.sendall(b"t%03X%d%s\r" % (msg.arbitration_id, msg.dlc, msg.data.hex().upper().encode()))

    def _recv_internal(self, timeout):
        self.stream.settimeout(timeout)
        try:
            while b"\r" not in self.text:
                received = self.stream.recv(4096)
                if not received:
                    raise can.CanOperationError("the node is gone")
                self.text += received
        except TimeoutError:
            return None, False
        line, self.text = self.text.split(b"\r", 1)
        message = can.Message(arbitration_id=int(line[1:4], 16), data=bytes.fromhex(line[5:].decode()),
                              is_extended_id=False, timestamp=time.time())
        return message, False


def variables(dictionary):
    for entry in (entry for entry in dictionary.values() if entry.index >= 0x20):
        if isinstance(entry, canopen.objectdictionary.ODVariable):
            yield entry
        else:
            yield from entry.subindices.values()


def download(node, entry, value, **how):
    with node.sdo.open(entry.index, entry.subindex, "wb", size=len(value), buffering=0, **how) as stream:
        at = 0
        while at < len(value):
            at += stream.write(value[at:])


def upload_block(node, entry):
    with node.sdo.open(entry.index, entry.subindex, "rb", block_transfer=True, buffering=0) as stream:
        return stream.read()


def abort_of(action, *arguments):
    try:
        action(*arguments)
    except canopen.SdoAbortedError as abort:
        return abort.code
    return None


def eventually(condition):
    end = time.monotonic() + 2
    while not condition() and time.monotonic() < end:
        time.sleep(0.001)
    return condition()


def read_and_write(node):
    """Every entry has its default, by each kind of transfer; those that are writable take it, and another value if they have room."""
    counts = {"read": 0, "default": 0, "written": 0, "refused": 0, "beyond limits": 0}
    for entry in variables(node.object_dictionary):
        where = f"{entry.index:04X}:{entry.subindex:02X}"
        if not entry.readable:
            assert abort_of(node.sdo.upload, entry.index, entry.subindex) == WRITE_ONLY, where
            continue
        if entry.index == 0x1003 and entry.subindex > 0:
            assert abort_of(node.sdo.upload, entry.index, entry.subindex) == NO_DATA, "there was no error"
            continue
        value = node.sdo.upload(entry.index, entry.subindex)
        assert upload_block(node, entry) == value, where
        counts["read"] += 1
        stores = entry.index in (0x1010, 0x1011) and entry.subindex > 0
        if isinstance(entry.default, (int, float)) and not isinstance(entry.default, bool) and not stores:
            assert value == entry.encode_raw(entry.default), where
            counts["default"] += 1
        if not entry.writable:
            assert abort_of(node.sdo.download, entry.index, entry.subindex, value or b"\0") == READ_ONLY, where
            counts["refused"] += 1
        elif stores:
            # the node has no memory, and says so
            assert not any(value), where
            for signature in b"save", b"load":
                assert abort_of(node.sdo.download, entry.index, entry.subindex, signature) == CANNOT_STORE, where
        elif not 0x1400 <= entry.index <= 0x1BFF:
            # strings without a default have room for 32 bytes, a DOMAIN for 1000
            values = [value or b"objdict"]
            if entry.data_type == canopen.objectdictionary.DOMAIN and not value:
                values.append(bytes(range(250)) * 4)
            if abort_of(node.sdo.download, entry.index, entry.subindex, values[0]) in BEYOND_LIMITS:
                counts["beyond limits"] += 1
                continue
            for value in values:
                for how in {"force_segment": False}, {"force_segment": True}, {"block_transfer": True}:
                    download(node, entry, value, **how)
                    assert node.sdo.upload(entry.index, entry.subindex) == value, where
                assert upload_block(node, entry) == value, where
            counts["written"] += 1
    return counts


def compare(node, path):
    """canopen for Python sees what `objdict conformance --format json` says: the objects, and the aborts that it can cause."""
    with open(path) as file:
        checks = json.load(file)["checks"]
    # what `read_and_write` has found of each object is found by the checks too; canopen leaves out data types
    objects = {check["name"]: check["result"] for check in checks
               if check["service"].startswith("objects") and check["service"] != "objects below 1000h"}
    indexes = {entry.index for entry in variables(node.object_dictionary)}
    assert objects == {f"{index:04X}h": "passed" for index in indexes}, objects
    entries = list(variables(node.object_dictionary))
    first = lambda is_meant: next((entry for entry in entries if entry.index >= 0x2000 and is_meant(entry)), None)
    read_only, write_only = first(lambda entry: not entry.writable), first(lambda entry: not entry.readable)
    word = first(lambda entry: entry.writable and entry.data_type in (5, 6, 7) and len(entry) >= 16)
    up, down = node.sdo.upload, node.sdo.download
    causes = {
        "0602 0000h: upload without an object": (up, 0xFFFF, 0),
        "0602 0000h: download without an object": (down, 0xFFFF, 0, b"\0"),
        "0609 0011h: upload without a sub-index": (up, 0x1018, 0xFD),
        "0609 0011h: download without a sub-index": (down, 0x1018, 0xFD, b"\0"),
        "0601 0001h: upload of what is write-only": write_only and (up, write_only.index, write_only.subindex),
        "0601 0002h: expedited download to what is read-only":
            read_only and (down, read_only.index, read_only.subindex, b"\0"),
        "0601 0002h: segmented download to what is read-only":
            read_only and (down, read_only.index, read_only.subindex, bytes(4), True),
        "0607 0012h: a stated length beyond the entry's": word and (down, word.index, word.subindex, bytes(9)),
        "0607 0013h: a download of one byte to a longer entry": word and (down, word.index, word.subindex, b"\0"),
    }
    results = {check["name"]: check["result"] for check in checks}
    for name, cause in causes.items():
        is_passed = cause and abort_of(*cause) == int(name[:9].replace(" ", ""), 16)
        assert results[name] == ("passed" if is_passed else "absent"), name
    return len(objects) + len(causes)


def remap(node, network):
    """A TPDO and an RPDO with an entry each that the EDS does not map there; whether it has such."""
    node.nmt.state = "PRE-OPERATIONAL"
    pdos = [maps[1] for maps in (node.tpdo, node.rpdo) if 1 in maps.map]
    if len(pdos) < 2 or not all(pdo.map_array[0].od.writable and pdo.com_record[1].od.writable for pdo in pdos):
        return False
    for pdo, accesses in zip(pdos, (("rw", "rwr"), ("rw", "rww"))):
        pdo.read()
        mapped = {(entry.index, entry.subindex) for entry in pdo.map}
        entries = (entry for entry in variables(node.object_dictionary) if entry.access_type in accesses and entry.pdo_mappable)
        entry = next((entry for entry in entries if (entry.index, entry.subindex) not in mapped), None)
        if entry is None:
            return False
        pdo.clear()
        pdo.add_variable(entry.index, entry.subindex)
        pdo.trans_type, pdo.enabled = 255, True
        pdo.save()
    node.nmt.state = "OPERATIONAL"
    tpdo, rpdo = pdos
    for value in 1, 0, 1:
        node.sdo.download(tpdo[0].index, tpdo[0].subindex, tpdo[0].od.encode_raw(value))
        assert eventually(lambda: tpdo[0].raw == value), "sent for a new value"
        rpdo[0].raw = value
        rpdo.transmit()
        assert node.sdo.upload(rpdo[0].index, rpdo[0].subindex) == rpdo[0].od.encode_raw(value)

    # a mapping changes while the PDO is not valid; then its TPDO follows SYNC
    communication, mapping, cob_id = tpdo.com_record.od.index, tpdo.map_array.od.index, tpdo.cob_id
    assert abort_of(node.sdo.download, mapping, 0, b"\0") == VALID
    node.sdo.download(communication, 1, (cob_id | 1 << 31).to_bytes(4, "little"))
    node.sdo.download(mapping, 0, b"\0")
    assert abort_of(node.sdo.download, mapping, 1, bytes.fromhex("20001810")) == NOT_MAPPABLE
    node.sdo.download(communication, 2, b"\2")
    node.sdo.download(mapping, 0, b"\1")
    node.sdo.download(communication, 1, cob_id.to_bytes(4, "little"))
    frames = []
    network.subscribe(cob_id, lambda _, data, at: frames.append(bytes(data)))
    for _ in range(6):
        network.sync.transmit()
        time.sleep(0.02)
    assert len(frames) == 3, f"every second SYNC, not {frames}"
    return True


def reset(node, network, command):
    """The node boots again, and is pre-operational."""
    booted = threading.Event()
    network.subscribe(0x700 + NODE, lambda _, data, at: data[0] == 0 and booted.set())
    node.nmt.state = command
    assert booted.wait(2), f"no boot-up message after {command}"


def main(program, eds, conformance=None):
    process = subprocess.Popen([program], stdout=subprocess.PIPE, text=True)
    port = int(re.fullmatch(r"listening on .*:(\d+)\n", process.stdout.readline())[1])
    network = canopen.Network(Slcan(("127.0.0.1", port)))
    network.connect()
    try:
        node = network.add_node(NODE, eds)
        node.sdo.RESPONSE_TIMEOUT = 2
        reset(node, network, "RESET")
        counts = read_and_write(node)
        if conformance is not None:
            counts["as in the conformance table"] = compare(node, conformance)
        is_mapped = remap(node, network)
        node.sdo[0x1017].raw = 20
        node.nmt.state = "OPERATIONAL"
        assert node.nmt.wait_for_heartbeat(2) == "OPERATIONAL"
        reset(node, network, "RESET COMMUNICATION")
    finally:
        network.disconnect()
        process.kill()
    print(", ".join(f"{count} {what}" for what, count in counts.items()),
          "a TPDO and an RPDO mapped anew" if is_mapped else "no PDOs to map anew", sep=", ")


if __name__ == "__main__":
    main(*sys.argv[1:])
