from pathlib import Path

import pytest

FIXTURES = Path(__file__).parents[3] / "fixtures"


@pytest.fixture
def fixtures() -> Path:
    return FIXTURES
pytest_plugins = ["pytester"]
