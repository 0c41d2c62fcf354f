"""Other library versions among the targets are asked about each finding."""

from __future__ import annotations

from typing import Any

import pytest
from minkref.fuzz.run.catalogue import Catalogue
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict
from minkref.reports.conformance import versions


class Asked:
    """Replaces a worker: 6.0.1 is right, 5.6 is wrong, 5.4 dies."""

    def __init__(self, target: str, catalogue: Catalogue, limits: Limits) -> None:
        self.target = target

    def ask(self, text: str) -> tuple[None, Outcome]:
        outcomes = {
            "cgal-reduced@6.0.1": Outcome(self.target, Verdict.PASS),
            "cgal-reduced@5.6": Outcome(self.target, Verdict.WRONG, (Reason.HOLE_LOST,)),
            "cgal-reduced@5.4": Outcome(self.target, Verdict.CRASHED, signal="SIGSEGV"),
        }
        return None, outcomes[self.target]

    def __enter__(self) -> Asked:
        return self

    def __exit__(self, *_: object) -> None:
        pass


def test_each_version_says_whether_the_fault_is_there(
    made: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(versions, "Asker", Asked)
    others = ("6.0.1", "5.6", "5.4")
    made.value["targets"] += [{"name": f"cgal-reduced@{v}", "version": v} for v in others]
    made.value["targets"].append({"name": "cgal-reduced-raw", "version": "5.5.1"})
    (group,) = (g for g in made.groups if g.example.outcome.target == "cgal-reduced")
    said = {p.version: p.says for p in versions.presence(group, made.value, Limits())}
    assert said == {
        "6.0.1": "fixed: right on 1 of 1 cases",
        "5.6": "still present: the same fault on 1 of 1 cases",
        "5.4": "otherwise: crashed",
    }
    (other,) = (g for g in made.groups if g.example.outcome.target == "pysfcgal")
    assert versions.presence(other, made.value, Limits()) == []
