"""Events of a disc compared with CGAL's and Boost's Voronoi diagrams, with known diagrams, and with
faults planted into event lists."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.features.outer_diagram import BOOST, CGAL, DiagramJudge, absence
from minkref.fuzz.features.outline import Outline
from minkref.fuzz.judges.disc.diagram_witness import Ruling, settle
from minkref.fuzz.judges.disc.disc_diagram import DiagramComparison, Table, compare, main
from thoroughness import draws

Corners = list[tuple[Any, Any]]
NOTCHED: list[Corners] = [
    [(0, 0), (8, 0), (8, 6), (5, 6), (5, 2), (3, 2), (3, 6), (0, 6)],
]  # fmt: skip
SIDE_BY_SIDE: list[Corners] = [
    [(0, 0), (2, 0), (2, 2), (0, 2)], [(3, 0), (5, 0), (5, 2), (3, 2)],
]  # fmt: skip


def polygons(*each: list[Corners]) -> _core.PolygonSet:
    """From outer rings with their holes."""

    def ring(corners: Corners) -> list[list[str]]:
        return [[str(x), str(y)] for x, y in corners]

    found = [{"outer": ring(rings[0]), "holes": [ring(h) for h in rings[1:]]} for rings in each]
    return _core.PolygonSet.from_json(json.dumps({"polygons": found}))


def rows_of(P: _core.PolygonSet) -> list[Any]:
    rows: list[Any] = _core.diagram_events(P).rows(0, 10**9)
    return rows


def notched() -> _core.PolygonSet:
    return polygons(NOTCHED)


def two_squares() -> _core.PolygonSet:
    return polygons([SIDE_BY_SIDE[0]], [SIDE_BY_SIDE[1]])


def octagonal_hole() -> _core.PolygonSet:
    """The hole's edges touch the circle of radius 5 about the origin: its normals come from the
    triangle 3, 4, 5, turned by quarters and mirrored."""
    normals = [(1, 0), (4, 3), (3, 4), (0, 1), (-3, 4), (-4, 3), (-1, 0), (-4, -3), (-3, -4),
               (0, -1), (3, -4), (4, -3)]  # fmt: skip
    lines = [(Fraction(a), Fraction(b), Fraction(5 if a * b == 0 else 25)) for a, b in normals]
    corners: Corners = []
    for (a, b, c), (d, e, f) in zip(lines, [*lines[1:], lines[0]], strict=True):
        turn = a * e - b * d
        corners.append(((c * e - f * b) / turn, (a * f - d * c) / turn))
    frame = [(-9, -9), (9, -9), (9, 9), (-9, 9)]
    return polygons([frame, corners[::-1]])


@pytest.fixture(params=[CGAL, BOOST])
def judge(request: pytest.FixtureRequest) -> str:
    missing = absence(request.param)
    if missing:
        pytest.skip(missing)
    return str(request.param)


def places(judge: str, P: _core.PolygonSet) -> set[tuple[float, ...]]:
    """Place, distance and feature count, in the set's own coordinates."""
    outline = Outline.of(P)
    with DiagramJudge(judge, 60) as asked:
        answer = asked.vertices(outline)
    assert answer.vertices is not None, answer.why
    x, y = map(float, outline.origin)
    found = [(v.x + x, v.y + y, v.radius) for v in answer.vertices]
    return {tuple(round(c, 12) + 0.0 for c in each) for each in found}


def differences(
    judge: str, P: _core.PolygonSet, change: Callable[[list[Any]], None] | None = None
) -> list[str]:
    rows = rows_of(P)
    if change is not None:
        change(rows)
    table = Table()
    with DiagramComparison([judge]) as comparison:
        comparison.compare("here", P, rows, table)
    assert table.unanswered == [] and table.refuted == []
    assert (table.wrong == {"here"}) == bool(table.differences)
    return table.differences


def test_a_notch_has_a_vertex_over_its_floor_and_one_at_its_mouth(judge: str) -> None:
    """The walls are 2 apart: as far from both and the floor at the height 1, and at the mouth from
    the walls and their ends."""
    assert places(judge, notched()) == {(4, 3, 1), (4, 6, 1)}
    assert differences(judge, notched()) == []


