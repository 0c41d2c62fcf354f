"""Degenerate families of general polyhedra: both routes and an independent judge find the same
sums."""

from __future__ import annotations

import json
import random
from fractions import Fraction

import pytest
from boxes_of_cells import euler_by_points, sum_by_boxes
from minkref import _core
from minkref.degeneracies.catalogue import SOLID_FAMILIES
from minkref.exact import digest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.space.space_routes import core_polyhedron, routes
from minkref.oracle.slow import (
    SolidSum,
    exposed_from_json,
    open_lines,
    solid_faults,
    solid_from_json,
    uniform,
    whole_sum,
)
from solid_members import COUNT, SEED, documents, operands, scales
from thoroughness import THOROUGH, draws

POINTS = draws(4, 8)  # of the slow engine, where it cannot make the sum whole
MOST_PAIRS = 4  # of convex pieces, for it to do so


@pytest.mark.parametrize("name", SOLID_FAMILIES)
def test_both_routes_and_a_judge_find_the_sum(name: str) -> None:
    """Judges polycubes as boxes, few pairs of pieces whole, other sums at points on faces and in
    space. Tests the case's scale; for some families neighbouring scales too, if few are drawn."""
    for number, value in enumerate(documents(name)):
        P, Q = operands(value)
        assert set(routes()) == {"edges", "definition"}
        rows = list(zip(scales(value), value["expected"], strict=True))
        beside = list(SOLID_FAMILIES).index(name) % 3 == 0
        for s, expected in rows if THOROUGH else rows[: 1 + beside]:
            texts = {route(P, Q, s) for route in routes().values()}
            (text,) = texts
            assert digest(text) == expected["digest"], value["id"]
            found = exposed_from_json(json.loads(text))
            assert len(found.planes) == expected["planes"]
            assert str(found.volume()) == expected["volume"]
            boxes = sum_by_boxes(P, Q, s)
            if boxes is not None:
                assert boxes == text, (value["id"], s)
                continue
            truth = SolidSum(*(solid_from_json(each.document()) for each in (P, Q)), uniform(s))
            if len(truth.pairs) <= MOST_PAIRS:
                assert whole_sum(truth).text() == text, (value["id"], s)
                continue
            assert open_lines(found) == 0
            dice = random.Random(f"{SEED} {name} {number}")
            assert not list(solid_faults(truth, found, dice, points=POINTS)), (value["id"], s)


def test_volumes_are_cubics_of_the_scale_beside_the_event() -> None:
    """A hollow box plus a box: the cavity exists on one side only."""
    for value in documents("solids-cavity-to-point"):
        volumes = [Fraction(expected["volume"]) for expected in value["expected"]]
        P, Q = (solid.scaled(Fraction(1)) for solid in operands(value))
        filled = []
        for s in scales(value):
            sides = [
                s * (b[1] - b[0]) + d[1] - d[0] for b, d in zip(_spans(P), _spans(Q), strict=True)
            ]
            filled.append(sides[0] * sides[1] * sides[2])
        if P.volume == _box_volume(P) and Q.volume != _box_volume(Q) and _is_aligned(Q):
            assert volumes[0] == filled[0]
            assert [v < f for v, f in zip(volumes[1:], filled[1:], strict=True)] == [
                contact == "empty" for contact in value["degeneracy"]["points"][0]["contact"][1:]
            ]


def _spans(solid: Polyhedron) -> list[tuple[Fraction, Fraction]]:
    return list(zip(*solid.box, strict=True))


def _box_volume(solid: Polyhedron) -> Fraction:
    a, b, c = (high - low for low, high in _spans(solid))
    return a * b * c


def _is_aligned(solid: Polyhedron) -> bool:
    return len(set(solid.vertices)) == 16 and all(
        len({v[k] for v in solid.vertices}) == 4 for k in range(3)
    )


def test_the_convolution_winds_zero_times_around_a_point_inside() -> None:
    for value in documents("solids-cup-and-plate"):
        (row,) = value["degeneracy"]["points"]
        assert row["contact"][0] == "overlap" and row["euler"] == 0
        assert "winding-zero" in value["flags"]
        s = scales(value)[0]
        x, y, z = (s * Fraction(a) + Fraction(b) for a, b in zip(row["p"], row["q"], strict=True))
        assert euler_by_points(*operands(value), s, (x, y, z)) == 0


def test_refinement_does_not_change_the_sum() -> None:
    for k in range(COUNT):
        facts, _ = SOLID_FAMILIES["solids-refined"].member(SEED, k)
        assert facts.plain is not None
        assert len(facts.plain[0].vertices) < len(facts.P.given.vertices)
        plain = [core_polyhedron(solid) for solid in facts.plain]
        for s in facts.scales:
            assert _core.edge_sum_in_space(*plain, (str(s),) * 3) == facts.sum(s)
