"""Logs of buses."""

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from canopen_objdict import Frame, Network, ObjdictError, decode, load

DRIVE = "eds/drive-402.eds"


def position(frames: list[Frame]) -> float:
    values = [signal.value for frame in frames for signal in frame.signals if signal.index == 0x6064]
    return max(value for value in values if isinstance(value, int))


def test_frames_have_names_and_values(fixtures: Path) -> None:
    frames = list(decode(fixtures / "logs/drive.asc", {5: fixtures / DRIVE}))
    tpdo = next(frame for frame in frames if frame.service == "TPDO 1" and frame.signals)
    assert (tpdo.node, tpdo.kind, tpdo.can_id) == (5, "pdo", 0x185)
    assert [signal.index for signal in tpdo.signals][:2] == [0x6041, 0x6064]
    aborted = next(frame for frame in frames if frame.abort)
    assert (aborted.index, aborted.sub, aborted.abort) == (0x6081, 0, 0x06090031)
    assert [frame.time for frame in frames] == sorted(frame.time for frame in frames)


def test_nodes_are_described_in_any_form(fixtures: Path) -> None:
    log = fixtures / "logs/drive.asc"
    best = position(list(decode(log, {5: fixtures / DRIVE})))
    assert position(list(decode(log, load(fixtures / DRIVE, node_id=5)))) == best
    # an EDS without a node-ID finds its node
    assert position(list(decode(log, fixtures / DRIVE))) == best
    assert position(list(decode([log.read_bytes()], [load(fixtures / DRIVE)]))) == best
    with log.open("rb") as file:
        assert position(list(decode(file, {5: load(fixtures / DRIVE)}))) == best
    worked = fixtures / "network/worked.yml"
    path, network = (list(decode(fixtures / "logs/worked.log", nodes)) for nodes in (worked, Network.load(worked)))
    assert path == network and any(frame.signals for frame in path)


def test_the_command_says_the_same(fixtures: Path) -> None:
    command = shutil.which("objdict", path=str(Path(sys.executable).parent))
    if command is None:
        pytest.skip("the command is not installed")
    log, network = fixtures / "logs/chapter4.log", fixtures / "network/chapter4.toml"
    run = [command, "decode", str(log), "--with", str(network), "--format", "json"]
    lines = subprocess.run(run, capture_output=True, text=True, check=True).stdout.splitlines()
    rows = [json.loads(line) for line in lines]
    frames = list(decode(log, network))
    assert [row["text"] for row in rows] == [frame.text for frame in frames]
    assert [row["data"] for row in rows] == [frame.data.hex().upper() for frame in frames]
    assert sum(row.get("value") is not None for row in rows) == sum(frame.value is not None for frame in frames)


def test_lines_that_are_not_understood_are_warnings(fixtures: Path) -> None:
    with pytest.warns(UserWarning, match="broken.log:2: the time is not a number"):
        assert len(list(decode(fixtures / "logs/broken.log"))) == 2
    with pytest.raises(ObjdictError, match="is not a log of a CAN bus"):
        list(decode(fixtures / DRIVE))
    with pytest.raises(FileNotFoundError, match="nothing.log"):
        list(decode(fixtures / "nothing.log"))


def test_a_long_log_is_read_as_far_as_it_is_asked_for(tmp_path: Path) -> None:
    log = tmp_path / "long.log"
    log.write_text("".join(f"({second}.000000) can0 705#05\n" for second in range(20_000)))
    frames = decode(log)
    assert [next(frames).time for _ in range(1000)][-1] == 999
    del frames
    assert sum(frame.kind == "heartbeat" for frame in decode(log)) == 20_000
