"""The traffic of a bus, read from logs."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Union

from . import _native
from ._device import Device, Source, content_of, load
from ._network import Network

#: What describes nodes: a network, a device, or the path of one of them.
Description = Union[str, "os.PathLike[str]", Device, Network]


@dataclass(frozen=True)
class Signal:
    """A value in a PDO."""

    index: int
    sub: int
    #: The name of the entry; empty if no description has it.
    name: str
    #: `None` if the frame is too short. Without a type it is the number of its bits.
    value: int | float | str | None
    #: The number in its unit, where it is another one.
    scaled: float | None
    unit: str
    #: The meaning of the value.
    text: str


@dataclass(frozen=True)
class Frame:
    """A frame: what it is, and what it says. The fields are those of `objdict decode --format json`."""

    #: When it was seen, in seconds.
    time: float
    #: The name of the channel; empty if the log has none.
    channel: str
    can_id: int
    #: Whether the CAN-ID has 29 bits.
    extended: bool
    #: nmt, sync, time, emcy, pdo, sdo, heartbeat, boot-up, guarding, lss or unknown.
    kind: str
    #: The node that sends it or, of NMT commands, SDO requests and RPDOs, that it is for.
    node: int | None
    #: `TPDO 1`; `None` for a CAN-ID that no node uses.
    service: str | None
    data: bytes
    remote: bool
    error: bool
    #: The meaning of the frame.
    text: str
    #: The entry that an SDO transfer is about.
    index: int | None
    sub: int | None
    #: The value of a transfer that is complete with this frame, its bytes, and the abort code.
    value: int | float | str | None
    transferred: bytes | None
    abort: int | None
    signals: tuple[Signal, ...]


def decode(
    logs: Source | Iterable[Source],
    nodes: Description | Iterable[Description] | Mapping[int, str | os.PathLike[str] | Device] = (),
) -> Iterator[Frame]:
    """The frames of logs, in the order of their times: candump, ASC, TRC, CSV of python-can, pcap and pcapng.

    `nodes` says what describes them: networks, devices, or a mapping of node-IDs to devices. A device without a node-ID is for
    the node that it fits, which is found in the logs. Lines that are not understood are a warning at the end.
    """
    sources = [_source(log) for log in _listed(logs)]
    networks: list[str] = []
    devices: list[tuple[int | None, _native.Dictionary]] = []
    if isinstance(nodes, Mapping) and not isinstance(nodes, Device):
        of_nodes: Mapping[int, Any] = nodes
        for node_id, device in of_nodes.items():
            described = device if isinstance(device, Device) else load(device, node_id)
            devices.append((node_id, described._native))
    else:
        for node in [nodes] if isinstance(nodes, (str, os.PathLike, Device, Network)) else nodes:
            if isinstance(node, Network):
                networks.append(node.path)
            elif isinstance(node, Device):
                devices.append((None, node._native))
            elif _native.is_network(os.fspath(node)):
                networks.append(os.fspath(node))
            else:
                devices.append((None, load(node)._native))
    return _frames(_native.decode(sources, networks, devices))


def _listed(logs: Source | Iterable[Source]) -> list[Any]:
    """One log as a list: bytes and files could be iterated over too."""
    is_one = isinstance(logs, (str, os.PathLike, bytes, bytearray, memoryview)) or hasattr(logs, "read")
    several: list[Any] = [logs] if is_one else list(logs)  # type: ignore[arg-type]
    return several


def _source(log: Any) -> tuple[str, bytes | None]:
    if isinstance(log, (str, os.PathLike)):
        # a missing file is an OSError here, not when the first frame is asked for
        os.stat(log)
        return os.fspath(log), None
    name, content = content_of(log)
    return name or "<bytes>", content


def _frames(native: _native.Frames) -> Iterator[Frame]:
    while True:
        lines, is_end = native.next()
        if is_end:
            for line in lines:
                warnings.warn(line, stacklevel=2)
            return
        yield from map(_frame, lines)


def _frame(line: str) -> Frame:
    row = json.loads(line)
    transferred = row.get("bytes")
    return Frame(
        time=row["time"],
        channel=row.get("channel", ""),
        can_id=row["can_id"],
        extended=row["extended"],
        kind=row["kind"],
        node=row.get("node"),
        service=row.get("service"),
        data=bytes.fromhex(row["data"]),
        remote=row.get("remote", False),
        error=row.get("error", False),
        text=row["text"],
        index=row.get("index"),
        sub=row.get("sub"),
        value=row.get("value"),
        transferred=None if transferred is None else bytes.fromhex(transferred),
        abort=row.get("abort"),
        signals=tuple(_signal(signal) for signal in row.get("signals") or ()),
    )


def _signal(row: dict[str, Any]) -> Signal:
    scaled = row.get("scaled")
    return Signal(
        index=row["index"],
        sub=row["sub"],
        name=row["name"],
        value=row.get("value"),
        scaled=None if scaled is None else float(scaled),
        unit=row.get("unit", ""),
        text=row["text"],
    )
