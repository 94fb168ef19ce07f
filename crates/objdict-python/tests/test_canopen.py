"""Devices as object dictionaries of python-canopen."""

from pathlib import Path
from typing import Any

import pytest

import canopen_objdict
from canopen_objdict import Device, ObjdictError, load

from conftest import FIXTURES

canopen: Any = pytest.importorskip("canopen")

FOLDERS = ["eds", "dcf", "xdd", "xdc", "toml", "broken", "canopennode", "cnxml", "objdictgen", "errata", "torture"]
FILES = [path for folder in FOLDERS for path in sorted((FIXTURES / folder).rglob("*")) if path.is_file()]


def served(od: Any) -> int:
    """How many entries python-canopen's LocalNode serves; it must serve each that has a value."""
    node = canopen.LocalNode(5, od)
    count = 0
    for index in od:
        item = od[index]
        for variable in [item] if isinstance(item, canopen.objectdictionary.ODVariable) else item.values():
            if variable.value is None and variable.default is None:
                continue
            data = node.get_data(index, variable.subindex)
            assert isinstance(bytes(data), bytes)
            count += 1
    return count


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(FIXTURES)))
def test_what_objdict_reads_is_served(path: Path) -> None:
    try:
        device = load(path)
    except ObjdictError as error:
        # some fixtures are no descriptions
        assert str(error)
        return
    od = device.to_canopen(5)
    objects = [item for item in device.values() if item.object_type != "DEFTYPE"]
    assert all(item.index in od for item in objects)
    served(od)


@pytest.mark.parametrize("name", ["drive-402.eds", "io-401.eds", "encoder-406.eds", "minimal.eds"])
def test_both_readers_see_the_same(fixtures: Path, name: str) -> None:
    path = str(fixtures / "eds" / name)
    theirs = canopen.import_od(path, 5)
    ours = load(path, 5).to_canopen()
    assert list(ours) == list(theirs)
    # their reader takes the granularity as a truth value
    theirs.device_information.granularity = ours.device_information.granularity
    assert vars(ours.device_information) == vars(theirs.device_information)
    assert (ours.comments, ours.node_id, ours.bitrate) == (theirs.comments, theirs.node_id or 5, theirs.bitrate)
    for index in theirs:
        pairs = [(ours[index], theirs[index])]
        if not isinstance(theirs[index], canopen.objectdictionary.ODVariable):
            assert list(ours[index]) == list(theirs[index])
            pairs = [(ours[index][sub], theirs[index][sub]) for sub in theirs[index]]
        for our, their in pairs:
            for attribute in ("name", "data_type", "access_type", "pdo_mappable", "relative"):
                assert getattr(our, attribute) == getattr(their, attribute), (our, attribute)
            # their reader has no limits of REAL
            assert their.min in (our.min, None) and their.max in (our.max, None), our
            assert our.default == their.default or their.data_type in (1, 9), our
            assert (our.default is None) == (their.default is None), our


def test_a_file_that_python_canopen_refuses_comes_through() -> None:
    text = b"[2000]\nParameterName=A\nDataType=0x0007\nAccessType=rw\nDefaultValue=12 ; twelve\n[2000sub1]\n[2001]\nParameterName=B\n"
    device = load(text, name="a.eds")
    od = device.to_canopen()
    assert od[0x2000].default == 12 and od["B"].data_type == canopen.objectdictionary.DOMAIN


def test_a_pdo_without_a_mapping_parameter_is_served() -> None:
    text = b"[1800]\nParameterName=TPDO\nObjectType=9\nSubNumber=1\n[1800sub0]\nParameterName=n\nDataType=5\nDefaultValue=0\n"
    assert served(load(text, name="a.eds").to_canopen(5)) == 1


def test_names_units_and_bits_come_with_it(fixtures: Path) -> None:
    od = load(fixtures / "toml/drive.toml").to_canopen()
    assert (od[0x2000].unit, od[0x2000].factor) == ("A", 0.001)
    assert od["Brake"].decode_desc(1) == "open"
    assert od["Inputs"].decode_bits(0b10, "limit switch +") == 1
    assert od["Inputs"].bit_definitions["code"] == [4, 5, 6, 7]


def test_texts_that_are_not_ascii_are_served() -> None:
    text = "[2000]\nParameterName=A\nDataType=9\nAccessType=ro\nDefaultValue=Grüße\n".encode("latin-1")
    od = load(text, name="a.eds").to_canopen(5)
    assert canopen.LocalNode(5, od).get_data(0x2000, 0) == load(text, name="a.eds")[0x2000, 0].encode("Grüße")


def test_a_remote_node_takes_it(fixtures: Path) -> None:
    node = canopen.RemoteNode(5, load(fixtures / "eds/drive-402.eds", 5).to_canopen())
    assert node.object_dictionary["Statusword"].pdo_mappable
    assert node.tpdo[1] is not None


@pytest.mark.parametrize("name", ["drive-402.eds", "io-401.eds", "encoder-406.eds"])
def test_an_object_dictionary_becomes_an_eds(fixtures: Path, tmp_path: Path, name: str) -> None:
    """What python-canopen's pull request 254 is about."""
    original = load(fixtures / "eds" / name)
    again = Device.from_canopen(original.to_canopen())
    changes = {change.rule for change in original.diff(again)}
    # python-canopen has no place for flags, limits of types, object types and versions, and the units of the profile came with the dictionary
    assert changes <= {
        "change/data-changed",
        "change/flags-changed",
        "change/object-type-changed",
        "change/unit-stated",
        "change/file-version-not-raised",
        "change/revision-not-raised",
    }
    again.save(tmp_path / name)
    assert canopen.import_od(str(tmp_path / name), 5)[0x1018][1].default == original[0x1018, 1].value


def test_an_object_dictionary_is_made_in_python(tmp_path: Path) -> None:
    od = canopen.ObjectDictionary()
    speed = canopen.objectdictionary.ODVariable("Speed", 0x2000)
    speed.data_type, speed.default, speed.unit, speed.factor = canopen.objectdictionary.UNSIGNED16, 7, "rpm", 0.1
    od.add_object(speed)
    device = Device.from_canopen(od)
    device.save(tmp_path / "speed.eds")
    entry = canopen_objdict.load(tmp_path / "speed.eds")["Speed"][0]
    assert (entry.value, entry.data_type, entry.unit, entry.factor) == (7, "UNSIGNED16", "rpm", 0.1)
