"""Judges of sums in space: right answers pass, and a proven point settles wrong answers."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from functools import cache

import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.space.space_laws import LAWS
from minkref.fuzz.judges.space.space_nef import NefJudge
from minkref.fuzz.judges.space.space_sums import SpaceSums, moved
from minkref.fuzz.space.general_pairs import GeneralPair, general_pair
from minkref.fuzz.space.generators.machined import cup, plate
from minkref.fuzz.space.generators.mapped import unimodular
from minkref.oracle.slow import (
    SolidSum,
    exposed_from_json,
    of_faces,
    solid_from_json,
    uniform,
    whole_sum,
)

SEED = 6021
ONE = Fraction(1)
CUP = cup(2, 2, 2, (1, 1, 2, 1), 1)


@cache
def truth(P: Polyhedron, Q: Polyhedron, scale: Fraction) -> str:
    first, second = (solid_from_json(solid.document()) for solid in (P, Q))
    return whole_sum(SolidSum(first, second, uniform(scale))).text()


def hull_of_boxes(P: Polyhedron, Q: Polyhedron, scale: Fraction) -> str:
    """A wrong route: the sum of the boxes around the operands."""
    low, high = (
        tuple(scale * a + b for a, b in zip(P.box[k], Q.box[k], strict=True)) for k in (0, 1)
    )
    sides = [b - a for a, b in zip(low, high, strict=True)]
    body = plate(1, 1, 1).scaled((sides[0], sides[1], sides[2]))
    faces = solid_from_json(body.translated((low[0], low[1], low[2])).document()).faces
    return of_faces(faces).text()


def without_a_plane(P: Polyhedron, Q: Polyhedron, scale: Fraction) -> str:
    document = json.loads(truth(P, Q, scale))
    del document["planes"][1]
    return json.dumps(document, separators=(",", ":"))


def not_canonical(P: Polyhedron, Q: Polyhedron, scale: Fraction) -> str:
    document = json.loads(truth(P, Q, scale))
    outer = document["planes"][0]["region"]["polygons"][0]["outer"]
    outer.append(outer.pop(0))
    return json.dumps(document, separators=(",", ":"))


def judged(pair: GeneralPair, **routes: object) -> SpaceSums:
    sums = SpaceSums(pair)
    with NefJudge(20) as nef:
        sums.ask(routes, nef)  # type: ignore[arg-type]
    sums.compare(20)
    return sums


def test_right_answers_pass() -> None:
    sums = judged(GeneralPair("cup", plate(1, 1, 1), CUP, ONE), right=truth)
    assert sums.messages == []
    assert {"right", "slow engine"} <= set(sums.answers)
    assert sums.compared["points"] == 20


@pytest.mark.parametrize(("scale", "proof"), [("1", "is outside, proven"), ("5", "")])
def test_a_filled_cup_is_settled_by_a_point(scale: str, proof: str) -> None:
    """At the scale 5 the cube fills the cup up, and the answer is right."""
    pair = GeneralPair("cup", plate(1, 1, 1), CUP, Fraction(scale))
    messages = judged(pair, right=truth, boxes=hull_of_boxes).messages
    assert bool(messages) == bool(proof)
    assert all(proof in message for message in messages), messages
    if proof:
        assert messages[0].startswith("cup at 1: right and boxes differ (they wind 0 and 1 times")


def test_a_face_that_is_not_there() -> None:
    pair = GeneralPair("cup", plate(1, 1, 1), CUP, ONE)
    messages = judged(pair, right=truth, open=without_a_plane).messages
    assert any("open: edges do not cancel along" in message for message in messages)


def test_a_ring_that_starts_elsewhere() -> None:
    pair = GeneralPair("cup", plate(1, 1, 1), CUP, ONE)
    messages = judged(pair, right=truth, turned=not_canonical).messages
    assert any("turned: the text is not canonical" in message for message in messages)


def test_a_refusal_is_a_disagreement() -> None:
    def refuses(P: Polyhedron, Q: Polyhedron, scale: Fraction) -> str:
        raise ValueError("no")

    messages = judged(GeneralPair("cup", plate(1, 1, 1), CUP, ONE), no=refuses).messages
    assert messages == ["cup at 1: route no gives no sum: ValueError: no"]


def two_parts() -> GeneralPair:
    one, other = plate(1, 1, 1), CUP.translated((Fraction(2), Fraction(0), Fraction(0)))
    return GeneralPair("two", one.with_faces_of(other), plate(1, 2, 1), ONE, parts=(one, other))


@pytest.mark.parametrize("law", LAWS)
def test_laws_hold_of_the_slow_engine_and_not_of_what_is_no_sum(law: str) -> None:
    def shifted(P: Polyhedron, Q: Polyhedron, scale: Fraction) -> str:
        """Errs by a shift that depends on the first vertex and on both face counts."""
        wrong = Fraction(len(P.faces) + 3 * len(Q.faces) + P.vertices[0][0] ** 2, 7)
        rows = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        return moved(truth(P, Q, scale), rows, (wrong, wrong, wrong))

    pair = two_parts()
    for route, right in ((truth, True), (shifted, False)):
        text = route(pair.P, pair.Q, pair.scale)
        found = list(LAWS[law](pair, route, text, random.Random(SEED)))
        assert found and all(found) == right, (law, found)


def test_a_set_moved_is_the_set_of_the_moved_solid() -> None:
    dice = random.Random(SEED)
    for index in range(12):
        solid = general_pair(SEED, index).P
        if solid.is_thin or len(solid.faces) > 20:
            continue
        matrix = unimodular(dice, 2)
        image = truth(solid, Polyhedron(((ONE, ONE, ONE),), ()), ONE)
        plain = of_faces(solid_from_json(solid.document()).faces)
        assert image == plain.mapped(((1, 0, 0), (0, 1, 0), (0, 0, 1)), (ONE, ONE, ONE)).text()
        there = plain.mapped(matrix, (ONE, ONE, ONE))
        assert there.volume() == plain.volume()
        inverse = _inverse(matrix)
        back = tuple(-sum(row) * ONE for row in inverse)
        assert there.mapped(inverse, (back[0], back[1], back[2])).text() == plain.text()
        assert exposed_from_json(json.loads(there.text())) == there


def _inverse(m: tuple[tuple[int, int, int], ...]) -> tuple[tuple[int, int, int], ...]:
    def minor(i: int, j: int) -> int:
        a, b = (k for k in range(3) if k != i)
        c, d = (k for k in range(3) if k != j)
        return (-1) ** (i + j) * (m[a][c] * m[b][d] - m[a][d] * m[b][c])

    size = sum(m[0][j] * minor(0, j) for j in range(3))
    rows = [[minor(j, i) * size for j in range(3)] for i in range(3)]
    return tuple((row[0], row[1], row[2]) for row in rows)
