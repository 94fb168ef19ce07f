"""What a description says."""

import io
import pickle
from concurrent.futures import ThreadPoolExecutor
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest

import canopen_objdict
from canopen_objdict import Device, Formula, Network, ObjdictError, decode, load


@pytest.fixture
def drive(fixtures: Path) -> Device:
    return load(fixtures / "eds/drive-402.eds", node_id=5)


def described(keys: str) -> Device:
    return load(f"[2000]\nParameterName=Value\n{keys}\n".encode(), name="value.eds")


def test_a_device_is_a_mapping(drive: Device) -> None:
    assert len(drive) == 100 and list(drive)[:2] == [0x1000, 0x1001]
    assert drive[0x1018, 1].value == 0x3F9 == drive["Identity object"]["Vendor-ID"].value
    known: list[Any] = [0x1018, (0x1018, 4), "Identity object"]
    assert all(key in drive for key in known)
    assert [entry.name for entry in drive[0x1018].values()][1] == "Vendor-ID"
    assert drive.get(0x101F) is None and drive.get((0x1018, 9)) is None
    unknown: list[Any] = [0x101F, "Identity", -1, (0x1018, 9), (0x1018, 0x100)]
    for key in unknown:
        assert key not in drive
        with pytest.raises(KeyError):
            drive[key]
    assert sum(1 for _ in drive.entries()) == sum(map(len, drive.values()))


def test_facts_of_a_device(drive: Device, fixtures: Path) -> None:
    assert (drive.format, drive.profile, drive.node_id) == ("EDS", 402, 5)
    assert drive.path == fixtures / "eds/drive-402.eds"
    assert drive.bit_rates == [10, 20, 50, 125, 250, 500, 800, 1000]
    assert drive.facts["device_info"]["product_name"] == "Servo drive SD400"
    assert drive.to_dict()["device"]["objects"]["0x1018"]["name"] == "Identity object"


def test_facts_of_an_entry(drive: Device) -> None:
    word = drive[0x6041, 0]
    assert repr(word) == "<Entry 6041h:00 'Statusword'>"
    assert (word.data_type, word.data_type_index, word.bit_length) == ("UNSIGNED16", 6, 16)
    assert (word.access, word.is_readable, word.is_writable) == ("ro", True, False)
    assert word.pdo_mapping == "optional"
    assert word.bit_names["fault"] == [3]
    meaning = word.meaning(0x237)
    assert meaning is not None and meaning.startswith("state: operation enabled")
    assert (drive["Identity object"].object_type, drive[0x6041].is_single) == ("RECORD", True)


def test_values_are_of_python() -> None:
    assert described("DataType=1\nDefaultValue=1")[0x2000].value is True
    assert described("DataType=3\nDefaultValue=0xFFFE")[0x2000].value == -2
    assert described("DataType=8\nDefaultValue=0.1")[0x2000].value == 0.1
    assert described("DataType=9\nDefaultValue=text")[0x2000].value == "text"
    assert described("DataType=0xA\nDefaultValue=01 ff")[0x2000].value == b"\x01\xff"
    assert described("DataType=5")[0x2000].value is None
    limited = described("DataType=5\nLowLimit=1\nHighLimit=9")[0x2000, 0]
    assert (limited.low_limit, limited.high_limit) == (1, 9)


def test_the_node_id_is_added_as_soon_as_it_is_known() -> None:
    text = b"[2000]\nParameterName=x\nDataType=7\nDefaultValue=$NODEID+0x200\n"
    unknown = load(text, name="x.eds")[0x2000, 0]
    assert isinstance(unknown.value, Formula) and repr(unknown.value) == "$NODEID+0x200"
    assert unknown.value.on_node(5) == 0x205
    known = load(text, 5, name="x.eds")[0x2000, 0]
    assert known.value == 0x205 and known.formula == unknown.value


def test_values_are_encoded_and_decoded(drive: Device) -> None:
    assert drive[0x6041, 0].decode(b"\x37\x02") == 0x237
    assert drive[0x6041, 0].encode(0x237) == b"\x37\x02"
    with pytest.raises(ValueError, match="1 bytes are no UNSIGNED16"):
        drive[0x6041, 0].decode(b"\x37")
    with pytest.raises(OverflowError, match="65536 does not fit UNSIGNED16"):
        drive[0x6041, 0].encode(65536)
    time = described("DataType=0xC")[0x2000, 0]
    assert time.decode(time.encode(timedelta(days=3, milliseconds=7))) == timedelta(days=3, milliseconds=7)


