"""The reference before judges that share no code: they agree, and they detect a lie."""

from __future__ import annotations

import json
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest
from minkref import _core
from minkref.cli.cli import run
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.cgal.executables import OracleNotFoundError
from minkref.fuzz.cgal.swept_solid import SweptSolid
from minkref.fuzz.judges import checks
from minkref.fuzz.judges.plane import (
    event_rows,
    sampled_events,
    slow_points,
    slow_sums,
    slow_tight_passages,
    slow_topology,
    swept_boundary,
    symbolic_events,
)
from minkref.fuzz.judges.ruling import Ruling
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.verdicts.verdict import Reason, Verdict
from thoroughness import draws


def case_of(P: str, Q: str, scale: str = "1") -> Case:
    read = [_core.read_text(text, "wkt", "test") for text in (P, Q)]
    return Case(CaseName("test", "named"), read[0], read[1], scale, "P", "Q")


TRIANGLE = "POLYGON((-3 -2, 4 -1, 1 3, -3 -2))"
FRAME = "POLYGON((-40 -40, 40 -40, 40 40, -40 40, -40 -40), (0 20, 17 -11, -19 -9, 0 20))"
UNIT = "POLYGON((0 0, 1 0, 1 1, 0 1, 0 0))"
DIAMOND = "POLYGON((0 1, 1 0, 2 1, 1 2, 0 1))"
ISLAND = (
    "MULTIPOLYGON(((0 2, 0 0, 6 2, 3 6, 0 2), (3 5, 5 3, 3 1, 1 3, 3 5)), "
    "((2 3, 3 2, 4 3, 3 4, 2 3)))"
)
BLADES = "MULTIPOLYGON(((1 0, 2 2, 1 1, 0 2, 1 0)), ((1 0, 4 2, 3 2, 1 0)))"
KITE = "POLYGON((0 0, 2 1, 1 1, 0 1, 0 0))"
CORRIDOR = "POLYGON((0 0, 5 0, 5 3, 0 3, 0 0), (1 1, 1 2, 4 2, 4 1, 1 1))"


def swept(case: Case) -> Ruling:
    try:
        with SweptSolid() as solid:
            return swept_boundary.judge(case, solid)
    except OracleNotFoundError as error:
        pytest.skip(str(error))


def sampled(case: Case) -> Ruling:
    with sampled_events.SampledEvents() as judge:
        return sampled_events.judge(case, judge)


JUDGES: dict[str, tuple[Any, Callable[[Case], Ruling]]] = {
    "sums": (slow_sums, slow_sums.judge),
    "topology": (slow_topology, slow_topology.judge),
    "tight passages": (slow_tight_passages, slow_tight_passages.judge),
    "points": (slow_points, slow_points.judge),
    "events": (event_rows, symbolic_events.judge),
    "boundary": (swept_boundary, swept),
    "sampled": (sampled_events, sampled),
}


@pytest.mark.parametrize("name", JUDGES)
@pytest.mark.parametrize(("P", "Q"), [(TRIANGLE, FRAME), (UNIT, CORRIDOR)])
def test_a_judge_agrees_where_the_reference_is_right(name: str, P: str, Q: str) -> None:
    ruling = JUDGES[name][1](case_of(P, Q))
    assert ruling.skipped is None and ruling.messages == []
    assert ruling.compared > 0


@pytest.mark.parametrize("name", ["sums", "topology", "events"])
@pytest.mark.parametrize(("P", "Q"), [(DIAMOND, ISLAND), (BLADES, KITE)])
def test_a_judge_agrees_on_what_was_once_amiss(name: str, P: str, Q: str) -> None:
    """An island that fills its hole at one scale; three collinear edges with a common end."""
    ruling = JUDGES[name][1](case_of(P, Q))
    assert ruling.messages == [] and ruling.compared > 0


SHRINKING = "MULTIPOLYGON(((-1 -1, 0 -1, 0 0, -1 -1)), ((1 1, 0 2, 0 1, 1 1)))"
GROWING = "MULTIPOLYGON(((0 2, 0 0, 1 0, 0 2)), ((-2 1, -3 -1, -2 0, -2 1)))"
TOUCHING = "POLYGON((1 3, 4 3, 4 5, 1 5, 1 3), (3 4, 3 3, 2 4, 3 4))"


