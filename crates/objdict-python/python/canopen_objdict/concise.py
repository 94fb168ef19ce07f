"""Concise DCF (CiA 302-3): the downloads that configure a node, as a manager stores them in 1F22h."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from . import _native


class Download(NamedTuple):
    """A value that is written into a node."""

    index: int  # type: ignore[assignment]  # hides the method of tuples
    sub: int
    data: bytes


def pack(downloads: Iterable[tuple[int, int, bytes]]) -> bytes:
    """The concise DCF of downloads, in their order."""
    return _native.pack(list(downloads))


def unpack(data: bytes) -> list[Download]:
    """The downloads of a concise DCF, in their order."""
    return [Download(*download) for download in _native.unpack(data)]