def test_pdos_have_names(drive: Device) -> None:
    pdo = drive.pdos[0]
    assert (pdo.name, pdo.can_id, pdo.is_valid) == ("RPDO 1", 0x205, True)
    assert pdo.mapped[0] == (0x6040, 0, 16)
    assert pdo.decode(bytes([0x0F, 0, 1])) == {"Controlword": 0x0F, "Modes of operation": 1}


def test_units_are_of_the_description_or_of_the_profile(fixtures: Path) -> None:
    device = load(fixtures / "toml/drive.toml")
    assert (device[0x2000, 0].unit, device[0x2000, 0].factor) == ("A", 0.001)
    brake = device["Brake"][0]
    assert brake.value_names == {0: "automatic", 1: "open", 2: "closed"}
    assert brake.meaning() == "automatic" and brake.meaning(2) == "closed"
    assert device[0x2012].description == "The last samples of current and position"
    assert load(fixtures / "eds/drive-402.eds")[0x6071, 0].unit is not None


def test_keys_that_python_canopen_writes_are_read() -> None:
    entry = described("DataType=4\nUnit=mm\nFactor=0.01\nDescription=A length")[0x2000, 0]
    assert (entry.unit, entry.factor, entry.description) == ("mm", 0.01, "A length")


def test_bytes_and_files_are_read_too(fixtures: Path) -> None:
    path = fixtures / "eds/io-401.eds"
    devices = [load(path), load(str(path)), load(path.read_bytes(), name="io-401.eds")]
    with open(path, "rb") as file:
        devices.append(load(file))
    devices.append(load(io.StringIO(path.read_text())))
    for device in devices:
        assert len(device) == len(devices[0]) and device[0x1018, 1].value == devices[0][0x1018, 1].value
    assert (devices[2].path, devices[3].name) == (None, str(path))


def test_variants_and_devices_are_selected(fixtures: Path) -> None:
    assert load(fixtures / "toml/family.toml", variant="io8")[0x1018, 2].value == 0x1608
    with pytest.raises(ObjdictError, match="no variant `io9`"):
        load(fixtures / "toml/family.toml", variant="io9")


def test_what_is_no_description_is_an_exception(tmp_path: Path) -> None:
    with pytest.raises(ObjdictError, match="not a file that objdict knows"):
        load(b"junk")


def test_threads_read_at_the_same_time(fixtures: Path) -> None:
    files = sorted((fixtures / "eds").glob("*.eds")) * 4
    with ThreadPoolExecutor(4) as pool:
        lengths = list(pool.map(lambda path: len(load(path)), files))
    assert lengths == [len(load(path)) for path in files]


def test_a_notebook_shows_the_card(drive: Device) -> None:
    assert "<dt>Vendor-ID</dt><dd>0x000003F9</dd>" in drive._repr_html_()
    assert repr(drive).endswith("100 objects>")


def test_the_version_is_there() -> None:
    assert canopen_objdict.__version__.count(".") == 2


def test_values_are_set_and_saved(fixtures: Path, tmp_path: Path) -> None:
    device = load(fixtures / "eds/drive-402.eds", node_id=5)
    entry = device[0x1017, 0]
    assert not device.findings
    device[0x1017].value = 1000
    assert (device[0x1017].value, entry.value, entry.is_configured, device.format) == (1000, 1000, True, "DCF")
    entry.value = 250
    device.configure({(0x1800, 2): 1, "Homing acceleration": 3}, bit_rate=500)
    assert [pdo.transmission_type for pdo in device.pdos if pdo.name == "TPDO 1"] == [1] and device.findings
    device.save(tmp_path / "node5.dcf")
    text = (tmp_path / "node5.dcf").read_text(encoding="utf-8")
    assert "; Servo drive after CiA 402" in text and "FileName=node5.dcf" in text and "NodeID=5" in text
    saved = load(tmp_path / "node5.dcf")
    assert saved == device and [finding.rule for finding in saved.findings] == ["cia301/timer-without-effect"]
    assert (saved.node_id, saved[0x1017].value, saved[0x1800, 2].value, saved[0x609A].value) == (5, 250, 1, 3)


def test_a_file_of_settings_is_applied(fixtures: Path, tmp_path: Path) -> None:
    (tmp_path / "settings.toml").write_text("node-id = 9\n[set]\n'1017' = '1s'\n", encoding="utf-8")
    device = load(fixtures / "eds/drive-402.eds")
    device.configure(file=tmp_path / "settings.toml")
    assert (device.node_id, device[0x1017].value) == (9, 1000)


