"""Requests to adapters in space, as the page of the protocol says, and messages about answers."""

from __future__ import annotations

import json
import shlex
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.cli import cli
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run import naming
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict

Outcomes = Callable[..., list[Outcome]]
ADAPTER = Path(__file__).with_name("space_adapter.py")
LARGE = "2,1,1/3"  # three factors


def target_named(way: str) -> str:
    return "cmd:" + shlex.join([sys.executable, str(ADAPTER), way])


def literal(scale: str) -> str:
    cube: Any = {
        "vertices": [[x, y, z] for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))],
        "faces": [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6],
                  [3, 0, 4, 7]],
    }  # fmt: skip
    return json.dumps({"P": cube, "Q": cube, "scale": scale})


def verified(
    capsys: pytest.CaptureFixture[str], way: str, *cases: str
) -> tuple[int, dict[str, Any]]:
    options = [part for case in cases for part in ("--case", case)]
    code = cli.run(
        ["verify", target_named(way), *options, "--jobs", "1", "--shrink-calls", "0", "--json"]
    )
    value: dict[str, Any] = json.loads(capsys.readouterr().out)
    return code, value


def test_three_factors_are_sent_as_a_list_and_one_as_a_text(outcomes: Outcomes) -> None:
    """The adapter ends if the factors come otherwise."""
    said = outcomes(target_named("right"), literal(LARGE), literal("3/2"))
    assert [outcome.verdict for outcome in said] == [Verdict.PASS] * 2, said


def test_vertices_that_no_face_names_are_not_looked_at(outcomes: Outcomes) -> None:
    cases = ("space-convex:1:0", "space-convex:1:1", literal(LARGE))
    said = outcomes(target_named("unused-vertices"), *cases)
    assert [outcome.verdict for outcome in said] == [Verdict.PASS] * 3, said


UPDATES = tuple(f"update(space-convex:1:{index})" for index in range(3))


def test_an_update_is_asked_for_from_another_scale() -> None:
    for text in UPDATES:
        case = naming.load(CaseName(text, "test"))
        assert isinstance(case, SpaceCase) and case.before is not None
        assert case.before.scale != case.scale
        assert case.before.needs <= case.needs | {"rational"}


@pytest.mark.parametrize("way", ["update-cube", "update-stale"])
def test_a_wrong_update_drifts(outcomes: Outcomes, way: str) -> None:
    wrong = [o for o in outcomes(target_named(way), *UPDATES) if o.verdict is Verdict.WRONG]
    assert wrong and all(Reason.STATE_DRIFT in outcome.reasons for outcome in wrong)
    assert {o.verdict for o in outcomes(target_named("right"), *UPDATES)} == {Verdict.PASS}


def test_answers_that_differ_are_told(outcomes: Outcomes) -> None:
    said = outcomes(target_named("fickle"), *(f"space-convex:1:{index}" for index in range(6)))
    assert any(Reason.NONDETERMINISTIC in o.reasons for o in said if o.verdict is Verdict.WRONG)


def test_what_is_declared_and_not_asked_for_is_noted(capsys: pytest.CaptureFixture[str]) -> None:
    name = target_named("right")
    note = f"{name} declares verbs that this run did not ask for: update (space)"
    assert note in verified(capsys, "right", literal("1"))[1]["notes"]
    assert note not in verified(capsys, "right", literal("1"), *UPDATES)[1]["notes"]


def test_a_run_in_space_asks_for_updates(capsys: pytest.CaptureFixture[str]) -> None:
    target = target_named("update-cube")
    code = cli.run(
        ["verify", target, "--pairs", "24", "--jobs", "1", "--shrink-calls", "0", "--json"]
    )
    value = json.loads(capsys.readouterr().out)
    assert code == 1
    assert not any("did not ask for" in note for note in value["notes"])


def test_our_own_updates_pass() -> None:
    target = ALL_TARGETS.target("minkref:convex-dynamic", Limits())
    for text in UPDATES:
        case = naming.load(CaseName(text, "test"))
        assert isinstance(case, SpaceCase) and case.before is not None
        answer = target.updated_sum(case.before, case)  # type: ignore[attr-defined]
        assert answer.solid is not None