def test_a_hole_around_a_circle_has_one_vertex_of_all_its_edges(judge: str) -> None:
    P = octagonal_hole()
    assert places(judge, P) == {(0, 0, 5)}
    assert differences(judge, P) == []
    (row,) = rows_of(P)
    assert row[0] == "maximum" and row[1] == "25" and len(row[5]) == 12


def test_two_squares_have_a_ridge_with_two_ends(judge: str) -> None:
    assert places(judge, two_squares()) == {(2.5, 0, 0.5), (2.5, 2, 0.5)}
    assert differences(judge, two_squares()) == []


def test_a_straight_vertex_makes_no_event(judge: str) -> None:
    """Libraries have a vertex in front of the straight vertex, where a third feature is equally
    near: on the ridge."""
    bent = [(3, 0), (5, 0), (5, 2), (3, 2), (3, 1)]
    P = polygons([SIDE_BY_SIDE[0]], [bent])
    assert differences(judge, P) == []
    outline = Outline.of(P)
    with DiagramJudge(judge, 60) as asked:
        assert asked.vertices(outline).straight > 0


def test_a_vertex_that_touches_an_edge_splits_it_for_the_judge_alone(judge: str) -> None:
    P = polygons([[(0, 0), (6, 0), (6, 1), (0, 1)]], [[(2, 3), (3, 1), (4, 3)]])
    assert differences(judge, P) == []
    touching = polygons([[(0, 0), (6, 0), (6, 4), (0, 4)], [(3, 4), (4, 2), (2, 2)]])
    assert differences(judge, touching) == []


def test_sets_of_all_families_have_the_vertices_of_both() -> None:
    for missing in filter(None, map(absence, (CGAL, BOOST))):
        pytest.skip(missing)
    table = Table()
    compare(11, range(count := draws(40, 120)), table)
    assert table.differences == []
    assert table.counts["events"] > 10 * count / 3 and table.counts["saddles"] > count / 12
    assert table.counts[f"vertices of {BOOST}"] == table.counts["events"]


def over_floor(rows: list[Any]) -> int:
    """The number of the event at (4, 3), for the notch."""
    return [row[4] for row in rows].index((4.0, 3.0))


def test_a_dropped_event_is_found(judge: str) -> None:
    (told,) = differences(judge, notched(), lambda rows: rows.__delitem__(over_floor(rows)))
    assert "dropped at (4, " in told and "proven to be as far" in told


def test_an_event_that_was_moved_is_found(judge: str) -> None:
    def change(rows: list[Any]) -> None:
        at = over_floor(rows)
        rows[at] = (*rows[at][:4], (4 + 1e-6, 3.0), rows[at][5])

    assert sorted(told.split(": ")[1].split(" at ")[0] for told in named(judge, change)) == [
        "dropped", "invented",
    ]  # fmt: skip


def named(judge: str, change: Callable[[list[Any]], None]) -> list[str]:
    return differences(judge, notched(), change)


def test_an_invented_event_is_found(judge: str) -> None:
    """At the middle of the ridge, with the floor for a third feature."""

    def change(rows: list[Any]) -> None:
        row = rows[over_floor(rows)]
        rows.append((*row[:4], (4.0, 5.0), row[5]))

    (told,) = named(judge, change)
    assert "invented at (4, 5)" in told and "alone" in told


def test_a_missing_and_a_false_feature_are_found(judge: str) -> None:
    def without_one(rows: list[Any]) -> None:
        rows[0] = (*rows[0][:5], rows[0][5][:3])

    def with_one_more(rows: list[Any]) -> None:
        rows[0] = (*rows[0][:5], [*rows[0][5], ("vertex", "0", "0")])

    found = differences(judge, two_squares(), without_one)
    assert any("dropped at (2.5, " in told for told in found)
    (told,) = differences(judge, two_squares(), with_one_more)
    assert "features at" in told and "vertex 0 0 is farther" in told


def test_an_event_told_twice_and_wrong_bounds_of_its_radius_are_found(judge: str) -> None:
    def twice(rows: list[Any]) -> None:
        rows.append(rows[over_floor(rows)])

    def wider(rows: list[Any]) -> None:
        at = over_floor(rows)
        rows[at] = (*rows[at][:3], (1.1, 1.2), *rows[at][4:])

    (told,) = named(judge, twice)
    assert "twice at (4, 3)" in told
    (told,) = named(judge, wider)
    assert "radius at (4, " in told