def test_settings_that_are_not_possible_change_nothing(fixtures: Path) -> None:
    device = load(fixtures / "eds/drive-402.eds", node_id=5)
    copy = load(fixtures / "eds/drive-402.eds", node_id=5)
    with pytest.raises(ValueError, match="(?s)`70000` is not a valid UNSIGNED16.*no object `5555`"):
        device.configure({0x1017: 70000, 0x5555: 1, (0x1800, 2): 1})
    with pytest.raises(ValueError, match="cannot be configured"):
        device[0x1018, 1].value = 7
    with pytest.raises(TypeError, match="1018h has sub-indexes"):
        device[0x1018].value = 7
    assert device == copy and device.format == "EDS"
    with pytest.raises(ValueError, match="`node_id`, 1 to 127"):
        load(fixtures / "eds/drive-402.eds")[0x1017].value = 5


@pytest.mark.parametrize("node_id", [0, 128, -1, 256, 2**70])
def test_node_ids_are_1_to_127(fixtures: Path, node_id: int) -> None:
    device = load(fixtures / "eds/drive-402.eds")
    for use in (
        lambda: load(fixtures / "eds/drive-402.eds", node_id=node_id),
        lambda: device.convert("dcf", node_id=node_id),
        lambda: device.to_canopen(node_id),
        lambda: device.configure({}, node_id=node_id),
        lambda: canopen_objdict.decode(fixtures / "logs/drive.asc", {node_id: device}),
    ):
        with pytest.raises(ValueError, match="is not a node-ID: write a number from 1 to 127"):
            use()


def test_a_node_needs_a_node_id(fixtures: Path, tmp_path: Path) -> None:
    device = load(fixtures / "eds/drive-402.eds")
    for form in ("dcf", "xdc", "dbc"):
        with pytest.raises(ValueError, match="the node-ID is missing"):
            device.save(tmp_path / f"x.{form}")
        device.save(tmp_path / f"x.{form}", node_id=7)
    assert load(tmp_path / "x.dcf").node_id == 7
    assert b"BO_ 391 " in (tmp_path / "x.dbc").read_bytes()


def test_devices_are_compared_and_copied(fixtures: Path) -> None:
    path = fixtures / "eds/drive-402.eds"
    device = load(path, node_id=5)
    assert device == load(path.read_bytes(), node_id=5, name="other.eds")
    assert device != load(path, node_id=6) and device != load(fixtures / "eds/io-401.eds") and device != 5
    assert device[0x1018, 1] == load(path)[0x1018, 1] != device[0x1018, 2]
    assert len({device, load(path, node_id=5)}) == 1
    device[0x1017].value = 33
    for source in (device, load(fixtures / "toml/family.toml", variant="io8", node_id=4), load(fixtures / "toml/family.toml")):
        copied = pickle.loads(pickle.dumps(source))
        assert copied == source and (copied.name, copied.path, copied.node_id) == (source.name, source.path, source.node_id)


def test_what_is_missing_is_said(fixtures: Path, tmp_path: Path) -> None:
    device = load(fixtures / "eds/drive-402.eds")
    with pytest.raises(KeyError, match="drive-402.eds has no object 5555h"):
        device[0x5555]
    with pytest.raises(KeyError, match="drive-402.eds has no object 'Nothing'"):
        device["Nothing"]
    with pytest.raises(KeyError, match="1018h Identity object has no sub-index 63h"):
        device[0x1018, 99]
    assert device.get(0x5555, 7) == 7 and device.get((0x1018, 99)) is None
    with pytest.raises(FileNotFoundError) as error:
        load(tmp_path / "none.eds")
    assert error.value.filename == str(tmp_path / "none.eds")
    for missing in (
        lambda: Network.load(tmp_path / "none.toml"),
        lambda: decode(tmp_path / "none.log"),
        lambda: decode(fixtures / "logs/cell.log", tmp_path / "none.toml"),
    ):
        with pytest.raises(FileNotFoundError, match=r"none\."):
            missing()


def test_entries_are_a_table_of_pandas(fixtures: Path) -> None:
    pytest.importorskip("pandas")
    table = load(fixtures / "eds/drive-402.eds").to_dataframe()
    assert table.loc[("1018", 1), "default"] == 0x3F9 and len(table.query("pdo_mapping != 'no'")) > 10
