"""The indices that are asked, and the modules of this folder by their bare names."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from indexed_sums import NAMES, Index, operands, window_of


@pytest.fixture(scope="module")
def indices() -> dict[str, Index]:
    return {name: Index(*operands(name), *window_of(name)) for name in NAMES}


@pytest.fixture(params=NAMES)
def index(request: pytest.FixtureRequest, indices: dict[str, Index]) -> Index:
    return indices[request.param]
