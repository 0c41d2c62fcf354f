"""The indices under test."""

from __future__ import annotations

import pytest
from indexed_sums import NAMES, Index, operands, window_of


@pytest.fixture(scope="module")
def indices() -> dict[str, Index]:
    return {name: Index(*operands(name), *window_of(name)) for name in NAMES}


@pytest.fixture(params=NAMES)
def index(request: pytest.FixtureRequest, indices: dict[str, Index]) -> Index:
    return indices[request.param]
