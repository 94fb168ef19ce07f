"""What is found in descriptions and networks."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from . import _native

Severity = Literal["error", "warning", "note"]

#: The endings of the files that are checked in a folder.
ENDINGS = {".eds", ".dcf", ".xdd", ".xdc", ".xpd", ".nxdd", ".nxdc"}


@dataclass(frozen=True)
class Edit:
    """A piece of text and what it becomes. Lines and columns are counted from 1."""

    line: int
    column: int
    end_line: int
    end_column: int
    text: str


@dataclass(frozen=True)
class Fix:
    """What `objdict check --fix` changes."""

    title: str
    #: Whether it may be made without review: `safe` or `unsafe`.
    safety: str
    edits: tuple[Edit, ...]
    #: The encoding that the file is written in, if it changes.
    encoding: str | None = None


@dataclass(frozen=True)
class Related:
    """Another place of a finding, and what is said of it."""

    message: str
    path: str
    line: int
    column: int
    #: The address in the dictionary: `0x1018sub1 / DefaultValue`.
    place: str | None = None


@dataclass(frozen=True)
class Finding:
    """A finding. `objdict explain RULE` prints the page of its rule."""

    rule: str
    severity: Severity
    message: str
    path: str
    line: int
    column: int
    end_line: int
    end_column: int
    #: The address in the dictionary: `0x1018sub1 / DefaultValue`.
    place: str | None
    help: str | None
    fixes: tuple[Fix, ...]
    related: tuple[Related, ...]
    #: Identifies the finding in its file when lines move.
    fingerprint: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line}:{self.column}: {self.severity} {self.rule}: {self.message}"


def check(paths: str | os.PathLike[str] | Iterable[str | os.PathLike[str]]) -> list[Finding]:
    """The findings of files, and of the descriptions in folders, as the nearest `objdict.toml` wants them."""
    if isinstance(paths, (str, os.PathLike)):
        paths = [paths]
    files = [file for path in paths for file in _files(Path(path))]
    return list(of_document(_native.check(files)))


def _files(path: Path) -> Iterator[str]:
    if not path.is_dir():
        yield str(path)
        return
    for file in sorted(path.rglob("*")):
        is_hidden = any(part.startswith(".") for part in file.relative_to(path).parts)
        if file.suffix.lower() in ENDINGS and file.is_file() and not is_hidden:
            yield str(file)


def of_document(document: str) -> Iterator[Finding]:
    """The findings of a JSON document of `objdict check --format json`."""
    for row in json.loads(document)["findings"]:
        yield _finding(row)


def _finding(row: dict[str, Any]) -> Finding:
    path = row["file"]
    related = tuple(
        Related(other["message"], other.get("file", path), other["line"], other["column"], other.get("place"))
        for other in row.get("related", ())
    )
    fix = row.get("fix")
    return Finding(
        rule=row["rule"],
        severity=row["severity"],
        message=row["message"],
        path=path,
        line=row["line"],
        column=row["column"],
        end_line=row["end_line"],
        end_column=row["end_column"],
        place=row.get("place"),
        help=row.get("help"),
        fixes=(_fix(fix),) if fix else (),
        related=related,
        fingerprint=row["fingerprint"],
    )


def _fix(row: dict[str, Any]) -> Fix:
    edits = tuple(Edit(**edit) for edit in row["edits"])
    return Fix(row["title"], row["safety"], edits, row.get("encoding"))
