"""Runs of the differential runner, in process, with the faulty targets at hand."""

from __future__ import annotations

import faulthandler
import multiprocessing
import os
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.isolation.isolation import Isolation
from minkref.fuzz.run import naming, pool
from minkref.fuzz.run.case_list import RANDOM, CaseList
from minkref.fuzz.run.runner import Run, run
from minkref.fuzz.settings import asking_about
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.baseline import Baseline
from minkref.fuzz.verdicts.verdict import Outcome
from minkref.schemas import schema
from thoroughness import THOROUGH

os.register_at_fork(after_in_child=faulthandler.disable)  # forked workers die on purpose
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
        families: tuple[str, ...] = (RANDOM,),
        call_seconds: float = 30.0,
        versions: dict[str, Any] | None = None,
        walls: Isolation | None = None,
    ) -> Run:
        print(f"seed {SEED}")
        return run(
            CaseList(SEED, pairs, named=named, families=families, models=False),
            list(targets),
            ALL_TARGETS,
            versions or {},
            baseline,
            Limits(seconds=call_seconds, isolation=walls),
            jobs,
        )

    return call


@pytest.fixture
def outcomes(faulty_sums: None) -> Callable[..., list[Outcome]]:
    """A target's outcomes on named cases, without a run and its workers."""

    def call(name: str, *cases: str, limits: Limits | None = None) -> list[Outcome]:
        sys.set_int_max_str_digits(0)  # as in a worker
        limits = limits or Limits(seconds=60)
        target = cache(lambda name: ALL_TARGETS.target(name, limits))  # it, or one of ours
        found: list[Outcome] = []
        try:
            for text in cases:
                case = naming.load(CaseName(text, "test"))
                found += asking_about(case, target, lambda _: None, {}, limits).outcomes([name])
        finally:
            target(name).close()
        return [outcome for outcome in found if outcome.target == name]

    return call


@cache
def _validator(name: str) -> Any:
    import jsonschema

    kind = jsonschema.validators.validator_for(schema(name))
    kind.check_schema(schema(name))
    return kind(schema(name))


@pytest.fixture(scope="session")
def follows_schema() -> Callable[[Any, str], None]:
    """Raises if a document breaks its command's schema."""
    return lambda value, name: _validator(name).validate(value)


@pytest.fixture(autouse=True)
def light_workers(monkeypatch: pytest.MonkeyPatch) -> None:
    """Forks the workers of runs from this process, which has imported all modules. Runs as
    processes, and thorough tests, start workers as users do."""
    if not THOROUGH:
        forking = SimpleNamespace(get_context=lambda _: multiprocessing.get_context("fork"))
        monkeypatch.setattr(pool, "multiprocessing", forking)


@pytest.fixture(autouse=True)
def own_state(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Separates the ledger key from the key of the user who runs the tests."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.getbasetemp() / "state"))
