"""Devices on a CAN bus."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Union

from . import _native
from ._device import Device

if TYPE_CHECKING:
    import can

#: A node: its device, or its node-ID.
NodeOf = Union[int, Device]

#: The commands of NMT, and the state that each leads to.
COMMANDS: Mapping[str, tuple[int, int]] = {
    "start": (1, 5),
    "stop": (2, 4),
    "pre-operational": (0x80, 0x7F),
    "reset": (0x81, 0x7F),
    "reset-communication": (0x82, 0x7F),
}

STATES = {4: "stopped", 5: "operational", 0x7F: "pre-operational"}

#: The value that 1011h takes: `load`.
LOAD = b"load"


class FoundNode(NamedTuple):
    """A node on the bus."""

    node_id: int
    #: `pre-operational`, `operational` or `stopped`; `None` if it sent no state.
    state: str | None
    #: Whether its SDO server answers.
    answers: bool
    device_type: int | None
    vendor_id: int | None
    product_code: int | None
    revision: int | None
    serial_number: int | None


class Written(NamedTuple):
    """What became of a download."""

    index: int  # type: ignore[assignment]  # hides the method of tuples
    sub: int
    data: bytes
    result: Literal["written", "differs", "refused", "unsent"]
    #: The bytes that were read back, if they differ.
    found: bytes | None
    #: The abort code, if the node refused it.
    abort: int | None


class Bus:
    """One SDO client and NMT master on a bus.

        with Bus("slcan:/dev/ttyACM0@500") as bus:
            drive = load("drive.eds", node_id=5)
            bus.write(drive, 0x1017, 1000)

    `bus` is an address as `objdict bus` takes it, or a bus of python-can, with whatever adapter that has. Nothing is asked
    before a write. `BusError` has the reason why a node or the adapter rejects something; its `abort` is the SDO abort code.
    """

    def __init__(self, bus: str | can.BusABC, *, timeout: float = 0.5, shared: bool = False) -> None:
        self._native = _native.Bus(bus, timeout, shared)

    def __enter__(self) -> Bus:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Closes the adapter; a bus of python-can stays open."""
        self._native.close()

    def listen(self, seconds: float = 1.0) -> dict[int, str | None]:
        """Listens, and returns the nodes that were heard since the bus was opened, with their states."""
        self._native.listen(seconds)
        return {node_id: _state(state) for node_id, state in self._native.states().items()}

    def scan(self, first: int = 1, last: int = 127, *, wait: float = 0.5) -> list[FoundNode]:
        """Asks these node-IDs for their identity, and waits so many seconds for answers."""
        rows = self._native.scan(first, last, wait)
        return [FoundNode(node, _state(state), answers, kind, *identity) for node, state, answers, kind, identity in rows]

    def read(self, node: NodeOf, index: int, sub: int = 0) -> Any:
        """The value of an entry: decoded if `node` is a device, otherwise its bytes."""
        data = self._native.upload(_node_id(node), index, sub)
        entry = node.entry(index, sub) if isinstance(node, Device) else None
        return data if entry is None or entry.data_type is None else entry.decode(data)

    def write(self, node: NodeOf, index: int, sub_or_value: Any, value: Any = None) -> None:
        """Writes an entry: `write(drive, 0x1017, 1000)`, `write(drive, 0x1800, 2, 254)`. Of a node-ID, values are bytes."""
        sub, value = (0, sub_or_value) if value is None else (sub_or_value, value)
        data = value
        if isinstance(node, Device):
            data = node[index, sub].encode(value)
        elif not isinstance(value, (bytes, bytearray)):
            raise TypeError("without a device, a value is bytes")
        self._native.download(_node_id(node), index, sub, bytes(data), _native_of(node))

    def save(self, device: Device, path: str | os.PathLike[str] | None = None) -> list[tuple[int, int, int]]:
        """Reads every parameter of a node into its device, and writes that to a file.

        Process data, commands and domains are left out. Returns the entries that the node does not let read, with abort codes.
        """
        refused = self._native.save(_node_id(device), device._native)
        if path is not None:
            device.save(path)
        return refused

    def apply(
        self, device: Device, *, verify: bool = True, stop: bool = True, force: bool = False
    ) -> list[Written]:
        """Writes the values of a device that differ from its defaults to the node, in an order that nodes accept.

        With `verify`, they are read back. A value whose data are in a file is `unsent`. A different device, an operational node, an enabled drive and values that can move
        something are an `ObjdictError` before anything is written, unless `force` is set. A device with SRDOs always is.
        """
        rows = self._native.apply(_node_id(device), device._native, verify, not stop, force)
        return [Written(*row) for row in rows]

    def compare(self, device: Device) -> dict[tuple[int, int], tuple[Any, Any]]:
        """The parameters of a node that differ from the values that its device states: those, and the node's.

        The node's value is `None` for an entry that it does not let read.
        """
        present = device.copy()
        refused = self._native.save(_node_id(device), present._native)
        now = {(entry.index, entry.sub): entry.value for entry in present.entries()}
        now.update({(index, sub): None for index, sub, _ in refused})
        return {
            at: (entry.value, now[at])
            for entry in device.entries()
            if entry.value is not None and now[at := (entry.index, entry.sub)] != entry.value
        }

    def restore(self, node: NodeOf, sub: int = 1) -> None:
        """Writes "load" to 1011h. Defaults are valid after the next reset."""
        self._native.download(_node_id(node), 0x1011, sub, LOAD, _native_of(node))

    def nmt(self, node: NodeOf | None, command: str, *, wait: float = 2.0) -> bool:
        """Sends `start`, `stop`, `pre-operational`, `reset` or `reset-communication` to a node, to all with `None`.

        Whether the node has sent the new state within so many seconds; of all nodes, `True`.
        """
        if command not in COMMANDS:
            raise ValueError(f"`{command}` is not a command of NMT: write one of {', '.join(COMMANDS)}")
        code, state = COMMANDS[command]
        node_id = None if node is None else _node_id(node)
        self._native.command(code, node_id)
        return node_id is None or self._native.wait_for(node_id, state, wait)


def _node_id(node: NodeOf) -> int:
    if not isinstance(node, Device):
        return node
    if node.node_id is None:
        raise ValueError(f"{node.name} has no node-ID: give `node_id` to `load`")
    return node.node_id


def _native_of(node: NodeOf) -> _native.Dictionary | None:
    return node._native if isinstance(node, Device) else None


def _state(state: int | None) -> str | None:
    return None if state is None else STATES.get(state, f"{state:02X}h")
