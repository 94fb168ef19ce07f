"""The recipes of docs/guides/python.md."""

import re
import runpy
import shutil
from pathlib import Path
from typing import Any

import pytest

from canopen_objdict import load

PAGE = Path(__file__).parents[3] / "docs/guides/python.md"


def recipe(name: str, folder: Path) -> Path:
    """The program behind a comment of the page, as a file."""
    block = re.search(rf"<!-- python {name} -->\n```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert block is not None
    path = folder / f"test_{name}.py"
    path.write_text(block[1], encoding="utf-8")
    return path


def test_all_entries_of_a_node(fixtures: Path, tmp_path: Path) -> None:
    canopen: Any = pytest.importorskip("canopen")
    device = load(fixtures / "eds/drive-402.eds", node_id=5)
    node = canopen.LocalNode(5, device.to_canopen())
    rows = runpy.run_path(str(recipe("bench", tmp_path)))["rows"]
    texts = {(entry.index, entry.sub): text for entry, text in rows(device, node.get_data)}
    assert texts[0x1018, 1] == "1017"
    assert "0x060A0023" in texts[0x6041, 0] or texts[0x6041, 0]
    assert len(texts) == sum(entry.is_readable for entry in device.entries())


def test_a_test_of_the_description(fixtures: Path, tmp_path: Path, pytester: pytest.Pytester) -> None:
    recipe("ci", pytester.path)
    text = (fixtures / "eds/io-401.eds").read_bytes()
    (pytester.path / "io-401.eds").write_bytes(text)
    assert pytester.runpytest().ret == 0
    released = pytester.path / "released"
    released.mkdir()
    shutil.copy(pytester.path / "io-401.eds", released)
    (pytester.path / "io-401.eds").write_bytes(text.replace(b"[1017]", b"[2FFF]"))
    assert pytester.runpytest().ret == 1


def test_a_table(fixtures: Path, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    table = runpy.run_path(str(recipe("table", tmp_path)))["table"](fixtures / "eds/drive-402.eds")
    assert table.loc[("1018", 1), "default"] == 0x3F9
    assert len(table.query("pdo_mapping != 'no'")) > 10


def test_the_first_example(fixtures: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    page = PAGE.read_text(encoding="utf-8")
    example = re.search(r"## A device\n\n```python\n(.*?)```", page, re.DOTALL)
    assert example is not None
    monkeypatch.chdir(fixtures / "eds")
    exec(compile(example[1], "python.md", "exec"), {})


def test_the_log(fixtures: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    example = re.search(r"```python\n(for frame in .*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert example is not None
    shutil.copy(fixtures / "logs/drive.asc", tmp_path)
    shutil.copy(fixtures / "eds/drive-402.eds", tmp_path)
    monkeypatch.chdir(tmp_path)
    exec(compile("import canopen_objdict\n" + example[1], "python.md", "exec"), {})
    assert "Position actual value" in capsys.readouterr().out


def test_the_new_device(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    example = re.search(r"```python\n(lamp = .*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert example is not None
    monkeypatch.chdir(tmp_path)
    exec(compile("import canopen_objdict\n" + example[1], "python.md", "exec"), {})
    assert load("lamp.eds")["Brightness"].value == 50
