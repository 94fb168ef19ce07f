"""Devices on a bus: simulated nodes of objdict, and nodes of python-canopen behind python-can."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from canopen_objdict import Bus, BusError, ObjdictError, load


@pytest.fixture
def simulated(fixtures: Path) -> Iterator[Bus]:
    with Bus(f"sim:{fixtures / 'bus/cell.toml'}") as bus:
        yield bus


def test_nodes_are_found(simulated: Bus) -> None:
    found = {node.node_id: node for node in simulated.scan(1, 20)}
    assert {node_id for node_id, node in found.items() if node.answers} == {5, 6}
    assert (found[5].vendor_id, found[5].device_type) == (0x3F9, 0x20192)
    assert found[5].state in (None, "pre-operational")


def test_values_are_read_written_saved_and_applied(simulated: Bus, fixtures: Path, tmp_path: Path) -> None:
    drive = load(fixtures / "eds/drive-402.eds", node_id=5)
    simulated.write(drive, 0x1017, 250)
    simulated.write(drive, 0x1800, 5, 70)
    assert simulated.read(drive, 0x1017) == 250 and simulated.read(5, 0x1017) == b"\xfa\x00"
    assert simulated.compare(drive) == {(0x1017, 0): (500, 250), (0x1800, 5): (drive[0x1800, 5].value, 70)}
    assert simulated.save(drive, tmp_path / "now.dcf") == []
    saved = load(tmp_path / "now.dcf")
    assert (saved[0x1017].value, saved[0x1800, 5].value, saved[0x6040].value) == (250, 70, 0)
    assert simulated.compare(saved) == {}
    saved[0x1017].value = 750
    written = {(row.index, row.sub): row.result for row in simulated.apply(saved)}
    assert written[0x1017, 0] == "written" and simulated.read(saved, 0x1017) == 750


def test_what_a_node_refuses_is_an_exception(simulated: Bus, fixtures: Path) -> None:
    drive = load(fixtures / "eds/drive-402.eds", node_id=5)
    with pytest.raises(BusError, match="1018h") as refused:
        simulated.write(5, 0x1018, 1, b"\0\0\0\0")
    assert refused.value.abort == 0x06010002
    with pytest.raises(BusError, match="node 9 does not respond") as silent:
        simulated.read(9, 0x1000)
    assert silent.value.abort is None
    drive[0x6040].value = 6
    with pytest.raises(ObjdictError, match="6040h sub-index 0 is no parameter"):
        simulated.apply(drive)
    with pytest.raises(ValueError, match="not a command of NMT"):
        simulated.nmt(5, "boot")
    with pytest.raises(ValueError, match="not a node-ID"):
        simulated.read(128, 0x1000)
    with pytest.raises(TypeError, match="a value is bytes"):
        simulated.write(5, 0x1017, 250)


def test_a_node_that_is_operational_is_not_configured(simulated: Bus, fixtures: Path) -> None:
    drive = load(fixtures / "eds/drive-402.eds", node_id=5)
    drive.configure({0x1017: 100})
    assert simulated.nmt(drive, "start")
    with pytest.raises(ObjdictError, match="node 5 is not configured: it is operational"):
        simulated.apply(drive)
    assert simulated.listen(1.0)[5] == "operational"
    assert [row.result for row in simulated.apply(drive, force=True)] == ["written"]


def test_nothing_overrides_srdos_and_another_device_is_rejected(simulated: Bus, fixtures: Path) -> None:
    safe = load(fixtures / "bases/srdo.eds", node_id=5)
    with pytest.raises(ObjdictError, match="node 5 is not the described device"):
        simulated.apply(safe)
    with pytest.raises(ObjdictError, match="part of a safety function"):
        simulated.apply(safe, force=True)
    with pytest.raises(ObjdictError, match="part of a safety function"):
        simulated.write(safe, 0x1017, 250)


def test_addresses_and_closed_buses_are_exceptions(fixtures: Path) -> None:
    with pytest.raises(ObjdictError, match="`can0` is not the address of a bus"):
        Bus("can0")
    with pytest.raises(ObjdictError, match="cannot open `/dev/none`"):
        Bus("slcan:/dev/none@500")
    bus = Bus(f"sim:{fixtures / 'bus/cell.toml'}")
    bus.close()
    with pytest.raises(ObjdictError, match="the bus is closed"):
        bus.read(5, 0x1000)


def test_buses_of_python_can_have_nodes_of_python_canopen(fixtures: Path, tmp_path: Path) -> None:
    can: Any = pytest.importorskip("can")
    canopen: Any = pytest.importorskip("canopen")
    network = canopen.Network()
    network.connect(interface="virtual", channel="objdict-tests")
    device = load(fixtures / "eds/drive-402.eds", node_id=5)
    network.create_node(5, device.to_canopen())
    try:
        with can.Bus(interface="virtual", channel="objdict-tests") as adapter, Bus(adapter, timeout=2.0) as bus:
            assert [node.node_id for node in bus.scan(4, 6) if node.answers] == [5]
            bus.write(device, 0x1017, 1234)
            assert bus.read(device, 0x1017) == 1234
            bus.save(device, tmp_path / "now.dcf")
            with pytest.raises(BusError) as refused:
                bus.read(5, 0x5FFF)
            assert refused.value.abort == 0x06020000
    finally:
        network.disconnect()
    assert load(tmp_path / "now.dcf")[0x1017].value == 1234
