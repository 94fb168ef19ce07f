"""CANopen device descriptions: read, checked, converted, and as python-canopen's object dictionaries.

    device = canopen_objdict.load("drive.eds", node_id=5)
    device[0x1018, 1].value
    device["Identity object"]["Vendor-ID"].value
"""

from . import concise
from ._bus import Bus, FoundNode, Written
from ._device import Change, Device, Object, load
from ._findings import Edit, Finding, Fix, Related, check
from ._native import BusError, Entry, Formula, ObjdictError, __version__
from ._network import Network, Node
from ._pdo import Mapped, Pdo
from ._traffic import Frame, Signal, decode

__all__ = [
    "Bus",
    "BusError",
    "Change",
    "Device",
    "Edit",
    "Entry",
    "Finding",
    "Fix",
    "Formula",
    "FoundNode",
    "Frame",
    "Mapped",
    "Network",
    "Node",
    "ObjdictError",
    "Object",
    "Pdo",
    "Related",
    "Signal",
    "Written",
    "__version__",
    "check",
    "concise",
    "decode",
    "load",
]