def test_a_saddle_that_is_missing_moved_or_invented_is_found(judge: str) -> None:
    """Two triangles with tips 2 apart."""
    P = polygons([[(0, 0), (3, 1), (0, 2)]], [[(5, 1), (8, 0), (8, 2)]])
    (at,) = [k for k, row in enumerate(rows_of(P)) if len(row[5]) == 2]
    assert rows_of(P)[at][1] == "1"

    def larger(rows: list[Any]) -> None:
        rows[at] = (rows[at][0], "2", *rows[at][2:])

    def another(rows: list[Any]) -> None:
        rows.append((*rows[at][:5], [("vertex", "0", "0"), ("vertex", "8", "0")]))

    assert differences(judge, P) == []
    (told,) = differences(judge, P, lambda rows: rows.__delitem__(at))
    assert "saddle dropped at (4, 1)" in told
    (told,) = differences(judge, P, larger)
    assert "saddle radius" in told
    (told,) = differences(judge, P, another)
    assert "saddle invented" in told


def test_a_witness_tells_a_vertex_from_what_is_none() -> None:
    outline = Outline(NOTCHED)
    left, right, floor = (outline.edge(0, k) for k in (5, 3, 4))
    features = frozenset({left, right, floor})
    ruling, why = settle(outline, features, (4 + 1e-9, 3), 1.0)
    assert ruling is Ruling.VERTEX, why
    ruling, why = settle(outline, features, (4, 4), 1.0)
    assert ruling is Ruling.NONE and "alone" in why
    ruling, why = settle(outline, features | {outline.vertex("0", "0")}, (4, 3), 1.0)
    assert ruling is Ruling.NONE and "farther" in why
    top = ("vertex", Fraction(3), Fraction(6))
    corner = ("vertex", Fraction(8), Fraction(0))
    ruling, why = settle(outline, frozenset({left, right, top}), (4, 6), 1.0)
    assert ruling is Ruling.PART and "vertex 5 6" in why
    far = frozenset({top, corner, ("vertex", Fraction(0), Fraction(0))})
    ruling, why = settle(outline, far, (4.0, 2.25), 4.0)
    assert ruling is not Ruling.VERTEX


def test_a_wrong_answer_of_boost_is_refuted_by_a_proof() -> None:
    """The notch's floor and walls are equally far from a point half a unit of Boost's grid above
    the mouth."""
    if missing := absence(BOOST):
        pytest.skip(missing)
    wall = 5 - Fraction(1, 2**20)
    P = polygons([[(0, 0), (1, 0), (1, 2), (wall, 2), (wall, 0), (7, 0), (7, 3), (0, 3)]])
    rows = rows_of(P)
    table = Table()
    with DiagramComparison([BOOST]) as comparison:
        comparison.compare("near a tie", P, rows, table)
    assert table.differences == [] and table.counts["events"] == 2
    assert all("nearer" in told or "proven to be as far" in told for told in table.refuted)
    assert differences_or_skip(P) == []


def differences_or_skip(P: _core.PolygonSet) -> list[str]:
    if missing := absence(CGAL):
        pytest.skip(missing)
    return differences(CGAL, P)


def test_coordinates_that_doubles_do_not_hold_are_exact_for_cgal_and_too_long_for_boost() -> None:
    for missing in filter(None, map(absence, (CGAL, BOOST))):
        pytest.skip(missing)
    tiny = Fraction(1, 10**20)
    P = polygons([[(0, 0), (2, 0), (2 + tiny, 2), (0, 2)]], [SIDE_BY_SIDE[1]])
    outline = Outline.of(P)
    with DiagramJudge(CGAL, 60) as cgal, DiagramJudge(BOOST, 60) as boost:
        found, refused = cgal.vertices(outline), boost.vertices(outline)
    assert found.vertices is not None and len(found.vertices) == 4
    assert refused.vertices is None and "32 bits" in refused.why


def test_the_command_compares_sets(capsys: pytest.CaptureFixture[str]) -> None:
    for missing in filter(None, map(absence, (CGAL, BOOST))):
        pytest.skip(missing)
    assert main(["5", "20"]) == 0
    assert json.loads(capsys.readouterr().out)["differences"] == []
