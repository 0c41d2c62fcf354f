"""Runs of the differential runner, in process, with the faulty targets at hand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.cases.case_list import CaseList
from minkref.fuzz.isolation.isolation import Isolation
from minkref.fuzz.run.runner import Run, run
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline

SEED = 20
NO_BASELINE = Baseline()


@pytest.fixture
def faulty_sums(monkeypatch: pytest.MonkeyPatch) -> None:
    """Makes `py:faulty_sums:NAME` importable, here and by the program that holds a function."""
    here = str(Path(__file__).parent)
    monkeypatch.syspath_prepend(here)
    monkeypatch.setenv("PYTHONPATH", here)


@pytest.fixture
def verify(faulty_sums: None) -> Callable[..., Run]:
    def call(
        *targets: str,
        pairs: int = 12,
        baseline: Baseline = NO_BASELINE,
        jobs: int = 1,
        named: tuple[str, ...] = (),
        call_seconds: float = 30.0,
        versions: dict[str, Any] | None = None,
        walls: Isolation | None = None,
    ) -> Run:
        print(f"seed {SEED}")
        return run(
            CaseList(SEED, pairs, named=named, models=False),
            list(targets),
            versions or {},
            baseline,
            Limits(seconds=call_seconds, isolation=walls),
            jobs,
        )

    return call


@pytest.fixture(autouse=True)
def own_state(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """The key of ledgers is not that of the user who runs the tests."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.getbasetemp() / "state"))
