"""canopen for Python as the master of a node that keeps what is stored: `python stored.py PROGRAM EDS`.

Stores values (1010h) and a new node-ID (LSS), switches the node off and on, and reads each value where it belongs: stored ones are kept,
COB-IDs follow the node-ID. After 1011h the next power cycle brings the defaults, but not the former node-ID.
"""

import contextlib
import pathlib
import queue
import re
import subprocess
import sys
import tempfile

import canopen

from test import Slcan

HEARTBEAT, EVENT_TIMER, LIMIT = (0x1017, 0), (0x1800, 5), (0x6002, 1)
# COB-IDs without the node-ID
OF_NODE = {(0x1014, 0): 0x80, (0x1200, 1): 0x600, (0x1200, 2): 0x580, (0x1400, 1): 0x200, (0x1401, 1): 0x300,
           (0x1800, 1): 0x180, (0x1801, 1): 0x280}


def entry(node, index, sub):
    found = node.sdo[index]
    return found[sub] if isinstance(found, (canopen.sdo.SdoRecord, canopen.sdo.SdoArray)) else found


def values(node, entries):
    return {at: entry(node, *at).raw for at in entries}


def of_node(node_id):
    return {at: base + node_id for at, base in OF_NODE.items()}


class Frames:
    """The frames of one CAN-ID."""

    def __init__(self, network, can_id):
        self.received = queue.Queue()
        network.subscribe(can_id, lambda cob_id, data, at: self.received.put(bytes(data)))

    def next(self):
        return self.received.get(timeout=2)


@contextlib.contextmanager
def power(program, eds, flash, node_id):
    """The node from power-on to power-off: it is killed, as by a power failure."""
    process = subprocess.Popen([program, flash], stdout=subprocess.PIPE, text=True)
    port = int(re.fullmatch(r"listening on .*:(\d+)\n", process.stdout.readline())[1])
    network = canopen.Network(Slcan(("127.0.0.1", port)))
    try:
        node = network.add_node(canopen.RemoteNode(node_id, eds))
        boot_up = Frames(network, 0x700 + node_id)
        network.connect()
        assert boot_up.next() == b"\0"
        yield network, node
    finally:
        network.disconnect()
        process.kill()
        process.wait()


def main(program, eds):
    changed = {HEARTBEAT: 100, EVENT_TIMER: 50, LIMIT: 0x5A}
    with tempfile.TemporaryDirectory() as folder:
        flash = str(pathlib.Path(folder) / "flash.bin")

        with power(program, eds, flash, 5) as (network, node):
            defaults = values(node, changed)
            assert all(defaults[at] != value for at, value in changed.items()), defaults
            assert values(node, OF_NODE) == of_node(5)
            for at, value in changed.items():
                entry(node, *at).raw = value
            node.store()
            entry(node, *LIMIT).raw = 1  # after that: it is lost
            master = network.lss
            master.send_switch_state_global(master.CONFIGURATION_STATE)
            master.configure_node_id(10)
            master.store_configuration()
            master.send_switch_state_global(master.WAITING_STATE)
            assert values(node, OF_NODE) == of_node(5), "until the next reset"

        with power(program, eds, flash, 10) as (network, node):
            assert values(node, changed) == changed
            assert values(node, OF_NODE) == of_node(10)
            heartbeat, mine, former = (Frames(network, can_id) for can_id in (0x70A, 0x18A, 0x185))
            node.nmt.state = "OPERATIONAL"
            assert mine.next() == mine.next() == bytes(2), "every 50 ms"
            while heartbeat.next() != b"\5":
                pass
            assert former.received.empty()
            node.nmt.state = "PRE-OPERATIONAL"
            node.restore()
            assert values(node, changed) == changed, "until the next reset"

        with power(program, eds, flash, 10) as (network, node):
            assert values(node, changed) == defaults
            assert values(node, OF_NODE) == of_node(10)
    print(f"power cycles: {len(changed)} stored values and {len(OF_NODE)} COB-IDs are where they belong")


main(*sys.argv[1:])
