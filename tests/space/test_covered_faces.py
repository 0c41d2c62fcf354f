"""A result made from many overlapping or abutting convex shells is proven right, or found wrong."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from fractions import Fraction
from itertools import product

import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space import comparison
from minkref.fuzz.space.comparison import compare
from minkref.fuzz.space.covered_faces import CoveredFaces
from minkref.fuzz.space.families import drawn_pair
from minkref.fuzz.space.generators.convex import box
from minkref.fuzz.space.hull import convex_hull
from minkref.fuzz.space.pair import SpacePair
from minkref.fuzz.space.pairs import pair_of_cells, space_pair
from minkref.fuzz.verdicts.verdict import Reason

NOTHING = Polyhedron((), ())
CASES = [("polycube", 2, 15), ("polycube", 3, 22), ("hollow", 1, 12), ("frame", 1, 3)]


def together(shells: Iterable[Polyhedron]) -> Polyhedron:
    result = NOTHING
    for shell in shells:
        result = result.with_faces_of(shell)
    return result


def blocks(pair: SpacePair) -> list[Polyhedron]:
    """The sum of each cell pair: a box."""
    s = pair.meeting.scale
    found = []
    for p, q in product(sorted(pair.P_cells), sorted(pair.Q_cells)):
        low = tuple(f * a + b for f, a, b in zip(s, p, q, strict=True))
        high = tuple(f * (a + 1) + b + 1 for f, a, b in zip(s, p, q, strict=True))
        found.append(box((low[0], low[1], low[2]), (high[0], high[1], high[2])))
    return found


def tetrahedra(block: Polyhedron) -> list[Polyhedron]:
    """Cuts a block into tetrahedra from an inner point that is not the middle."""
    (a, b, c), (x, y, z) = block.box
    apex: Point = (a + (x - a) / 3, b + 2 * (y - b) / 5, c + (z - c) / 7)
    return [
        convex_hull([apex, *(block.vertices[k] for k in triangle)]) for triangle in block.triangles
    ]


@pytest.mark.parametrize(("family", "seed", "index"), CASES)
def test_boxes_that_overlap(family: str, seed: int, index: int) -> None:
    pair = space_pair(family, seed, index)
    assert compare(pair, together(blocks(pair))).proven


@pytest.mark.parametrize(("family", "seed", "index"), CASES[:2])
def test_boxes_in_tetrahedra(family: str, seed: int, index: int) -> None:
    pair = space_pair(family, seed, index)
    assert compare(pair, together(t for b in blocks(pair) for t in tetrahedra(b))).proven


def test_a_block_too_few_or_too_many() -> None:
    pair = space_pair("polycube", 2, 15)
    boxes = blocks(pair)
    parts = [t for b in boxes for t in tetrahedra(b)]
    far = boxes[0].translated((Fraction(100), Fraction(0), Fraction(0)))
    for extra in ([far], tetrahedra(far)):
        found = compare(pair, together([*parts, *extra]))
        assert found.verdict == "wrong" and Reason.MISSING not in found.reasons
    low = min(boxes, key=lambda b: b.box)
    fewer = together(t for b in boxes if b is not low for t in tetrahedra(b))
    found = compare(pair, fewer)
    assert found.verdict == "wrong" and found.reasons and Reason.EXTRA not in found.reasons


def test_cavities_of_several_shells_leave_the_others_covering() -> None:
    """Two separate boxes with a cavity each, and elsewhere two nested blocks."""
    hollow = [
        body
        for x in (0, 100)
        for body in (
            block(f"{x} 0 0", f"{x + 9} 9 9"),
            block(f"{x + 3} 3 3", f"{x + 6} 6 6").turned_inside_out(),
        )
    ]
    inner, outer = block("51 1 1", "52 2 2"), block("50 0 0", "53 3 3")
    result = together([*hollow, outer, inner])
    covered = CoveredFaces(result)
    left = [any(covered.left(triple)) for triple in result.triangles]
    assert left == [True] * 12 * 5 + [False] * 12


def sums_of_triangles(pair: SpacePair) -> Polyhedron:
    """Each operand at a vertex of the other, and the sums of all triangle pairs: right, with most
    triangles inside."""
    P, Q = pair.P.scaled(pair.meeting.scale), pair.Q
    bodies = [P.translated(Q.vertices[0]), Q.translated(P.vertices[0])]
    for a, b in product(P.triangles, Q.triangles):
        corners = [
            tuple(x + y for x, y in zip(P.vertices[i], Q.vertices[j], strict=True))
            for i in a for j in b
        ]  # fmt: skip
        with suppress(ValueError):  # they are parallel
            bodies.append(convex_hull([(x, y, z) for x, y, z in corners]))
    return together(bodies)


@pytest.mark.parametrize(
    ("family", "index"),
    [
        ("space-cavity", 1),
        pytest.param("space-cup", 3, marks=pytest.mark.thorough),  # 443 triangles cut each other
    ],
)
def test_faces_inside_that_cut_each_other(
    family: str, index: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    pair = drawn_pair(family, 1, index)
    result = sums_of_triangles(pair)
    assert compare(pair, result).proven
    monkeypatch.setattr(comparison, "MOST_PIECES", 20)
    found = compare(pair, result)
    assert found.verdict == "undecided"
    assert found.message == "triangles off the boundary of the sum have more than 20 pieces"


def block(low: str, high: str) -> Polyhedron:
    (a, b, c), (x, y, z) = ([Fraction(number) for number in text.split()] for text in (low, high))
    return box((a, b, c), (x, y, z))


HALVES = [block("0 0 0", "2 2 3/2"), block("0 0 1/2", "2 2 2")]
UNIT = frozenset({(0, 0, 0)})
CUBES = pair_of_cells("polycube", UNIT, UNIT, Fraction(1))


@pytest.mark.parametrize("shells", [HALVES, [t for half in HALVES for t in tetrahedra(half)]])
def test_a_hole_that_one_shell_covers_is_found(shells: list[Polyhedron]) -> None:
    """The hole is small and lies amidst a cell."""
    hole = block("1/10 1/5 1/4", "1/5 1/4 1/3").turned_inside_out()
    found = compare(CUBES, together([*shells, hole]))
    assert found.verdict == "wrong" and found.reasons == (Reason.MISSING,)


@pytest.mark.parametrize("shells", [HALVES, [t for half in HALVES for t in tetrahedra(half)]])
def test_a_hole_that_two_shells_cover_is_none(shells: list[Polyhedron]) -> None:
    hole = block("1/10 1/5 3/5", "1/5 1/4 4/5").turned_inside_out()
    found = compare(CUBES, together([*shells, hole]))
    assert found.verdict == "pass" and found.proven


def test_a_cavity_that_is_wound_backwards_far_from_its_shell() -> None:
    """A region wound less than 0 times hides nothing that another shell has there."""
    far = block("5 5 5", "6 6 6")
    for shells in ([far.turned_inside_out(), far], [far.turned_inside_out(), far, far]):
        found = compare(CUBES, together([*HALVES, *shells]))
        extra = len(shells) == 3
        assert (found.verdict == "wrong") == extra and found.verdict != "undecided"
