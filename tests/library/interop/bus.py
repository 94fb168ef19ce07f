"""`objdict bus` and a node of python-canopen: a serial adapter (SLCAN) between them, on a pseudo-terminal."""

import os
import signal
import subprocess
import sys
import threading
import time

import can
import canopen

program, description, folder = sys.argv[1:4]


class Adapter(threading.Thread):
    """What is between a serial port and a bus."""

    def __init__(self, channel):
        super().__init__(daemon=True)
        self.master, slave = os.openpty()
        os.set_blocking(self.master, True)
        import tty

        tty.setraw(self.master)
        tty.setraw(slave)
        self.slave = slave  # open as long as the adapter is there
        self.name = os.ttyname(slave)
        self.bus = can.Bus(channel, interface="virtual")
        can.Notifier(self.bus, [self.receive])
        self.commands = []

    def receive(self, message):
        data = "".join(f"{byte:02X}" for byte in message.data)
        os.write(self.master, f"t{message.arbitration_id:03X}{message.dlc}{data}\r".encode())

    def run(self):
        line = b""
        while True:
            byte = os.read(self.master, 1)
            if byte != b"\r":
                line += byte
                continue
            text, line = line.decode(), b""
            if text.startswith("t"):
                data = bytes.fromhex(text[5:])
                self.bus.send(can.Message(arbitration_id=int(text[1:4], 16), data=data, is_extended_id=False))
                os.write(self.master, b"z\r")
            else:
                self.commands.append(text)
                os.write(self.master, b"\r")


network = canopen.Network()
network.connect("proof", interface="virtual")
node = network.create_node(5, description)
node.nmt.state = "PRE-OPERATIONAL"
node.nmt.start_heartbeat(100)
adapter = Adapter("proof")
adapter.start()


def objdict(*arguments, code=0):
    options = ["--bus", f"slcan:{adapter.name}@500", "--listen", "300", "--with", f"5={description}"]
    result = subprocess.run(
        [program, "bus", *arguments, *options], capture_output=True, text=True, cwd=folder, timeout=120
    )
    assert result.returncode == code, (arguments, result.stdout, result.stderr)
    return result.stdout


output = objdict("scan", "--nodes", "1-8", "--timeout", "200")
assert "pre-operational" in output and "1 node on" in output, output
assert "S6" in adapter.commands and "O" in adapter.commands, adapter.commands
assert node.sdo[0x1018][1].raw == 0x3F9
assert "0x3F9" in objdict("read", "5", "1018:1")
assert "06020000h" in objdict("read", "5", "5FFE", code=1)
objdict("write", "5", "1017=200", "--yes")
assert node.get_data(0x1017, 0) == b"\xc8\x00", node.get_data(0x1017, 0)
# a value that changes while it is read again, and the frames of this
threading.Timer(1.5, lambda: node.set_data(0x1017, 0, b"\x2c\x01")).start()
changes = objdict("read", "5", "1017", "--watch=100", "--for", "3")
assert changes.splitlines()[2:] and changes.splitlines()[-1].endswith("1017:00 Producer heartbeat time  300  300 ms"), changes
summary = objdict("watch", "--for", "2")
assert "5     drive-402" in summary, summary
frames = objdict("watch", "--frames", "--for", "1").splitlines()
assert len(frames) > 2 and all("pre-operational" in frame for frame in frames), frames
node.set_data(0x1017, 0, b"\xc8\x00")
# a value of many segments, both ways
node.set_data(0x1008, 0, b"a name of the device that is longer than any frame")
assert "longer than any frame" in objdict("read", "5", "1008")
objdict("write", "5", "2003:1=850", "--yes")
# 2033h has no value, so the node refuses it
objdict("save", "5", "-o", "saved.dcf", code=1)
saved = open(os.path.join(folder, "saved.dcf"), encoding="utf-8").read()
assert "ParameterValue=850" in saved, saved
node.set_data(0x2003, 1, b"\x01\x00")
output = objdict("apply", "5", "saved.dcf", "--verify", "--yes")
assert node.get_data(0x2003, 1) == b"\x52\x03", output
objdict("nmt", "start", "5", "--yes")
time.sleep(0.3)
assert node.nmt.state == "OPERATIONAL", node.nmt.state
objdict("apply", "5", "saved.dcf", "--yes", code=2)


def listening(port):
    arguments = [program, "bus", "read", "5", "1017", "--bus", f"slcan:{port}@500", "--listen", "20000"]
    process = subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(0.7)
    return process


# Ctrl-C closes the adapter
adapter.commands.clear()
process = listening(adapter.name)
process.send_signal(signal.SIGINT)
message = process.communicate(timeout=20)[1]
assert process.returncode == 2 and "interrupted" in message, message
time.sleep(0.2)
assert adapter.commands[-1] == "C", adapter.commands

# the adapter is unplugged
master, slave = os.openpty()
process = listening(os.ttyname(slave))
os.close(slave)
os.close(master)
message = process.communicate(timeout=20)[1]
assert process.returncode == 2 and "the adapter is lost" in message, message
print("ok")
