"""Writes a log with the writers of python-can, and reads it with its readers.

usage: logs.py FRAMES OUT FOLDER

FRAMES is a log of `candump -l`. Writes `log.asc`, `log.blf`, `log.mf4`, `log.trc`, `log.csv` and `log.log` into FOLDER and prints what python-can reads of each as
JSON in OUT: for each file a list of [time in microseconds, CAN-ID, extended, remote, error, data in hex].
"""

import json
import pathlib
import sys

import can


def row(message, start):
    data = "" if message.is_remote_frame or message.is_error_frame else bytes(message.data).hex().upper()
    can_id = 0 if message.is_error_frame else message.arbitration_id
    time = round((message.timestamp - start) * 1e6)
    extended = message.is_extended_id and not message.is_error_frame
    return [time, can_id, extended, message.is_remote_frame, message.is_error_frame, data]


def main():
    frames, out, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    with can.LogReader(frames) as reader:
        messages = list(reader)
    # a remote frame, an extended one, an error frame and frames of CAN FD
    last = messages[-1].timestamp
    for number, more in enumerate([
        {"arbitration_id": 0x705, "is_extended_id": False, "is_remote_frame": True, "dlc": 1},
        {"arbitration_id": 0x18FEEE05, "data": [1, 2, 3]},
        {"is_error_frame": True, "is_extended_id": False},
        {"arbitration_id": 0x185, "is_extended_id": False, "is_fd": True, "data": list(range(12))},
        {"arbitration_id": 0x185, "is_extended_id": False, "is_fd": True, "data": list(range(64))},
        {"arbitration_id": 0x185, "is_extended_id": False, "data": []},
    ]):
        messages.append(can.Message(timestamp=last + 0.001 * (number + 1), channel=messages[0].channel, **more))
    read = {}
    for name in ["log.asc", "log.blf", "log.mf4", "log.trc", "log.csv", "log.log"]:
        # TRC of python-can has neither error frames nor CAN FD
        taken = [m for m in messages if name != "log.trc" or not (m.is_error_frame or m.is_fd or m.is_remote_frame)]
        path = folder / name
        with can.Logger(str(path)) as writer:
            for message in taken:
                writer(message)
        with can.LogReader(str(path)) as reader:
            again = list(reader)
        start = again[0].timestamp
        read[name] = [row(message, start) for message in again]
    out.write_text(json.dumps(read))


main()
