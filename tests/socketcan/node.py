"""A node of python-canopen on vcan0: a drive with node-ID 5. It prints `ready` when it answers."""

import sys
import threading

import canopen

network = canopen.Network()
network.connect("vcan0", interface="socketcan")
node = network.create_node(5, "/drive-402.eds")
node.nmt.state = "PRE-OPERATIONAL"
node.nmt.start_heartbeat(500)
print("ready", flush=True)
threading.Event().wait(float(sys.argv[1]))
