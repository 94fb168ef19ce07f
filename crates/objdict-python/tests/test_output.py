"""What is made of a description."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from canopen_objdict import Device, Network, ObjdictError, check, concise, load


def test_findings_have_places_and_fixes(fixtures: Path) -> None:
    findings = load(fixtures / "broken/c-suffix-numbers.eds").findings
    suffixes = [finding for finding in findings if finding.rule == "cia306/number-suffix"]
    found = suffixes[0]
    assert len({finding.line for finding in suffixes}) == len(suffixes) > 1
    assert (found.severity, found.line, found.column) == ("warning", 207, 14)
    assert found.path.endswith("c-suffix-numbers.eds") and str(found).startswith(f"{found.path}:207:14: warning")
    assert found.place is not None and len(found.fingerprint) == 16
    assert found.fixes[0].safety == "safe" and found.fixes[0].edits[0].line == 207


def test_the_command_finds_the_same(fixtures: Path, tmp_path: Path) -> None:
    command = shutil.which("objdict", path=str(Path(sys.executable).parent))
    if command is None:
        pytest.skip("the command is not installed")
    eds = (fixtures / "eds/io-401.eds").read_text("utf-8")
    (tmp_path / "io-401.eds").write_text(eds, "utf-8")
    node = eds.replace("[FileInfo]", "[FileInfo]\nLastEDS=io-401.eds").replace("DataType=0x0007", "DataType=0x0006", 1)
    (tmp_path / "node.dcf").write_text(node + "\n[DeviceComissioning]\nNodeID=5\nBaudrate=250\n", "utf-8")
    lamp = 'format = "objdict-device/1"\nprofile = "301@1"\n[object.2000]\nname = "Level"\ntype = "u8"\n'
    (tmp_path / "lamp.toml").write_text(lamp + "[variant.bright.object.2000]\ndefault = 300\n", "utf-8")
    for name in ["io-401.eds", "node.dcf", "lamp.toml"]:
        run = subprocess.run([command, "check", "--format", "json", name], cwd=tmp_path, capture_output=True, text=True)
        rows = [(row["rule"], row["line"]) for row in json.loads(run.stdout)["findings"]]
        assert [(finding.rule, finding.line) for finding in check(tmp_path / name)] == rows, name
        assert rows or name == "io-401.eds"
    of_node = load(tmp_path / "node.dcf").findings
    assert any(finding.rule == "configuration/different-type" for finding in of_node)


def test_healthy_fixtures_have_no_error(fixtures: Path) -> None:
    assert [str(finding) for finding in check(fixtures / "eds") if finding.severity == "error"] == []
    assert len(check([fixtures / "broken"])) > 100


def test_the_nearest_configuration_counts(fixtures: Path, tmp_path: Path) -> None:
    path = tmp_path / "bad.eds"
    path.write_bytes((fixtures / "broken/c-suffix-numbers.eds").read_bytes())
    assert any(finding.rule == "cia306/number-suffix" for finding in load(path).findings)
    (tmp_path / "objdict.toml").write_text('[rules]\n"cia306/number-suffix" = "off"\n')
    assert all(finding.rule != "cia306/number-suffix" for finding in load(path).findings)
    assert all(finding.rule != "cia306/number-suffix" for finding in check(path))


def test_patches_are_applied(fixtures: Path, tmp_path: Path) -> None:
    path, patch = tmp_path / "io.eds", tmp_path / "io.patch.toml"
    path.write_bytes((fixtures / "eds/io-401.eds").read_bytes())
    patch.write_bytes((fixtures / "patches/io-401.patch.toml").read_bytes())
    assert load(path)[0x6401, 1].unit != "V"
    assert load(path, patches=[patch])[0x6401, 1].unit == "V"
    assert load(path.read_bytes(), patches=[patch])[0x6401, 1].data_type == "UNSIGNED16"
    (tmp_path / "objdict.toml").write_text('patches = ["*.patch.toml"]\n')
    assert load(path)[0x6401, 1].data_type == "UNSIGNED16"
    (tmp_path / "network.toml").write_text('[bus]\nbit-rate = 125\n\n[node.io]\nfile = "io.eds"\nid = 5\n')
    built = Network.load(tmp_path / "network.toml").build(force=True)
    assert load(built["io.dcf"], name="io.dcf")[0x6401, 1].data_type == "UNSIGNED16"
    (tmp_path / "objdict.toml").write_text('patches = ["nothing.toml"]\n')
    assert [finding.rule for finding in check(path) if finding.path.endswith("objdict.toml")] == ["objdict/invalid-setting"]


@pytest.mark.parametrize("to", ["eds", "dcf", "xdd", "xdc", "toml", "json"])
def test_a_converted_device_is_the_same(fixtures: Path, to: str) -> None:
    drive = load(fixtures / "eds/drive-402.eds")
    converted = load(drive.convert(to, node_id=5, bit_rate=500), name=f"drive.{to}")
    # a node has what its type does not have
    added = {"change/data-changed", "change/node-fact-changed"} if to in ("dcf", "xdc") else set()
    assert {change.rule for change in converted.diff(drive)} == added
    assert [entry.name for entry in converted.entries()] == [entry.name for entry in drive.entries()]


def test_xdd_is_read_and_written(fixtures: Path, tmp_path: Path) -> None:
    device = load(fixtures / "xdd/press-402.xdd")
    assert device.format == "XDD"
    device.save(tmp_path / "other.eds")
    assert load(tmp_path / "other.eds").facts["file_info"]["file_name"] == "other.eds"
    assert any(loss.startswith("embedded: ") for loss in device.losses("eds"))
    assert all(not loss.startswith("embedded: ") for loss in device.losses("eds", embed=False))


def test_unknown_formats_and_targets_are_exceptions(fixtures: Path) -> None:
    device = load(fixtures / "eds/minimal.eds")
    for failing in (lambda: device.convert("pdf"), lambda: device.generate("cobol"), lambda: device.docs("pdf")):
        with pytest.raises(ObjdictError, match="pdf|cobol"):
            failing()


def test_code_and_pages_are_texts(fixtures: Path) -> None:
    device = load(fixtures / "eds/drive-402.eds", node_id=5)
    assert {"od.c", "od.h"} <= set(device.generate("c"))
    assert list(device.generate("rust")) == ["od.rs"]
    assert device.docs().startswith("<!DOCTYPE html>") and "| Index" in device.docs("md")
    assert "Geräte" in device.docs(language="de")


def test_changes_have_verdicts(fixtures: Path) -> None:
    text = (fixtures / "eds/io-401.eds").read_bytes()
    old, new = load(text, name="a.eds"), load(text.replace(b"[1017]", b"[2FFF]"), name="b.eds")
    removed = next(change for change in old.diff(new) if change.index == 0x1017)
    assert removed.verdict == "breaking" and "1017h" in removed.message
    assert old.diff(old) == []


def test_concise_dcf_is_packed_and_unpacked(fixtures: Path) -> None:
    downloads = [(0x1017, 0, b"\xe8\x03"), (0x6200, 1, b"\xff")]
    stream = concise.pack(downloads)
    assert concise.unpack(stream) == downloads and concise.unpack(stream)[0].data == b"\xe8\x03"
    with pytest.raises(ObjdictError):
        concise.unpack(stream[:-1])
    text = b"[DeviceComissioning]\nNodeID=5\n[1017]\nParameterName=Heartbeat\nDataType=6\nAccessType=rw\nParameterValue=7\n"
    assert concise.unpack(load(text, name="a.dcf").convert("cdcf")) == [(0x1017, 0, b"\x07\x00")]


def test_networks_are_built(fixtures: Path) -> None:
    network = Network.load(fixtures / "network/line.toml")
    assert network.nodes[0] == ("left", 11) and network.findings == []
    files = network.build()
    assert sorted(files) == ["left.dcf", "plc.dcf", "right.dcf", "servo.dcf"]
    assert load(files["left.dcf"], name="left.dcf").node_id == 11
    assert "left.cdcf" in network.build("concise")


def test_a_network_with_errors_is_not_built(fixtures: Path, tmp_path: Path) -> None:
    path = tmp_path / "network.toml"
    path.write_text('[network]\nbit-rate = 500\n\n[node.a]\nid = 5\nfile = "missing.eds"\n')
    network = Network.load(path)
    assert any(finding.severity == "error" for finding in network.findings)
    with pytest.raises(ObjdictError, match="network.toml:"):
        network.build()


def test_a_device_is_made_of_objects(tmp_path: Path) -> None:
    made = Device.new(
        401,
        device={"vendor_name": "Example", "vendor_number": 0x3F9, "product_name": "Lamp", "product_number": 7,
                "revision_number": 1, "bit_rates": [125, 500]},
        features={"digital_outputs": 8},
        object={
            0x2000: {"name": "Brightness", "type": "u8", "default": 50, "max": 100, "unit": "%"},
            0x2001: {"name": "Colour", "sub": {n: {"name": name, "type": "u16"} for n, name in enumerate("abcdefghij", 1)}},
        },
    )
    assert made[0x1018, 1].value == 0x3F9 and made[0x6200].object_type == "ARRAY"
    assert (made["Brightness"].value, made[0x2000, 0].unit, made[0x2001, 10].name) == (50, "%", "j")
    made.save(tmp_path / "lamp.eds")
    written = load(tmp_path / "lamp.eds")
    assert written.diff(made) == [] and [f for f in written.findings if f.severity == "error"] == []


def test_mistakes_in_a_new_device_are_exceptions() -> None:
    with pytest.raises(ObjdictError, match="error keys/wrong-type: `default` is `300`"):
        Device.new(object={0x2000: {"name": "x", "type": "u8", "default": 300}})
    with pytest.raises(ObjdictError, match="399"):
        Device.new(399)
