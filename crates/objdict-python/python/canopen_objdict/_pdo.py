"""PDOs and what they carry."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

if TYPE_CHECKING:
    from ._device import Device
    from ._native import Entry


class Mapped(NamedTuple):
    """An entry in a PDO, with its length in bits."""

    index: int  # type: ignore[assignment]  # hides the method of tuples
    sub: int
    bits: int


@dataclass(frozen=True)
class Pdo:
    """A PDO with its values after configuration; what the description does not say is `None`."""

    kind: Literal["rpdo", "tpdo"]
    number: int
    #: With its flags; `None` also if it depends on a node-ID that is unknown.
    cob_id: int | None
    is_valid: bool | None
    transmission_type: int | None
    #: In multiples of 100 µs.
    inhibit_time: int | None
    #: In milliseconds.
    event_timer: int | None
    sync_start_value: int | None
    #: In the order of the frame.
    mapped: tuple[Mapped, ...]
    _device: Device

    @property
    def can_id(self) -> int | None:
        """The identifier of its frames."""
        return None if self.cob_id is None else self.cob_id & 0x1FFFFFFF

    @property
    def name(self) -> str:
        """`TPDO 1`."""
        return f"{self.kind.upper()} {self.number}"

    def entries(self) -> list[Entry | None]:
        """The mapped entries, in the order of the frame; `None` for one that the description does not have."""
        return [self._device.entry(mapped.index, mapped.sub) for mapped in self.mapped]

    def decode(self, data: bytes) -> dict[str, Any]:
        """The values in a frame by the names of their entries, `Object.Entry` where the object has several."""
        word = int.from_bytes(data, "little")
        values: dict[str, Any] = {}
        for mapped, entry in zip(self.mapped, self.entries()):
            part = (word & ((1 << mapped.bits) - 1)).to_bytes((mapped.bits + 7) // 8, "little")
            word >>= mapped.bits
            values[self._name(mapped)] = part if entry is None else _value(entry, part)
        return values

    def _name(self, mapped: Mapped) -> str:
        target = self._device.get(mapped.index)
        if target is None or mapped.sub not in target:
            return f"{mapped.index:04X}h:{mapped.sub:02X}"
        return target[mapped.sub].name if target.is_single else f"{target.name}.{target[mapped.sub].name}"


def _value(entry: Entry, data: bytes) -> Any:
    """The value of a whole entry; of a part of one, its bytes."""
    try:
        return entry.decode(data)
    except ValueError:
        return data