def test_both_routes_list_the_scale_at_which_an_edge_shrinks_and_grows_again_reversed() -> None:
    """At 3/2 only: the same moving boundary is just below and just above."""
    ruling = sampled(case_of(SHRINKING, GROWING))
    assert ruling.messages == [] and ruling.compared > 0


def test_vertices_of_rings_that_touch_for_a_while_are_those_of_the_canonical_form() -> None:
    """Vertices are counted after rings that pass a point twice are split."""
    for P, Q in ((TOUCHING, "POINT(4 3)"), (UNIT, TOUCHING)):
        assert sampled(case_of(P, Q)).messages == []


class Lying:
    """The extension module, with some names replaced."""

    def __init__(self, **lies: Any) -> None:
        self._lies = lies

    def __getattr__(self, name: str) -> Any:
        return self._lies.get(name) or getattr(_core, name)


def moved_sum(P: Any, Q: Any, scale: str, route: str = "paper") -> Any:
    return _core.minkowski_sum(P, Q.translated("1/1000000000000", "0"), scale, route)


def other_count(P: Any, Q: Any, scale: str, route: str = "paper") -> Any:
    right = _core.minkowski_sum(P, Q, scale, route)
    return SimpleNamespace(region=right.region, components=right.components, holes=right.holes + 1)


class WithoutEvents:
    """A dynamic sum that hides its events."""

    def __init__(self, *arguments: Any) -> None:
        self._right = _core.DynamicSum(*arguments)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._right, name)

    def topology_events(self) -> list[Any]:
        return []


class WithoutBoundaryEvents(WithoutEvents):
    def boundary_events(self) -> list[Any]:
        return []


class RepeatedBoundaryEvents(WithoutEvents):
    def boundary_events(self) -> list[Any]:
        return 2 * self._right.boundary_events()

    def topology_events(self) -> list[Any]:
        right: list[Any] = self._right.topology_events()
        return right


class WithoutHoles:
    """An index."""

    def __init__(self, *arguments: Any) -> None:
        self._right = _core.ScaleIndex(*arguments)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._right, name)

    def components_and_holes(self, scale: str) -> tuple[int, int]:
        return self._right.components_and_holes(scale)[0], 0


class FewerEvents:
    def __init__(self, *arguments: Any) -> None:
        self._right = _core.ArrangementEvents(*arguments)

    def edges(self) -> Any:
        return self._right.edges()

    def of_kind(self, kind: str) -> Any:
        return self._right.of_kind(kind)

    def rows(self, which: Any) -> Any:
        return self._right.rows(which)[:-1]


class WithMoreEvents(WithoutEvents):
    def boundary_events(self) -> list[Any]:
        right = self._right.boundary_events()
        return [*right, ("2", *right[0][1:])]

    def topology_events(self) -> list[Any]:
        right: list[Any] = self._right.topology_events()
        return right


def drifting(part: int) -> type[WithoutEvents]:
    """Counts one hole too many: 0 just below, 1 at the scale, 2 just above the only event."""

    class Drifting(WithoutEvents):
        def topology_events(self) -> list[Any]:
            right: list[Any] = self._right.topology_events()
            return right

        def state_counts(self) -> list[Any]:
            (start, below), (event, above) = self._right.state_counts()
            if part == 0:
                below = (below[0] + 1, *below[1:])
            elif part == 1:
                above = (*above[:3], above[3] + 1, above[4])
            else:
                above = (above[0] + 1, *above[1:])
            return [(start, below), (event, above)]

    return Drifting


class DriftingSum(WithoutEvents):
    """A dynamic sum whose set is not updated."""

    def sum(self) -> Any:
        self._right.move_to("1/7")
        return self._right.sum()


def more_components(P: Any, Q: Any, scale: str, route: str = "paper") -> Any:
    right = _core.minkowski_sum(P, Q, scale, route)
    return SimpleNamespace(region=right.region, components=right.components + 1, holes=right.holes)


