"""canopen for Python loads a program: `python bootloader.py PROGRAM EDS`."""

import binascii
import subprocess
import sys

import canopen

from test import Slcan, abort_of

NOT_CLEARED, TOO_LONG = 0x08000022, 0x05040005
STOP, START, CLEAR = 0, 1, 3


def by_segments(node, image):
    node.sdo.download(0x1F50, 1, image)


def by_blocks(node, image):
    with node.sdo.open(0x1F50, 1, "wb", size=len(image), block_transfer=True, buffering=7000) as stream:
        stream.write(image)


def main(program, eds):
    process = subprocess.Popen([program], stdout=subprocess.PIPE, text=True)
    host, port = process.stdout.readline().split()[-1].rsplit(":", 1)
    network = canopen.Network(Slcan((host, int(port))))
    network.connect()
    try:
        node = network.add_node(5, eds)
        node.sdo.RESPONSE_TIMEOUT = 2
        image = bytes(at * 31 % 256 for at in range(40_000))
        control, status = node.sdo[0x1F51][1], node.sdo[0x1F57][1]
        assert control.raw == 3, "no program"
        assert abort_of(by_segments, node, image) == NOT_CLEARED and status.raw == 4 << 1
        control.raw = CLEAR
        assert abort_of(by_segments, node, bytes(0x30000)) == TOO_LONG
        for load in by_segments, by_blocks:
            control.raw = CLEAR
            load(node, image)
            assert status.raw == 0
            assert node.sdo[0x1F56][1].raw == binascii.crc_hqx(image, 0), "1F56h is the CRC of the program"
            control.raw = START
            assert process.stdout.readline() == "Start 40000 bytes\n"
            assert abort_of(load, node, image) == NOT_CLEARED
            control.raw = STOP
            assert process.stdout.readline() == "Stop 40000 bytes\n"
        print("a program of 40000 bytes was loaded by segments and by blocks")
    finally:
        network.disconnect()
        process.kill()


if __name__ == "__main__":
    main(*sys.argv[1:])
