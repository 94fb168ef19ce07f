import os
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest

FIXTURES = Path(__file__).parents[3] / "fixtures"


@pytest.fixture
def fixtures() -> Path:
    return FIXTURES


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Generator[None, Any, None]:
    """Fails skipped tests with `CI=true`; `OBJDICT_SKIPS` names a file that collects those of all test programs."""
    outcome = yield
    report = outcome.get_result()
    if report.skipped and os.environ.get("CI") == "true":
        report.outcome = "failed"
    elif report.skipped and (path := os.environ.get("OBJDICT_SKIPS")):
        reason = report.longrepr[2].removeprefix("Skipped: ")
        with open(path, "a", encoding="utf-8") as file:
            file.write(f"skipped: {reason} (python: {item.name})\n")


pytest_plugins = ["pytester"]
