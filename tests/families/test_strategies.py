"""The strategies: valid, reachable, deterministic, within their bounds; planted faults shrink."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import hypothesis
import minkref
import pytest
from hypothesis import Phase, find, given, settings
from hypothesis import strategies as st
from members import turn
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.plane.draft import Draft, Facts
from minkref.strategies import (
    DEGENERATE_FAMILIES,
    SetData,
    degenerate,
    degenerate_pairs,
    pairs,
    polygons,
    scaled_pairs,
    scales_near_events,
    to_data,
    to_fractions,
    to_set,
)
from minkref.strategies.degenerate import is_member
from minkref.strategies.event_scales import critical_scales
from minkref.strategies.growth import Part, grown
from minkref.strategies.values import data_of
from thoroughness import THOROUGH, draws, some

DOCS = Path(__file__).parents[2] / "docs" / "strategies.md"
LARGE: dict[str, Any] = {"holes": 3, "components": 3, "max_vertices": 12}
PHASES = (Phase.generate, Phase.shrink)
QUICK = settings(derandomize=True, database=None, deadline=None, phases=PHASES)
MANY = settings(QUICK, max_examples=300)
SOME = settings(QUICK, max_examples=draws(25, 300))


def numbers(data: SetData) -> list[Fraction]:
    rings = [r for p in to_fractions(data)["polygons"] for r in (p["outer"], *p["holes"])]
    return [c for ring in rings for point in ring for c in point]


def vertices(*operands: SetData) -> int:
    return sum(to_set(operand).vertices for operand in operands)


def check(data: SetData) -> None:
    """Asserts a valid set in lowest terms, with rings turned as their role demands."""
    to_set(data).validate("drawn")
    assert to_data(to_fractions(data)) == data == json.loads(json.dumps(data))
    for polygon in to_fractions(data)["polygons"]:
        for ring, sign in ((polygon["outer"], 1), *((hole, -1) for hole in polygon["holes"])):
            area = sum(
                a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)
            )
            assert sign * area > 0


BOUNDS: dict[str, dict[str, Any]] = {
    "usual": {},
    "large": LARGE,
    "whole": {"denominators": (1,), "magnitude": 3},
    "narrow": {"max_vertices": 3, "magnitude": 1, "holes": 2, "components": 2},
    "far": {"magnitude": 10**20, "denominators": (10**9 + 7, 7)},
    "plain": {"holes": 0},
}


@pytest.mark.parametrize("name", BOUNDS)
def test_sets_are_valid_and_within_their_bounds(name: str) -> None:
    bounds = BOUNDS[name]

    @SOME
    @given(polygons(**bounds))
    def drawn(data: SetData) -> None:
        check(data)
        most = bounds.get("magnitude", 10)
        for number in numbers(data):
            assert abs(number) <= most
            assert any(d % number.denominator == 0 for d in bounds.get("denominators", (1, 2, 3)))
        assert 1 <= len(data["polygons"]) <= bounds.get("components", 1)
        for polygon in data["polygons"]:
            assert len(polygon["holes"]) <= bounds.get("holes", 1)
            for ring in (polygon["outer"], *polygon["holes"]):
                assert 3 <= len(ring) <= bounds.get("max_vertices", 8)

    drawn()


def is_island(data: SetData) -> bool:
    return any(len(p["holes"]) > 0 for p in data["polygons"][1:])


def touches(data: SetData) -> bool:
    points = [tuple(v) for p in data["polygons"] for r in (p["outer"], *p["holes"]) for v in r]
    return len(set(points)) < len(points)


KINDS: dict[str, Callable[[SetData], bool]] = {
    "three polygons": lambda data: len(data["polygons"]) == 3,
    "three holes": lambda data: any(len(p["holes"]) == 3 for p in data["polygons"]),
    "twelve vertices": lambda data: any(len(p["outer"]) == 12 for p in data["polygons"]),
    "a ring around another polygon": is_island,
    "rings that touch": touches,
    "another denominator": lambda data: any(c.denominator == 3 for c in numbers(data)),
}


def test_every_kind_of_set_is_drawn() -> None:
    only = settings(MANY, max_examples=2000, phases=(Phase.generate,))
    seen: set[str] = set()

    def drawn(data: SetData) -> bool:
        seen.update(kind for kind, shows in KINDS.items() if shows(data))
        return seen == set(KINDS)

    assert find(polygons(**LARGE), drawn, settings=only), KINDS.keys() - seen


def test_every_simple_polygon_has_a_plan() -> None:
    comb = [(0, 0), (6, 0), (6, 4), (5, 4), (5, 1), (3, 1), (3, 4), (2, 4), (2, 1), (0, 1)]
    order = (0, 1, 9, 5, 8, 4, 2, 3, 7, 6)
    corners = []
    for k, number in enumerate(order):
        known = sorted(order[:k])
        before = [n for n in known if n < number]
        corners.append((*comb[number], max(len(before) - 1, 0)))
    ring = grown([Part(corners)], 6, 10)[0][0]
    start = ring.index((0, 0))
    assert ring[start:] + ring[:start] == comb


def test_the_simplest_values() -> None:
    triangle = {"polygons": [{"outer": [["0", "0"], ["1", "0"], ["0", "1"]], "holes": []}]}
    anything: Any = lambda value: True  # noqa: E731
    assert find(polygons(**LARGE), anything, settings=QUICK) == triangle
    assert find(pairs(), anything, settings=QUICK) == (triangle, triangle)
    case = find(scaled_pairs(), anything, settings=QUICK)
    assert case == {"P": triangle, "Q": triangle, "scale": "1"}
    small = find(pairs(without_area=True), lambda pair: vertices(*pair) > 0, settings=QUICK)
    assert vertices(*small) == 4


def test_pairs_without_area() -> None:
    seen = set()

    @SOME
    @given(pairs(without_area=True))
    def drawn(pair: tuple[SetData, SetData]) -> None:
        minkref.minkowski_sum(to_set(pair[0]), to_set(pair[1]))
        for data in pair:
            seen.add(vertices(data) if vertices(data) < 3 else 3)
        assert max(map(vertices, pair)) >= 3

    drawn()
    assert seen == {0, 1, 2, 3}


def test_scales_lie_at_beside_and_between_events() -> None:
    P: SetData = {"polygons": [{"outer": [["0", "0"], ["1", "0"], ["0", "1"]], "holes": []}]}
    hole = [["0", "0"], ["0", "1"], ["1", "0"]]
    Q: SetData = {
        "polygons": [{"outer": [["-1", "-1"], ["3", "-1"], ["-1", "3"]], "holes": [hole]}]
    }
    critical = critical_scales(P, Q, "topology")
    seen = set()

    @MANY
    @given(scales_near_events(P, Q, kind="topology", bits=40))
    def drawn(text: str) -> None:
        scale = Fraction(text)
        assert scale > 0 and str(scale) == text
        gaps = [scale - event for event in critical]
        near = min(gaps, key=abs)
        if near == 0:
            seen.add("at")
        elif abs(near).numerator == 1 and abs(near) < Fraction(1, 2**20):
            assert abs(near) >= Fraction(1, 2**40)
            seen.add("above" if near > 0 else "below")
        else:
            seen.add("other")

    drawn()
    assert critical and seen == {"at", "above", "below", "other"}
    for kind in ("arrangement", "boundary", "topology"):
        assert set(critical) <= set(critical_scales(P, Q, "arrangement"))
        scale = find(scales_near_events(P, Q, kind=kind), lambda s: s != "1", settings=QUICK)
        assert Fraction(scale) > 0


@pytest.mark.parametrize("name", turn(FAMILIES, 2, 4))
def test_members_of_a_family(name: str) -> None:
    drawn = []
    count = draws(6, 12)

    @settings(MANY, max_examples=count)
    @given(degenerate_pairs(name))
    def member(case: Any) -> None:
        check(case["P"])
        check(case["Q"])
        assert case["family"] == name and Fraction(case["scale"]) > 0
        drawn.append(json.dumps(case))

    member()
    assert len(set(drawn)) >= 2 * count / 3


def test_any_family_may_be_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(degenerate, "_members", lambda family: st.just(family.name))
    seen = set()

    @settings(MANY, max_examples=2000)
    @given(degenerate.degenerate_pairs())
    def drawn(name: Any) -> None:
        seen.add(name)

    drawn()
    assert seen == set(DEGENERATE_FAMILIES) == set(FAMILIES)


CLAIMING = ["one-line-always", "collinear-vertices"]  # what is zero at all scales


STEPPED = ["rings-touching", "combs", "limits-of-float64", "scales-near-zero"]
MORE = [CLAIMING[1], "spirals", "limits-of-integers", "scales-far-out"]  # each of a kind of those


@pytest.mark.parametrize("name", [CLAIMING[0], *STEPPED, *(MORE if THOROUGH else [])])
def test_all_steps_leave_a_member(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[bool] = []
    drafts: list[Draft] = []

    def noted(family: Any, draft: Draft) -> bool:
        asked.append(is_member(family, draft))
        drafts.extend([draft] if asked[-1] else [])
        return asked[-1]

    monkeypatch.setattr(degenerate, "is_member", noted)
    monkeypatch.setattr(degenerate, "SELDOM", st.just(0))

    count = draws(8, 20)

    @settings(MANY, max_examples=count)
    @given(degenerate_pairs(name))
    def drawn(case: Any) -> None:
        last = drafts[-1]
        facts = Facts.of(last)
        assert case["P"] == data_of(last.P) and case["scale"] == str(last.scale)
        assert FAMILIES[name].belongs(facts)
        assert all(facts.vertices.value(zero, last.scale) == 0 for zero in last.zeros)
        assert bool(last.zeros) == (name in CLAIMING)

    drawn()
    assert asked.count(False) and len(drafts) > 2 * count


@pytest.mark.parametrize("strategy", [polygons(**LARGE), scaled_pairs(), degenerate_pairs()])
def test_derandomized_runs_draw_the_same(strategy: st.SearchStrategy[Any]) -> None:
    runs: list[list[Any]] = []
    for _ in range(2):
        values: list[Any] = []

        @settings(MANY, max_examples=draws(15, 60))
        @given(strategy)
        def drawn(value: Any) -> None:
            values.append(value)  # noqa: B023

        drawn()
        runs.append(values)
    assert runs[0] == runs[1]


def true_sum(P: SetData, Q: SetData, scale: str = "1") -> minkref.Sum:
    return minkref.minkowski_sum(to_set(P), to_set(Q), scale)


def is_convex(P: SetData, Q: SetData) -> bool:
    """Whether the sum equals its hull: no reflex vertex, no hole, a single component."""
    region = to_fractions(json.loads(true_sum(P, Q).region.to_json()))["polygons"]
    if len(region) > 1 or region[0]["holes"]:
        return False
    ring = region[0]["outer"]
    corners = zip(ring, [*ring[1:], *ring[:1]], [*ring[2:], *ring[:2]], strict=True)
    return all((b[0] - a[0]) * (c[1] - b[1]) > (b[1] - a[1]) * (c[0] - b[0]) for a, b, c in corners)


def loses_holes(P: SetData, Q: SetData) -> bool:
    return true_sum(P, Q).holes > 0


def test_a_hull_shrinks_to_a_triangle_and_a_reflex_vertex() -> None:
    for bounds in ({}, LARGE)[: draws(1, 2)]:
        P, Q = find(pairs(**bounds), lambda pair: not is_convex(*pair), settings=QUICK)
        assert vertices(P, Q) == 7
        assert all(abs(c) <= 3 and c.denominator == 1 for c in numbers(P) + numbers(Q))


@pytest.mark.thorough
def test_lost_holes_shrink_to_nine_vertices() -> None:
    """Larger sibling of test_lost_holes_shrink_to_a_point_where_one_is_allowed."""
    for bounds in ({}, LARGE):
        P, Q = find(pairs(**bounds), lambda pair: loses_holes(*pair), settings=MANY)
        assert vertices(P, Q) == 9
        assert all(abs(c) <= 6 and c.denominator == 1 for c in numbers(P) + numbers(Q))


def test_lost_holes_shrink_to_a_point_where_one_is_allowed() -> None:
    strategy = pairs(without_area=True)
    P, Q = find(strategy, lambda pair: loses_holes(*pair), settings=MANY)
    assert vertices(P, Q) == 7
    assert {"polygons": [{"outer": [["0", "0"]], "holes": []}]} in (P, Q)


@pytest.mark.thorough
def test_lost_holes_of_operands_without_holes() -> None:
    """Larger sibling of test_lost_holes_shrink_to_a_point_where_one_is_allowed."""
    strategy = pairs(holes=0, max_vertices=12)
    P, Q = find(strategy, lambda p: loses_holes(*p), settings=settings(MANY, max_examples=5000))
    assert vertices(P, Q) <= 10
    assert all(abs(c) <= 8 for c in numbers(P) + numbers(Q))


@pytest.mark.thorough
def test_a_fault_at_event_scales_shrinks_to_one() -> None:
    """As in a family: test_a_fault_just_at_a_scale_shrinks_within_the_families."""

    def wrong(case: Any) -> bool:
        return Fraction(case["scale"]) in critical_scales(case["P"], case["Q"], "topology")

    case = find(scaled_pairs(kind="topology"), wrong, settings=MANY)
    assert vertices(case["P"], case["Q"]) == 9 and wrong(case)
    assert max(Fraction(case["scale"]).as_integer_ratio()) <= 6


def overflows(*operands: SetData) -> bool:
    return any(abs(c) > 2**24 for data in operands for c in numbers(data))


def test_overflow_shrinks_to_the_first_number_that_does() -> None:
    data = find(polygons(magnitude=10**9, holes=0), overflows, settings=MANY)
    assert vertices(data) <= 4
    assert max(map(abs, numbers(data))) == 2**24 + 1


@pytest.mark.thorough
def test_overflow_that_loses_holes_shrinks_to_the_first_number_that_does() -> None:
    """Both at once: test_overflow_shrinks_to_the_first_number_that_does."""

    def wrong(pair: tuple[SetData, SetData]) -> bool:
        return overflows(*pair) and loses_holes(*pair)

    P, Q = find(pairs(magnitude=10**9), wrong, settings=settings(MANY, max_examples=1000))
    assert vertices(P, Q) <= 10
    assert max(abs(c) for c in numbers(P) + numbers(Q)) <= 2**25


def test_a_fault_just_at_a_scale_shrinks_within_the_families() -> None:
    def counts(case: Any, factor: Fraction) -> tuple[int, int]:
        result = true_sum(case["P"], case["Q"], str(Fraction(case["scale"]) * factor))
        return result.components, result.holes

    def wrong(case: Any) -> bool:
        return counts(case, Fraction(1)) != counts(case, 1 - Fraction(1, 2**300))

    if THOROUGH:
        case = find(degenerate_pairs(), wrong, settings=MANY)
        assert vertices(case["P"], case["Q"]) <= 12
    case = find(degenerate_pairs("hole-to-polyline"), wrong, settings=MANY)
    assert vertices(case["P"], case["Q"]) <= 13
    assert all(abs(c) <= 4 and c.denominator == 1 for c in numbers(case["P"]) + numbers(case["Q"]))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: polygons(max_vertices=2), "max_vertices is 2: give a number of at least 3"),
        (lambda: pairs(magnitude=0), "magnitude is 0: give a number of at least 1"),
        (lambda: polygons(denominators=()), "give numbers of at least 1"),
        (lambda: degenerate_pairs("fits-hol"), "did you mean fits-hole?"),
        (lambda: degenerate_pairs("?"), "the families are parallel-same, "),
        (lambda: scales_near_events({"polygons": []}, {"polygons": []}, bits=0), "at least 1"),
    ],
)
def test_refusals(call: Callable[[], object], words: str) -> None:
    with pytest.raises(ValueError, match=re.escape(words)):
        call()


def test_floats_are_not_taken_for_exact_numbers() -> None:
    with pytest.raises(TypeError, match="give Fraction"):
        to_data({"polygons": [{"outer": [(0.5, 0), (1, 0), (0, 1)]}]})


def test_minkref_needs_no_hypothesis() -> None:
    code = (
        "import sys; sys.modules['hypothesis'] = None\n"
        "import minkref; minkref.PolygonSet\n"
        "try:\n    import minkref.strategies\n"
        "except ImportError as error:\n    print(error)\n"
    )
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "pip install 'minkref[strategies]'" in ran.stdout


@pytest.fixture(scope="module")
def documented() -> tuple[str, str]:
    """The page's example and its printed output."""
    text = DOCS.read_text(encoding="utf-8")
    assert f"with Hypothesis {hypothesis.__version__}," in text
    assert all(name in text for name in ("DEGENERATE_FAMILIES", "to_fractions", "to_data"))
    code = re.search(r"```python\n(.*?)```", text, re.S)
    shown = re.search(r"```\n(Failing test case.*?)```", text, re.S)
    assert code and shown
    return code[1], shown[1].strip()


@pytest.mark.parametrize("name", some(["example.py", "another/place/my_sum.py"], 1))
def test_the_documented_example(documented: tuple[str, str], tmp_path: Path, name: str) -> None:
    code, shown = documented
    path = tmp_path / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(code, encoding="utf-8")
    ran = subprocess.run(
        [sys.executable, path.name], cwd=path.parent, capture_output=True, text=True
    )
    assert ran.returncode == 1 and shown in ran.stderr
