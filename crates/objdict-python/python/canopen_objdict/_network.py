"""Networks: `network.toml`, `bus.yml` of dcfgen and ros2_canopen, and node lists."""

from __future__ import annotations

import os
from typing import Literal, NamedTuple

from . import _native
from ._findings import Finding, of_document

Target = Literal["dcf", "concise", "lely", "manager", "cpj", "busyml"]


class Node(NamedTuple):
    """A node of a network."""

    name: str
    node_id: int | None


class Network:
    """The nodes of a network file, and what is built of it."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = os.fspath(path)
        nodes, findings = _native.check_network(self.path)
        self.nodes = [Node(*node) for node in nodes]
        self.findings: list[Finding] = list(of_document(findings))

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Network:
        """Reads a network file and the descriptions of its nodes."""
        return cls(path)

    def build(self, target: Target = "dcf", *, force: bool = False) -> dict[str, bytes]:
        """The files of a target by their names. The files of the network are read again.

        With errors among the findings nothing is built, unless `force` is set: `ObjdictError` lists them.
        """
        return _native.build_network(self.path, target, force)

    def __repr__(self) -> str:
        return f"<Network {self.path!r}: {len(self.nodes)} nodes>"