def unproved(P: Any, Q: Any, scale: str, x: str, y: str) -> Any:
    right = _core.decide(P, Q, scale, x, y)
    return {**right, "p": ("100", "100")} if right["p"] else right


class RepeatedEvents(FewerEvents):
    def rows(self, which: Any) -> Any:
        rows = self._right.rows(which)
        return [*rows, ("7/3", *rows[0][1:])]


PASSAGE = [([("0", "0"), ("1", "1")], [[]])]
LIES: list[tuple[str, str, str, dict[str, Any], Reason]] = [
    ("sums", TRIANGLE, FRAME, {"minkowski_sum": moved_sum}, Reason.MISSING),
    ("sums", UNIT, CORRIDOR, {"minkowski_sum": other_count}, Reason.HOLE_INVENTED),
    ("sums", UNIT, CORRIDOR, {"minkowski_sum": more_components}, Reason.COMPONENT),
    ("sums", TRIANGLE, FRAME, {"DynamicSum": DriftingSum}, Reason.MISSING),
    ("topology", TRIANGLE, FRAME, {"DynamicSum": WithoutEvents}, Reason.EVENT_MISPLACED),
    ("topology", TRIANGLE, FRAME, {"DynamicSum": drifting(0)}, Reason.HOLE_INVENTED),
    ("topology", TRIANGLE, FRAME, {"DynamicSum": drifting(1)}, Reason.STATE_DRIFT),
    ("topology", TRIANGLE, FRAME, {"DynamicSum": drifting(2)}, Reason.HOLE_INVENTED),
    (
        "topology", TRIANGLE, FRAME, {"DynamicSum": WithMoreEvents},
        Reason.EVENT_INVENTED,
    ),
    ("tight passages", UNIT, CORRIDOR, {"tight_passages": lambda *_: PASSAGE * 3},
     Reason.PASSAGE_INVENTED),
    ("points", UNIT, UNIT, {"decide": unproved}, Reason.EXTRA),
    ("events", TRIANGLE, FRAME, {"ArrangementEvents": RepeatedEvents}, Reason.EVENT_INVENTED),
    (
        "events", TRIANGLE, FRAME, {"reduced_convolution": lambda *_: []}, Reason.EVENT_MISSED,
    ),
    ("boundary", TRIANGLE, FRAME, {"DynamicSum": WithMoreEvents}, Reason.EVENT_INVENTED),
    ("sampled", TRIANGLE, FRAME, {"DynamicSum": WithMoreEvents}, Reason.EVENT_INVENTED),
    ("sampled", TRIANGLE, FRAME, {"DynamicSum": WithoutBoundaryEvents}, Reason.EVENT_MISSED),
    ("sampled", TRIANGLE, FRAME, {"DynamicSum": WithoutEvents}, Reason.EVENT_MISPLACED),
    ("sampled", TRIANGLE, FRAME, {"DynamicSum": RepeatedBoundaryEvents}, Reason.EVENT_INVENTED),
    ("sampled", TRIANGLE, FRAME, {"DynamicSum": drifting(0)}, Reason.STATE_DRIFT),
    ("sampled", TRIANGLE, FRAME, {"DynamicSum": drifting(1)}, Reason.STATE_DRIFT),
    ("sampled", TRIANGLE, FRAME, {"ScaleIndex": WithoutHoles}, Reason.STATE_DRIFT),
    (
        "tight passages", UNIT, CORRIDOR, {"tight_passages": lambda *_: []},
        Reason.PASSAGE_MISSED,
    ),
    (
        "points", UNIT, UNIT, {"decide": lambda *_: {"contact": "empty", "p": None, "q": None}},
        Reason.MISSING,
    ),
    ("events", TRIANGLE, FRAME, {"ArrangementEvents": FewerEvents}, Reason.EVENT_MISSED),
    ("boundary", TRIANGLE, FRAME, {"DynamicSum": WithoutBoundaryEvents}, Reason.EVENT_MISSED),
]  # fmt: skip


