"""The recipes of docs/guides/python.md: each runs in a folder with the fixtures that the page names."""

import re
import runpy
import shutil
from pathlib import Path
from typing import Any

import pytest

from canopen_objdict import load

PAGE = (Path(__file__).parents[3] / "docs/guides/python.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
#: The folders of the fixtures on the page, and of what they refer to.
FOLDERS = ("eds", "logs", "network")


@pytest.fixture
def folder(fixtures: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder, with the fixtures."""
    for name in FOLDERS:
        shutil.copytree(fixtures / name, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def saved(block: str, path: Path) -> str:
    path.write_text(block, encoding="utf-8")
    return str(path)


def named(name: str) -> str:
    """The block behind a comment of the page."""
    block = re.search(rf"<!-- python {name} -->\n```python\n(.*?)```", PAGE, re.DOTALL)
    assert block is not None
    return block[1]


def test_the_page_has_recipes() -> None:
    assert len(BLOCKS) > 8


@pytest.mark.parametrize("block", BLOCKS, ids=[str(number) for number in range(1, len(BLOCKS) + 1)])
def test_each_block_runs(block: str, folder: Path) -> None:
    for module, use in (("canopen", "import canopen\n"), ("pandas", "to_dataframe()")):
        if use in block:
            pytest.importorskip(module)
    runpy.run_path(saved(block, folder / "recipe.py"))


def test_the_configured_node(folder: Path) -> None:
    block = next(block for block in BLOCKS if "configure(" in block)
    runpy.run_path(saved(block, folder / "recipe.py"))
    node = load("node5.dcf")
    assert (node.node_id, node[0x1017].value, node[0x1800, 2].value) == (5, 1000, 1)


def test_the_log(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    block = next(block for block in BLOCKS if "decode(" in block)
    runpy.run_path(saved(block, folder / "recipe.py"))
    assert "Position actual value" in capsys.readouterr().out


def test_the_new_device(folder: Path) -> None:
    block = next(block for block in BLOCKS if "Device.new(" in block)
    runpy.run_path(saved(block, folder / "recipe.py"))
    assert load("lamp.eds")["Brightness"].value == 50


def test_all_entries_of_a_node(fixtures: Path, tmp_path: Path) -> None:
    canopen: Any = pytest.importorskip("canopen")
    device = load(fixtures / "eds/drive-402.eds", node_id=5)
    node = canopen.LocalNode(5, device.to_canopen())
    rows = runpy.run_path(saved(named("bench"), tmp_path / "bench.py"))["rows"]
    texts = {(entry.index, entry.sub): text for entry, text in rows(device, node.get_data)}
    assert texts[0x1018, 1] == "1017"
    assert len(texts) == sum(entry.is_readable for entry in device.entries())


def test_a_test_of_descriptions(fixtures: Path, pytester: pytest.Pytester) -> None:
    saved(named("ci"), pytester.path / "test_descriptions.py")
    text = (fixtures / "eds/io-401.eds").read_bytes()
    (pytester.path / "io-401.eds").write_bytes(text)
    assert pytester.runpytest().ret == 0
    released = pytester.path / "released"
    released.mkdir()
    shutil.copy(pytester.path / "io-401.eds", released)
    (pytester.path / "io-401.eds").write_bytes(text.replace(b"[1017]", b"[2FFF]"))
    assert pytester.runpytest().ret == 1
