"""canopen for Python as the LSS master of devices without node-ID: `python lss.py PROGRAM`.

Finds each of them by fastscan, gives it a node-ID and a bit rate, and lets it store them.
"""

import queue
import re
import subprocess
import sys
import threading
import time

import canopen
from canopen import lss

from test import Slcan

IDENTITIES = (0x319, 0x12345678, 0x10002, 0xFFFFFFFE), (0x319, 0x12345678, 0x10002, 7), (0x318, 1, 0, 0), (0, 0, 0, 0)
INQUIRIES = (lss.CS_INQUIRE_VENDOR_ID, lss.CS_INQUIRE_PRODUCT_CODE, lss.CS_INQUIRE_REVISION_NUMBER,
             lss.CS_INQUIRE_SERIAL_NUMBER)


def error_of(action, *arguments):
    try:
        action(*arguments)
    except lss.LssError as error:
        return str(error)
    return None


def configure(master, identity, node_id, said):
    """All services of the configuration state, for the one slave that is in it."""
    assert tuple(master.inquire_lss_address(inquiry) for inquiry in INQUIRIES) == identity
    assert master.inquire_node_id() == 0xFF
    assert error_of(master.configure_node_id, 128) == "LSS Error: 1"
    master.configure_node_id(node_id)
    assert master.inquire_node_id() == node_id
    assert error_of(master.configure_bit_timing, 8) == "LSS Error: 1", "10 kbit/s"
    master.configure_bit_timing(3)
    master.store_configuration()
    assert said.get(timeout=2) == f"stored Some({node_id}) Some(250)\n"
    master.configure_node_id(0xFF)
    assert error_of(master.store_configuration) == "LSS Error: 2", "no access"
    assert said.get(timeout=2) == "stored None Some(250)\n"
    master.configure_node_id(node_id)


def main(program):
    numbers = [str(number) for identity in IDENTITIES for number in identity]
    process = subprocess.Popen([program, *numbers], stdout=subprocess.PIPE, text=True)
    port = int(re.fullmatch(r"listening on .*:(\d+)\n", process.stdout.readline())[1])
    said = queue.Queue()
    threading.Thread(target=lambda: [said.put(line) for line in process.stdout], daemon=True).start()
    network = canopen.Network(Slcan(("127.0.0.1", port)))
    network.connect()
    master = network.lss
    booted = queue.Queue()
    for node_id in range(1, 1 + len(IDENTITIES)):
        network.subscribe(0x700 + node_id, lambda cob_id, data, at: booted.put((cob_id, bytes(data))))
    try:
        found = set()
        for node_id in range(1, 1 + len(IDENTITIES)):
            # most requests have no answer; one that comes late on a busy machine leads the scan astray
            for timeout in [0.03, 0.1, 0.3]:
                master.RESPONSE_TIMEOUT = timeout
                is_found, identity = master.fast_scan()
                if is_found:
                    break
            assert is_found, f"{len(found)} of {len(IDENTITIES)}"
            master.RESPONSE_TIMEOUT = 2
            found.add(tuple(identity))
            configure(master, tuple(identity), node_id, said)
            master.send_switch_state_global(master.WAITING_STATE)
            assert booted.get(timeout=2) == (0x700 + node_id, b"\0")
        assert found == set(IDENTITIES), found
        master.RESPONSE_TIMEOUT = 0.03
        assert master.fast_scan() == (False, None), "all have node-IDs"

        master.RESPONSE_TIMEOUT = 2
        assert master.send_switch_state_selective(*IDENTITIES[1])
        assert master.inquire_lss_address(lss.CS_INQUIRE_SERIAL_NUMBER) == 7
        master.activate_bit_timing(20)
        assert said.get(timeout=2) == "250 kbit/s\n"
        time.sleep(0.05)
        assert 1 <= master.inquire_node_id() <= len(IDENTITIES)
    finally:
        network.disconnect()
        process.kill()
    print(f"LSS: {len(found)} devices found by fastscan, configured and stored")


main(*sys.argv[1:])