@pytest.mark.parametrize(("name", "P", "Q", "lies", "reason"), LIES)
def test_a_judge_sees_a_lie(
    monkeypatch: pytest.MonkeyPatch,
    name: str, P: str, Q: str, lies: dict[str, Any], reason: Reason,
) -> None:  # fmt: skip
    module, judge = JUDGES[name]
    monkeypatch.setattr(module, "_core", Lying(**lies))
    case = case_of(P, Q)
    ruling = judge(case)
    assert reason in ruling.reasons and ruling.messages
    outcome = ruling.outcome("minkref@test", 0.0)
    assert outcome.verdict is Verdict.WRONG and outcome.message
    if outcome.witness is not None:
        assert outcome.witness.scale is not None
        assert holds(case.P_json, case.Q_json, outcome.witness.scale, outcome.witness)


def test_a_wrong_set_has_a_witness(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(slow_sums, "_core", Lying(minkowski_sum=moved_sum))
    assert slow_sums.judge(case_of(TRIANGLE, FRAME)).witness is not None


def test_verify_minkref_puts_the_reference_before_every_judge(
    capsys: pytest.CaptureFixture[str], follows_schema: Callable[[Any, str], None]
) -> None:
    pairs = draws(2, 6)
    code = run(["verify", "minkref", "--pairs", str(pairs), "--no-models", "--jobs", "1", "--json"])
    value = json.loads(capsys.readouterr().out)
    follows_schema(value, "verify")
    assert (code, value["findings"]) == (0, [])
    judged = {row["target"] for row in value["matrix"]} | {row["name"] for row in value["absent"]}
    assert judged == set(checks.OFFER.about)
    passes = sum(row["verdicts"].get("pass", 0) for row in value["matrix"])
    assert passes >= 5 * pairs


def test_one_judge_alone_and_a_judge_that_there_is_not(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["verify", "minkref@slow-points", "--case", "g1+g3@7/5"]) == 0
    assert "minkref@slow-points" in capsys.readouterr().out
    assert run(["verify", "minkref@nobody", "--pairs", "1"]) == 2


def test_what_is_too_large_for_a_judge_is_skipped_with_a_reason(
    capsys: pytest.CaptureFixture[str],
) -> None:
    code = run(["verify", "minkref", "--case", "glyph275+dog145@1", "--json", "--jobs", "1"])
    rows = json.loads(capsys.readouterr().out)["matrix"]
    assert code == 0
    for row in rows:
        if row["target"] != "minkref@slow-points":
            assert row["verdicts"] == {"skipped": 1} and row["skips"]


@pytest.mark.parametrize(
    ("P", "Q"),
    [
        ("POINT(1 2)", TRIANGLE),
        (TRIANGLE, "LINESTRING(0 0, 1 1)"),
        ("POLYGON EMPTY", TRIANGLE),
        ("POINT(1 2)", "POINT(3 4)"),
        ("POINT(1 2)", "LINESTRING(0 0, 1 1)"),
        ("POLYGON((0 0, 1e4100 0, 0 1, 0 0))", TRIANGLE),
        # A hole shrinks onto a tight point in the middle of everything.
        (
            "POLYGON((-1 -1, 1 -1, 1 1, -1 1, -1 -1))",
            "POLYGON((-3 -3, 3 -3, 3 3, -3 3, -3 -3), (-1 -1, -1 1, 1 1, 1 -1, -1 -1))",
        ),
    ],
)
def test_no_judge_raises_an_alarm_on_a_hostile_case(P: str, Q: str) -> None:
    case = case_of(P, Q)
    for name in checks.OFFER.about:
        if checks.absence(name) is None:
            check = checks.Check(name)
            outcome = check.rule(case)
            check.close()
            assert outcome.verdict in (Verdict.PASS, Verdict.SKIPPED), (name, outcome.message)
            assert outcome.verdict is Verdict.PASS or outcome.message


def test_a_judge_that_compares_nothing_has_not_passed() -> None:
    assert Ruling().outcome("minkref@test", 0.0).verdict is Verdict.SKIPPED


def test_a_judge_that_breaks_down_is_no_skip(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(case: Case) -> Ruling:
        raise RuntimeError("the swept solid crashed")

    monkeypatch.setattr(slow_points, "judge", broken)
    outcome = checks.Check("minkref@slow-points").rule(case_of(UNIT, UNIT))
    assert outcome.verdict is Verdict.ERRORED and "crashed" in outcome.message
