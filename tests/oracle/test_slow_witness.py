"""Witness points and the check of a claimed set, by the slow engine."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import pytest
from minkref.oracle.slow import (
    InputError,
    Operand,
    check_claim,
    minkowski_sum,
    operand_from_json,
    read_operand,
    witness,
)
from minkref.oracle.slow.exact import Point
from minkref.oracle.slow.operand import Polygon
from minkref.oracle.slow.place import inside, on_boundary
from random_pairs import pair
from thoroughness import draws

SEED = 20123
MODELS = Path(__file__).resolve().parents[2] / "minkref" / "models"


def box(x0: int, y0: int, x1: int, y1: int) -> Operand:
    ring = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
    return operand_from_json({"polygons": [{"outer": ring}]})


def operands(index: int) -> tuple[Operand, Operand]:
    P, Q = (source.operand() for source in pair(SEED, index))
    return (P, Q) if not (P.ends and Q.ends) else operands(index + 1000)


def holds(operand: Operand, point: Point) -> bool:
    if operand.ends:
        (ax, ay), (bx, by) = operand.ends[0], operand.ends[-1]
        x, y = point
        between = min(operand.ends) <= point <= max(operand.ends)
        return between and (bx - ax) * (y - ay) == (by - ay) * (x - ax)
    return on_boundary(operand.rings(), point) or inside(operand.rings(), point)


@pytest.mark.parametrize("index", range(draws(25, 80)))
def test_witness_agrees_with_the_sum_and_its_tight_passages(index: int) -> None:
    """Overlapping inside, touching on the boundary and in tight passages, else disjoint."""
    P, Q = operands(index)
    scale = Fraction(1 + index % 5, 1 + index % 3)
    found = minkowski_sum(P, Q, scale)
    result = Operand(found.polygons, [])
    rings = result.rings()
    rng = random.Random(SEED + index)
    corners = result.points()
    if not corners:
        return
    samples = [(a, b) for a in (corners[0][0], corners[-1][0]) for _, b in corners[:4]]
    samples += [
        (Fraction(rng.randint(-40, 60), 4), Fraction(rng.randint(-40, 60), 4)) for _ in range(12)
    ]
    for (ax, ay), (bx, by) in pairwise(corners):
        samples.append(((ax + bx) / 2, (ay + by) / 2))
    tight = [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for p in found.tight for a, b in pairwise(p)]
    tight += [piece[0] for piece in found.tight]
    for x in samples + tight:
        meeting = witness(P, Q, scale, x)
        if on_boundary(rings, x):
            expected = "touching"
        else:
            expected = "overlapping" if inside(rings, x) else "disjoint"
        if x in tight:
            expected = "touching"
        elif meeting.contact == "touching" and expected == "overlapping":
            # Only a point of a tight passage may do so.
            assert any(on_boundary([piece], x) for piece in found.tight), (SEED, index, x)
            continue
        assert meeting.contact == expected, (SEED, index, scale, x)
        if meeting.p is not None and meeting.q is not None:
            assert holds(P, meeting.p) and holds(Q, meeting.q)
            assert tuple(scale * p + q for p, q in zip(meeting.p, meeting.q, strict=True)) == x


def test_claim_that_is_a_point_is_refused() -> None:
    unit = box(0, 0, 1, 1)
    with pytest.raises(InputError, match="polygon set"):
        check_claim(unit, unit, Fraction(1), Operand([], [(Fraction(0), Fraction(0))]))


def test_claim_with_a_ring_twice_is_taken_by_parity() -> None:
    unit = box(0, 0, 1, 1)
    truth = minkowski_sum(unit, unit)
    twice = Operand([*truth.polygons, *truth.polygons], [])
    found = check_claim(unit, unit, Fraction(1), twice)
    assert not found.equal and found.in_truth


def test_squares_side_by_side_touch() -> None:
    unit = box(0, 0, 1, 1)
    assert witness(unit, unit, Fraction(1), (Fraction(2), Fraction(1))).contact == "touching"
    assert witness(unit, unit, Fraction(1), (Fraction(1), Fraction(1))).contact == "overlapping"
    beside = (Fraction(2) + Fraction(1, 10**30), Fraction(1))
    assert witness(unit, unit, Fraction(1), beside).contact == "disjoint"


def test_witness_at_the_size_of_the_models() -> None:
    P = read_operand(str(MODELS / "glyph1204.poly"))
    Q = read_operand(str(MODELS / "glyph275.poly"))
    far = max(x for x, _ in P.points()) + max(x for x, _ in Q.points()) + 1
    assert witness(P, Q, Fraction(1), (far, Fraction(0))).contact == "disjoint"
    (px, py), (qx, qy) = P.points()[0], Q.points()[0]
    assert witness(P, Q, Fraction(1), (px + qx, py + qy)).in_sum


@pytest.mark.parametrize("index", range(draws(20, 40)))
def test_true_claims_stand_and_false_ones_get_a_point_of_the_difference(index: int) -> None:
    P, Q = operands(index)
    truth = minkowski_sum(P, Q)
    if not truth.polygons:
        return
    assert check_claim(P, Q, Fraction(1), Operand(truth.polygons, [])).canonical
    first = truth.polygons[0]
    turned = [Polygon(first.outer[1:] + first.outer[:1], first.holes), *truth.polygons[1:]]
    same = check_claim(P, Q, Fraction(1), Operand(turned, []))
    assert same.equal and not same.canonical
    wrong = [
        Operand(truth.polygons[1:], []),
        Operand([Polygon(first.outer[1:], first.holes), *truth.polygons[1:]], []),
        Operand([], []),
    ]
    wrong += [Operand([Polygon(p.outer, []) for p in truth.polygons], [])] if first.holes else []
    for claim in wrong:
        if any(len(p.outer) < 3 for p in claim.polygons):
            continue
        found = check_claim(P, Q, Fraction(1), claim)
        assert not found.equal and found.point is not None, (SEED, index)
        in_claim = inside(claim.rings(), found.point)
        assert in_claim != found.in_truth
        assert not on_boundary(claim.rings(), found.point)
        assert found.in_truth == inside(Operand(truth.polygons, []).rings(), found.point)
