"""The index's rings through Python bound the sum, in all forms alike; drawn operands too."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from indexed_sums import FORMS, Index, Point, Rings, exact_tracks, integers, points, scales
from minkref import _core
from minkref.strategies import pairs, to_set
from thoroughness import draws

DRAWN = settings(
    derandomize=True, database=None, deadline=None, phases=(Phase.generate, Phase.shrink)
)


def split(rings: Rings, of_vertices: list[Any]) -> list[list[Any]]:
    """By rings."""
    ends = [0, *(int(end) for end in rings.ring_ends)]
    return [of_vertices[a:b] for a, b in pairwise(ends)]


def doubled_area(ring: list[Point]) -> Fraction:
    return sum(
        (a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)),
        Fraction(0),
    )


def region(index: Index, rings: Rings) -> str:
    """The canonical JSON of the set bounded by the rings, according to their features."""
    polygons: dict[int, dict[str, Any]] = {}
    for ring, (is_hole, component, _) in zip(
        split(rings, points(index, rings)), rings.features(), strict=True
    ):
        polygon = polygons.setdefault(component, {"outer": None, "holes": []})
        texts = [[str(x), str(y)] for x, y in ring]
        if is_hole:
            polygon["holes"].append(texts)
        else:
            assert polygon["outer"] is None, "a component with two outer rings"
            polygon["outer"] = texts
    found = _core.PolygonSet.from_json(json.dumps({"polygons": list(polygons.values())}))
    return _core.canonicalize(found)[0].canonical_json()


# The rings themselves.


def test_rings_bound_the_sum_at_and_between_events(index: Index) -> None:
    P, Q = index.P, index.Q
    for scale in scales(index):
        expected = _core.minkowski_sum(P, Q, scale)
        rings = index.rings(scale, "rational")
        assert region(index, rings) == expected.region.canonical_json(), scale
        assert len(rings) == expected.region.vertices
        assert len(rings.ring_ends) == expected.region.ring_count == len(rings.features())


def test_all_forms_are_the_same_rings(index: Index) -> None:
    for scale in scales(index):
        exact: list[Point] | None = None
        rational = index.rings(scale, "rational")
        for form in FORMS:
            rings = index.rings(scale, form)
            assert (rings.scale, rings.form, len(rings)) == (scale, form, len(rational))
            assert numpy.array_equal(rings.ring_ends, rational.ring_ends)
            assert numpy.array_equal(rings.edges, rational.edges)
            assert rings.features() == rational.features()
            if form == "double":
                continue
            found = points(index, rings)
            exact = exact or found
            assert found == exact, (scale, form)
        rounded = index.rings(scale, "double")
        assert exact is not None and 0 <= rounded.error < math.inf
        error = Fraction(rounded.error)
        for x, y, point in zip(rounded.x.tolist(), rounded.y.tolist(), exact, strict=True):
            assert abs(Fraction(x) - point[0]) <= error, scale
            assert abs(Fraction(y) - point[1]) <= error, scale
        tracks = exact_tracks(index)
        largest = max((abs(c) for a, b in tracks for c in (*a, *b)), default=Fraction(0))
        stated = largest * (1 + Fraction(scale)) / 2**50
        underflow = (1 + Fraction(scale)) / Fraction(2) ** 1020
        assert error <= (stated + underflow) * (1 + Fraction(1, 2**40))


def test_what_is_beyond_doubles_has_an_error_without_bound(indices: dict[str, Index]) -> None:
    index = indices["islands"]
    for scale in ("1e400", "1e1000"):
        rings = index.rings(scale)
        assert rings.error == math.inf
        assert region(index, index.rings(scale, "rational")) == (
            index.sum(scale).region.canonical_json()
        )
        with pytest.raises(_core.LimitExceeded, match="beyond the range of doubles"):
            index.area(scale)
    for scale in ("1e-400", "1e100"):
        rings = index.rings(scale)
        exact = points(index, index.rings(scale, "track"))
        for x, y, point in zip(rings.x.tolist(), rings.y.tolist(), exact, strict=True):
            assert abs(Fraction(x) - point[0]) <= Fraction(rings.error)
            assert abs(Fraction(y) - point[1]) <= Fraction(rings.error)


def test_numbers_are_in_lowest_terms_and_weights_positive(index: Index) -> None:
    for scale in scales(index, 5):
        for a, b, c, d in integers(index.rings(scale, "rational").rational):
            assert b > 0 and d > 0
            assert math.gcd(a, b) == math.gcd(c, d) == 1
        assert all(w > 0 for _, _, w in integers(index.rings(scale, "homogeneous").homogeneous))


def test_outer_rings_run_counter_clockwise_and_holes_clockwise(index: Index) -> None:
    for scale in scales(index):
        for form in ("homogeneous", "rational", "track"):
            rings = index.rings(scale, form)
            for ring, (is_hole, _, _) in zip(
                split(rings, points(index, rings)), rings.features(), strict=True
            ):
                assert len(ring) >= 3
                assert (doubled_area(ring) < 0) == is_hole
                assert doubled_area(ring) != 0


def test_no_vertex_is_straight(index: Index) -> None:
    for scale in scales(index):
        rings = index.rings(scale, "rational")
        for ring in split(rings, points(index, rings)):
            for a, b, c in zip(ring[-1:] + ring[:-1], ring, ring[1:] + ring[:1], strict=True):
                assert doubled_area([a, b, c]) != 0, (scale, b)


def exact_rings(operand: _core.PolygonSet) -> list[list[Point]]:
    return [
        [(Fraction(x), Fraction(y)) for x, y in ring]
        for polygon in json.loads(operand.to_json())["polygons"]
        for ring in (polygon["outer"], *polygon["holes"])
    ]


def test_the_side_behind_a_vertex_lies_on_its_edge(index: Index) -> None:
    P, Q = exact_rings(index.P), exact_rings(index.Q)
    assert index.edges() == _core.reduced_convolution(index.P, index.Q)
    for scale in scales(index, 6):
        s = Fraction(scale)
        rings = index.rings(scale, "rational")
        for ring, edges in zip(
            split(rings, points(index, rings)), split(rings, rings.edges.tolist()), strict=True
        ):
            for a, b, edge in zip(ring, ring[1:] + ring[:1], edges, strict=True):
                kind, _, edge_ring, number, vertex_ring, vertex = index.edges()[edge]
                own, other = (P, Q) if kind == "S" else (Q, P)
                of_edge, of_vertex = (s, Fraction(1)) if kind == "S" else (Fraction(1), s)
                begin, end = (
                    own[edge_ring][number],
                    own[edge_ring][(number + 1) % len(own[edge_ring])],
                )
                v = other[vertex_ring][vertex]
                start, stop = (
                    (of_edge * p[0] + of_vertex * v[0], of_edge * p[1] + of_vertex * v[1])
                    for p in (begin, end)
                )
                assert doubled_area([start, stop, a]) == doubled_area([start, stop, b]) == 0
                along = sum((b[i] - a[i]) * (stop[i] - start[i]) for i in (0, 1))
                assert along > 0, (scale, edge)


def test_states_of_the_rings_are_those_between_events(indices: dict[str, Index]) -> None:
    index = indices["islands"]
    states: list[Any] = []
    index.ring_states(states.append)
    begins = [row[0] for row in index.boundary_events()]
    assert [state[0] for state in states] == [None, *begins]
    ends = [Fraction(begins[0]) / 2, *map(Fraction, begins), 2 * Fraction(begins[-1])]
    for k, (_, rows) in enumerate(states):
        rings = index.rings(str((ends[k] + ends[k + 1]) / 2), "track")
        expected = zip(rings.features(), split(rings, rings.tracks.tolist()), strict=True)
        assert sorted((tuple(row[:3]), turned(list(row[3]))) for row in rows) == sorted(
            (features, turned(ring)) for features, ring in expected
        )


def turned(ring: list[int]) -> list[int]:
    """The ring, starting from its least track."""
    at = ring.index(min(ring))
    return ring[at:] + ring[:at]


# Drawn operands.


@settings(DRAWN, max_examples=draws(12, 40))
@given(pairs(holes=1, components=2, without_area=True), st.integers(1, 12), st.integers(1, 12))
def test_drawn_operands_at_events_and_elsewhere(both: Any, n: int, d: int) -> None:
    P, Q = map(to_set, both)
    index = Index(P, Q)
    for scale in map(str, {Fraction(n, d), *index.event_scales()[:3], *index.event_scales()[-2:]}):
        expected = _core.minkowski_sum(P, Q, scale)
        text, area = expected.region.canonical_json(), Fraction(expected.region.area())
        assert index.sum(scale).region.canonical_json() == text
        assert index.components_and_holes(scale) == (expected.components, expected.holes)
        value, error = index.area(scale)
        assert abs(Fraction(value) - area) <= Fraction(error)
        exact = points(index, index.rings(scale, "rational"))
        assert points(index, index.rings(scale, "homogeneous")) == exact
        assert points(index, index.rings(scale, "track")) == exact
        assert region(index, index.rings(scale, "rational")) == text
        rings = index.rings(scale)
        for x, y, point in zip(rings.x.tolist(), rings.y.tolist(), exact, strict=True):
            assert abs(Fraction(x) - point[0]) <= Fraction(rings.error)
            assert abs(Fraction(y) - point[1]) <= Fraction(rings.error)


@settings(DRAWN, max_examples=draws(8, 25))
@given(
    pairs(magnitude=10**20, denominators=(10**9 + 7, 7), components=2),
    st.integers(1, 10**30),
    st.integers(1, 10**30),
)
def test_drawn_operands_with_long_numbers(both: Any, n: int, d: int) -> None:
    P, Q = map(to_set, both)
    index = Index(P, Q)
    for scale in map(str, {Fraction(n, d), *index.event_scales()[:2]}):
        expected = _core.minkowski_sum(P, Q, scale)
        text = expected.region.canonical_json()
        for form in ("homogeneous", "rational", "track"):
            assert region(index, index.rings(scale, form)) == text, form
        value, error = index.area(scale)
        assert abs(Fraction(value) - Fraction(expected.region.area())) <= Fraction(error)
