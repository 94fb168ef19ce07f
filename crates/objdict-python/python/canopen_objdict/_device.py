"""Devices and their objects."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, Generic, NamedTuple, TextIO, TypeVar, Union, overload

from . import _native
from ._findings import Finding, of_document
from ._native import Entry, ObjdictError
from ._new import Table, source_of
from ._pdo import Mapped, Pdo

if TYPE_CHECKING:
    import canopen
    import pandas

#: The columns of a table of entries.
COLUMNS = (
    "name", "data_type", "access", "pdo_mapping", "default", "value", "low_limit", "high_limit", "unit", "factor", "description"
)

#: What `load` takes: a path, the bytes of a file, or a file object.
Source = Union[str, "os.PathLike[str]", bytes, bytearray, memoryview, BinaryIO, TextIO]


class Change(NamedTuple):
    """What changes from one device to another."""

    rule: str
    index: int | None  # type: ignore[assignment]  # hides the method of tuples
    sub: int | None
    old: str | None
    new: str | None
    #: The worst that it means for a user of the device: `compatible`, `risky` or `breaking`.
    verdict: str
    message: str


T = TypeVar("T")


class _until_set(Generic[T]):
    """A property that is computed when it is asked for, and again after values were set."""

    def __init__(self, compute: Callable[[Device], T]) -> None:
        self._compute = compute
        self.__doc__ = compute.__doc__

    @overload
    def __get__(self, device: None, owner: type[Device]) -> _until_set[T]: ...
    @overload
    def __get__(self, device: Device, owner: type[Device]) -> T: ...
    def __get__(self, device: Device | None, owner: type[Device]) -> T | _until_set[T]:
        if device is None:
            return self
        revision = device._native.revision
        kept: tuple[int, T] | None = device._kept.get(self._compute.__name__)
        if kept is None or kept[0] != revision:
            kept = device._kept[self._compute.__name__] = revision, self._compute(device)
        return kept[1]


def load(
    source: Source,
    node_id: int | None = None,
    *,
    name: str | None = None,
    device: int | None = None,
    variant: str | None = None,
    patches: Iterable[str | os.PathLike[str]] = (),
) -> Device:
    """Reads a description: EDS, DCF, XDD, XDC, a project of CANopenNode or objdictgen, `device.toml` or JSON.

    `name` is what findings call bytes and file objects. Of a file with several devices, `device` says which one, counted
    from 1; `variant` is one of a `device.toml`. A file is read with the patches that the nearest `objdict.toml` names, and with
    `patches`.
    """
    patched = [os.fspath(path) for path in patches]
    if isinstance(source, (str, os.PathLike)):
        return Device(_native.open(os.fspath(source), node_id, device, variant, patched))
    stated, content = content_of(source)
    return Device(_native.read(content, name or stated or "<bytes>", (node_id, device, variant), patched))


def content_of(source: bytes | bytearray | memoryview | BinaryIO | TextIO) -> tuple[str | None, bytes]:
    """The name of a file object, and what is in it."""
    if isinstance(source, (bytes, bytearray, memoryview)):
        return None, bytes(source)
    name, content = getattr(source, "name", None), source.read()
    return name if isinstance(name, str) else None, content.encode() if isinstance(content, str) else bytes(content)


def _copy(
    content: bytes, name: str, node_id: int | None, device: int | None, variant: str | None, path: str | None
) -> Device:
    """A copied device."""
    return Device(_native.read(content, name, (node_id, device, variant), [], path))


def _name_of(key: int | str | tuple[int, int]) -> str:
    """The key of a setting as objdict names an entry."""
    if isinstance(key, tuple):
        return f"{key[0]:04X}:{key[1]:X}"
    return key if isinstance(key, str) else f"{key:04X}"


class Object(Mapping[int, Entry]):
    """An object: its entries by sub-index, and by name."""

    def __init__(self, native: _native.Object) -> None:
        self._native = native

    @property
    def index(self) -> int:
        return self._native.index

    @property
    def name(self) -> str:
        return self._native.name

    @property
    def object_type(self) -> str:
        """`VAR`, `ARRAY`, `RECORD`, `DOMAIN`, `DEFTYPE` or `DEFSTRUCT`."""
        return self._native.object_type

    @property
    def description(self) -> str | None:
        return self._native.description

    @property
    def is_single(self) -> bool:
        """Whether the object is one value."""
        return self.object_type not in ("ARRAY", "RECORD", "DEFSTRUCT")

    @property
    def value(self) -> Any:
        """The value of an object that is one: that of sub-index 0. Set, it is the one that the node is configured with."""
        return self[0].value

    @value.setter
    def value(self, value: Any) -> None:
        if not self.is_single:
            raise TypeError(f"{self.index:04X}h has sub-indexes: set the value of one of them")
        self[0].value = value

    @cached_property
    def _subs(self) -> dict[str, int]:
        return {name: sub for name, sub in reversed(self._native.names())}

    def __getitem__(self, key: int | str) -> Entry:
        sub = self._subs.get(key) if isinstance(key, str) else key
        entry = self._native.entry(sub) if sub is not None and 0 <= sub <= 0xFF else None
        if entry is None:
            what = f"sub-index {key:02X}h" if isinstance(key, int) and key >= 0 else f"entry {key!r}"
            raise KeyError(f"{self.index:04X}h {self.name} has no {what}")
        return entry

    def __contains__(self, key: object) -> bool:
        if isinstance(key, str):
            return key in self._subs
        return isinstance(key, int) and 0 <= key <= 0xFF and self._native.has(key)

    def __iter__(self) -> Iterator[int]:
        return iter(self._native.subs())

    def __len__(self) -> int:
        return len(self._native.subs())

    def __repr__(self) -> str:
        return f"<Object {self.index:04X}h {self.name!r}>"


class Device(Mapping[int, Object]):
    """A device: its objects by index, and by name; its entries by index and sub-index."""

    def __init__(self, native: _native.Dictionary) -> None:
        self._native = native
        self._kept: dict[str, Any] = {}

    @classmethod
    def new(cls, profile: int = 301, node_id: int | None = None, **tables: Table) -> Device:
        """A new device of a profile, of the tables of `device.toml`: `device`, `features`, `object`, `tpdo` ….

        Numbers as keys of `object` are indexes. `ObjdictError` lists the errors of the device.
        """
        made = load(source_of(profile, tables).encode(), node_id, name="device.toml")
        errors = _native.errors(made._native)
        if errors:
            raise ObjdictError(errors.rstrip())
        return made

    @classmethod
    def from_canopen(cls, od: canopen.ObjectDictionary) -> Device:
        """The device of an object dictionary of python-canopen."""
        from ._canopen import tables_of

        return load(source_of(None, tables_of(od)).encode(), od.node_id, name="device.toml")

    @property
    def name(self) -> str:
        """The name of the file."""
        return self._native.name

    @property
    def path(self) -> Path | None:
        """The file; `None` of bytes."""
        return None if self._native.path is None else Path(self._native.path)

    @property
    def format(self) -> str:
        """`EDS`, `DCF`, `XDD`, `XDC`, `device.toml` or `JSON`."""
        return self._native.format

    @property
    def node_id(self) -> int | None:
        """The node-ID that `load` was given, else that of a DCF or XDC."""
        return self._native.node_id

    @property
    def profile(self) -> int | None:
        """The number of the device profile: 402."""
        return self._native.profile

    @property
    def bit_rates(self) -> list[int]:
        """The supported bit rates in kbit/s."""
        return self._native.bit_rates

    @_until_set
    def facts(self) -> dict[str, Any]:
        """`file_info`, `device_info`, `commissioning`, `comments` …, as the JSON of a device has them."""
        return dict(json.loads(self._native.facts())["device"])

    @_until_set
    def pdos(self) -> list[Pdo]:
        """The PDOs: RPDOs first, by number."""
        return [Pdo(*facts, tuple(Mapped(*one) for one in mapped), self) for facts, mapped in self._native.pdos()]

    @_until_set
    def findings(self) -> list[Finding]:
        """The findings, which are looked for when they are asked for the first time."""
        return list(of_document(_native.findings(self._native)))

    @cached_property
    def _indexes(self) -> dict[str, int]:
        return {name: index for name, index in reversed(self._native.names())}

    def entry(self, index: int, sub: int = 0) -> Entry | None:
        """An entry, if there is one."""
        return self.get((index, sub))

    def entries(self) -> Iterator[Entry]:
        """All entries, in their order."""
        for item in self.values():
            yield from item.values()

    @overload
    def __getitem__(self, key: tuple[int, int]) -> Entry: ...
    @overload
    def __getitem__(self, key: int | str) -> Object: ...
    def __getitem__(self, key: int | str | tuple[int, int]) -> Object | Entry:
        return self._object(key[0])[key[1]] if isinstance(key, tuple) else self._object(key)

    def _object(self, key: int | str) -> Object:
        index = self._indexes.get(key) if isinstance(key, str) else key
        native = self._native.object(index) if index is not None and 0 <= index <= 0xFFFF else None
        if native is None:
            what = f"object {key:04X}h" if isinstance(key, int) and key >= 0 else f"object {key!r}"
            raise KeyError(f"{Path(self.name).name} has no {what}")
        return Object(native)

    @overload
    def get(self, key: tuple[int, int]) -> Entry | None: ...
    @overload
    def get(self, key: int | str) -> Object | None: ...
    @overload
    def get(self, key: tuple[int, int], default: T) -> Entry | T: ...
    @overload
    def get(self, key: int | str, default: T) -> Object | T: ...
    def get(self, key: int | str | tuple[int, int], default: Any = None) -> Any:
        """An object or an entry, if there is one, else the default."""
        try:
            return self[key]
        except KeyError:
            return default

    def __contains__(self, key: object) -> bool:
        if isinstance(key, tuple):
            return len(key) == 2 and key[0] in self and key[1] in self._object(key[0])
        if isinstance(key, str):
            return key in self._indexes
        return isinstance(key, int) and 0 <= key <= 0xFFFF and self._native.has(key)

    def __iter__(self) -> Iterator[int]:
        return iter(self._native.indexes())

    def __len__(self) -> int:
        return len(self._native)

    def __eq__(self, other: object) -> bool:
        """Whether another device has the same content and node-ID; the file names may differ."""
        return isinstance(other, Device) and self._native.is_same(other._native)

    def __hash__(self) -> int:
        # the same for as long as the device lives, also when values are set
        return hash((self.profile, len(self)))

    def copy(self) -> Device:
        """A device of its own, with the same values."""
        return _copy(*self.__reduce__()[1])

    def __reduce__(self) -> tuple[Any, ...]:
        content, number, variant = self._native.copied()
        path = None if self.path is None else os.fspath(self.path)
        return _copy, (content, self.name, self.node_id, number, variant, path)

    def configure(
        self,
        settings: Mapping[int | str | tuple[int, int], Any] | None = None,
        *,
        file: str | os.PathLike[str] | None = None,
        node_id: int | None = None,
        bit_rate: int | None = None,
    ) -> None:
        """Sets values that the node is configured with, by index, index and sub-index, or name: all of them, or none.

        The device is then that of the node, as a DCF or XDC describes it. `file` has settings as `objdict configure` takes them.
        `ValueError` lists the settings that the description does not allow.
        """
        values = [(_name_of(key), value) for key, value in (settings or {}).items()]
        path = None if file is None else os.fspath(file)
        self._native.configure(values, path, node_id, bit_rate)

    def convert(
        self,
        to: str,
        *,
        name: str | None = None,
        node_id: int | None = None,
        bit_rate: int | None = None,
        embed: bool = True,
    ) -> bytes:
        """The description as `eds`, `dcf`, `xdd`, `xdc`, `toml`, `json`, concise DCF (`cdcf`), or the frames as `dbc`.

        `name` is the file name that the text states. What the format has no place for is embedded in it, unless `embed` is
        not set: `losses` lists it. A DCF or XDC is for the node `node_id`, at `bit_rate` kbit/s.
        """
        return self._converted(to, name, node_id, bit_rate, embed)[0]

    def losses(self, to: str, *, embed: bool = True) -> list[str]:
        """What `convert` would lose, or embed, a line each."""
        return self._converted(to, None, None, None, embed)[1]

    def _converted(
        self, to: str, name: str | None, node_id: int | None, bit_rate: int | None, embed: bool
    ) -> tuple[bytes, list[str]]:
        name = name or Path(self.name).with_suffix(f".{to}").name
        return _native.convert(self._native, to, name, node_id, bit_rate, embed)

    def save(self, path: str | os.PathLike[str], **options: Any) -> None:
        """Writes the description to a file, in the format of its ending; `options` are those of `convert`."""
        target = Path(path)
        target.write_bytes(self.convert(target.suffix[1:].lower(), **{"name": target.name, **options}))

    def generate(self, target: str) -> dict[str, str]:
        """The files that `objdict generate --target TARGET` makes, by their names."""
        return _native.generate(self._native, target)[0]

    def docs(self, form: str = "html", *, language: str | None = None) -> str:
        """The documentation as a page: `html`, `md` or `csv`."""
        return _native.docs(self._native, form, language)

    def diff(self, new: Device) -> list[Change]:
        """What changes from this device to another, as `objdict diff` judges it."""
        return [Change(*row) for row in _native.changes(self._native, new._native)]

    def to_dataframe(self) -> pandas.DataFrame:
        """A table of pandas, which must be installed: a row for each entry, by index and sub-index."""
        import pandas

        rows = [
            {"index": f"{entry.index:04X}", "sub": entry.sub, "object": self[entry.index].name}
            | {column: getattr(entry, column) for column in COLUMNS}
            for entry in self.entries()
        ]
        return pandas.DataFrame(rows, columns=["index", "sub", "object", *COLUMNS]).set_index(["index", "sub"])

    def to_dict(self) -> dict[str, Any]:
        """The whole model, as docs/reference/json.md describes it."""
        return dict(json.loads(self._native.json()))

    def to_canopen(self, node_id: int | None = None) -> canopen.ObjectDictionary:
        """The object dictionary of python-canopen, which must be installed."""
        from ._canopen import dictionary_of

        return dictionary_of(self, self.node_id if node_id is None else node_id)

    def __repr__(self) -> str:
        return f"<Device {self.name!r}: {len(self)} objects>"

    def _repr_html_(self) -> str:
        """The card at the top of the documentation, for notebooks."""
        return _native.card(self._native)
