"""`minkref.convolution`: edges with their parents, by each reading of the compatibility rule."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction

import minkref
import pytest
from minkref import Convolution, ConvolutionEdge, PolygonSet, _core, convolution
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.plane.convolution_values import COMPATIBLE, Place
from minkref.plane.exact_frame import exact_polygons

SEED = 4
SQUARE = PolygonSet([(0, 0), (1, 0), (1, 1), (0, 1)])
CROSSED = minkref.read_text("POLYGON((0 0,1 1,1 0,0 1,0 0))", "wkt")
NAMES = ("random", "collinear", "cells", "fit", "touching", "degenerate", "lattice", "rational")
PAIRS = [(name, index) for name in NAMES for index in (1, 4, 9, 16, 25)]
EACH = pytest.mark.parametrize(("family", "index"), PAIRS)


def drawn(family: str, index: int) -> tuple[PolygonSet, PolygonSet, str]:
    pair = FAMILIES[family].pair(SEED, index)
    return PolygonSet.from_json(pair.P), PolygonSet.from_json(pair.Q), str(pair.scale)


def rings(region: PolygonSet) -> list[list[Place]]:
    return [ring for polygon in exact_polygons(region) for ring in polygon]


def parents(edges: Convolution) -> Counter[tuple[object, ...]]:
    return Counter((edge.kind, edge.edge, edge.vertex, edge.sign) for edge in edges)


@EACH
@pytest.mark.parametrize("full", [False, True])
def test_edges_are_their_parents_placed(family: str, index: int, full: bool) -> None:
    P, Q, scale = drawn(family, index)
    of_p, of_q, s = rings(P), rings(Q), Fraction(scale)
    found = convolution(P, Q, scale, full)
    rows = (_core.full_convolution if full else _core.reduced_convolution)(P, Q)
    assert len(found) == len(rows)
    for edge, row in zip(found, rows, strict=True):
        assert (edge.kind, edge.sign, *edge.edge, *edge.vertex) == row
        moving, resting = (of_p, of_q) if edge.kind == "S" else (of_q, of_p)
        ring, at = moving[edge.edge[0]], resting[edge.vertex[0]][edge.vertex[1]]
        first, last = ring[edge.edge[1]], ring[(edge.edge[1] + 1) % len(ring)]
        a, b = (s, 1) if edge.kind == "S" else (1, s)  # of the edge and of the vertex
        start, end = ((a * x + b * at[0], a * y + b * at[1]) for x, y in (first, last))
        assert (edge.start, edge.end) == (start, end)
        assert edge.direction == (end[0] - start[0], end[1] - start[1])


@EACH
@pytest.mark.parametrize("full", [False, True])
def test_open_is_a_part_of_half_open_and_that_of_closed(
    family: str, index: int, full: bool
) -> None:
    P, Q, scale = drawn(family, index)
    half, less, more = (parents(convolution(P, Q, scale, full, each)) for each in COMPATIBLE)
    assert less <= half <= more
    assert max(more.values(), default=1) == 1  # none is there twice


def test_readings_differ_where_edges_are_parallel() -> None:
    counts = [len(convolution(SQUARE, SQUARE, compatible=each)) for each in COMPATIBLE]
    assert counts == [8, 0, 16]
    turned = PolygonSet([(0, 0), (5, 1), (4, 6), (-1, 5)])
    assert len({len(convolution(SQUARE, turned, compatible=each)) for each in COMPATIBLE}) == 1


def pieces_along(
    start: Place, end: Place, edges: list[ConvolutionEdge]
) -> list[tuple[Fraction, ...]]:
    """The parts of the segment, from 0 to 1, that edges along its direction cover."""
    along = (end[0] - start[0], end[1] - start[1])
    square = along[0] ** 2 + along[1] ** 2

    def turn(to: Place) -> Fraction:
        return along[0] * to[1] - along[1] * to[0]

    def share(at: Place) -> Fraction:
        return ((at[0] - start[0]) * along[0] + (at[1] - start[1]) * along[1]) / square

    parts = []
    for edge in edges:
        d = edge.direction
        beside = turn((edge.start[0] - start[0], edge.start[1] - start[1]))
        if turn(d) == 0 and beside == 0 and d[0] * along[0] + d[1] * along[1] > 0:
            parts.append((max(share(edge.start), Fraction(0)), min(share(edge.end), Fraction(1))))
    return sorted(part for part in parts if part[0] < part[1])


def is_covered(start: Place, end: Place, edges: list[ConvolutionEdge]) -> bool:
    reached = Fraction(0)
    for first, last in pieces_along(start, end, edges):
        if first > reached:
            return False
        reached = max(reached, last)
    return reached == 1


def sides(region: PolygonSet) -> list[tuple[Place, Place]]:
    return [
        (ring[i], ring[(i + 1) % len(ring)])
        for ring in rings(region)
        if len(ring) > 2
        for i in range(len(ring))
    ]


@EACH
@pytest.mark.parametrize("compatible", ["half-open", "closed"])
def test_the_boundary_of_the_sum_is_covered(family: str, index: int, compatible: str) -> None:
    """The sum comes from the definition, which does not use the convolution."""
    P, Q, scale = drawn(family, index)
    edges = list(convolution(P, Q, scale, compatible=compatible))
    region = _core.minkowski_sum(P, Q, scale, "definition").region
    bare = [side for side in sides(region) if not is_covered(*side, edges)]
    assert bare == []


def test_the_open_reading_leaves_sides_bare_and_the_closed_one_covers_them_twice() -> None:
    wide = PolygonSet([(0, 0), (4, 0), (4, 1), (2, 3), (0, 1)])
    region = minkref.minkowski_sum(wide, SQUARE, "1/2").region
    half, less, more = (
        list(convolution(wide, SQUARE, "1/2", compatible=each)) for each in COMPATIBLE
    )
    bare = [side for side in sides(region) if not is_covered(*side, less)]
    assert 0 < len(bare) < len(sides(region))
    for start, end in bare:
        once, twice = (
            sum(last - first for first, last in pieces_along(start, end, edges))
            for edges in (half, more)
        )
        assert (once, twice) == (1, 2)


@EACH
def test_the_full_convolution_is_a_closed_signed_cycle(family: str, index: int) -> None:
    P, Q, scale = drawn(family, index)
    balance: Counter[Place] = Counter()
    for edge in convolution(P, Q, scale, full=True):
        balance[edge.start] += edge.sign
        balance[edge.end] -= edge.sign
    assert not any(balance.values())


def test_it_is_a_sequence() -> None:
    found = convolution(SQUARE, SQUARE, Fraction(1, 3))
    edges = list(found)
    assert [found[i] for i in range(len(found))] == edges
    assert (found[-1], found[2:5]) == (edges[-1], edges[2:5])
    assert edges[0] in found
    with pytest.raises(IndexError, match="8 edges, and no number 8"):
        found[8]
    assert repr(found) == "<Convolution: 8 edges, reduced, half-open>"
    with pytest.raises(IndexError):
        _core.Convolution(SQUARE, SQUARE, "1").rows(3, 9)


@pytest.mark.parametrize(
    ("words", "code"),
    [
        ((SQUARE, SQUARE, 0), "bad-scale"),
        ((SQUARE, SQUARE, "-7/5"), "bad-scale"),
        ((SQUARE, SQUARE, "x"), "not-a-number"),
        ((SQUARE, SQUARE, 1, False, "half"), "unknown-reading"),
        ((CROSSED, SQUARE), "self-intersection"),
    ],
)
def test_what_is_no_pair_scale_or_reading_is_refused(words: tuple[object, ...], code: str) -> None:
    with pytest.raises((minkref.BadInput, minkref.Refusal)) as error:
        convolution(*words)  # type: ignore[arg-type]
    assert error.value.code == code


def test_more_edges_than_there_is_memory_for_are_refused() -> None:
    ring = [(x, x * x) for x in range(2000)]
    many = PolygonSet(ring)
    minkref.set_memory_limit(1 << 20)
    try:
        with pytest.raises(minkref.LimitExceeded) as error:
            convolution(many, many, full=True)
    finally:
        minkref.set_memory_limit(None)
    assert error.value.code == "memory-limit"
