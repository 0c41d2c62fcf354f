"""The index in Python: its arrays, their forms, their life; what is asked of it singly, in batches
and from several threads; its file."""

from __future__ import annotations

import gc
import json
import math
import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from minkref import _core
from minkref.fuzz.families.random_pairs import random_pair
from minkref.operand import read_operand
from minkref.scale_space import STAGES
from minkref.strategies import pairs, to_set
from numpy.typing import NDArray

Index = _core.ScaleSpaceIndex
Rings = _core.IndexRings
Point = tuple[Fraction, Fraction]

FORMS = ("double", "homogeneous", "rational", "track")
NUMBERS = {"double": ("x", "y"), "homogeneous": ("homogeneous",), "rational": ("rational",),
           "track": ("tracks",)}  # fmt: skip
DRAWN = settings(
    derandomize=True, database=None, deadline=None, phases=(Phase.generate, Phase.shrink)
)

SQUARES = "MULTIPOLYGON({})".format(
    ",".join(
        f"(({x} {y},{x + 1} {y},{x + 1} {y + 1},{x} {y + 1},{x} {y}))"
        for x, y in ((1, 0), (0, 1), (2, 1), (1, 2))
    )
)
TEXTS = {
    "islands": (
        "POLYGON((0 0,3 0,1 2,0 0))",
        "MULTIPOLYGON(((0 0,60 0,60 60,0 60,0 0),(5 5,5 55,55 55,55 5,5 5)),"
        "((20 20,40 20,40 40,20 40,20 20),(24 24,24 36,36 36,36 24,24 24)),"
        "((70 0,80 0,70 9,70 0)))",
    ),
    "several components": (
        "MULTIPOLYGON(((0 0,2 0,0 2,0 0)),((5 5,6 5,6 6,5 5)))",
        "MULTIPOLYGON(((0 0,7 0,7 7,0 7,0 0),(2 2,2 5,5 5,5 2,2 2)),((9 0,11 0,11 7,9 0)))",
    ),
    "touching": (SQUARES, "POLYGON((0 0,1 0,0 1,0 0))"),
    "a point": ("POINT(-3 5)", SQUARES),
    "a segment": ("POLYGON((0 0,3 0,3 3,2 3,2 1,0 3,0 0))", "LINESTRING(-1 2,3 -1)"),
    "nothing": ("POLYGON EMPTY", "POLYGON((0 0,1 0,0 1,0 0))"),
}
MODELS = {"letters": ("g1", "g2"), "right angles": ("g3", "g1")}
NAMES = (*TEXTS, *MODELS, "huge and tiny", *(f"random {k}" for k in range(6)))
# Of which a boundary is told in integers of more than one word.
LONG = "huge and tiny"


def operands(name: str) -> tuple[_core.PolygonSet, _core.PolygonSet]:
    if name in TEXTS:
        P, Q = TEXTS[name]
        return _core.read_text(P, "wkt"), _core.read_text(Q, "wkt")
    if name in MODELS:
        P, Q = MODELS[name]
        return read_operand(P).set, read_operand(Q).set
    if name == LONG:
        P, Q = operands("several components")
        tiny = str(Fraction(1, 3**50))
        return P.translated("-" + tiny, tiny), Q.translated("1" + 40 * "0", "-1" + 40 * "0")
    pair = random_pair(40, 97 * int(name.split()[1]))
    return _core.PolygonSet.from_json(pair.P), _core.PolygonSet.from_json(pair.Q)


def window_of(name: str) -> tuple[str | None, str | None]:
    return ("1/3", "5") if name in ("letters", "random 1") else (None, None)


@pytest.fixture(scope="module")
def indices() -> dict[str, Index]:
    return {name: Index(*operands(name), *window_of(name)) for name in NAMES}


@pytest.fixture(params=NAMES)
def index(request: pytest.FixtureRequest, indices: dict[str, Index]) -> Index:
    return indices[request.param]


def scales(index: Index, most: int = 12) -> list[str]:
    """Events, with those of the topology first, and scales between them, beyond them, at the ends
    of the window."""
    low, high = (None if bound is None else Fraction(bound) for bound in index.window)
    events = sorted(
        s
        for s in map(Fraction, index.event_scales())
        if (low is None or s >= low) and (high is None or s <= high)
    )
    topology = list(dict.fromkeys(Fraction(row[0]) for row in index.topology_events()))
    chosen = topology[: most // 3] + events[:: 1 + len(events) // most]
    ends = [low or (events[0] if events else high or Fraction(1)) / 2]
    ends += [high or 2 * (events[-1] if events else ends[0])]
    middles = [(a + b) / 2 for a, b in pairwise(events) if a in chosen and a < b]
    return [str(s) for s in dict.fromkeys([*ends, (ends[0] + ends[1]) / 2, *chosen, *middles])]


def integers(words: NDArray[numpy.uint64]) -> Any:
    """Of an array with the words of an integer along its last axis: nested lists of integers, or
    the one integer."""
    if words.ndim > 1:
        return [integers(part) for part in words]
    data = words.astype("<u8").tobytes()
    return int.from_bytes(data, "little", signed=True)


def exact_tracks(index: Index) -> list[tuple[Point, Point]]:
    return [
        (
            (Fraction(a[0]), Fraction(a[1])),
            (Fraction(b[0]), Fraction(b[1])),
        )
        for a, b in index.tracks()
    ]


def points(index: Index, rings: Rings) -> list[Point]:
    """Of a form that is exact."""
    if rings.form == "homogeneous":
        return [(Fraction(x, w), Fraction(y, w)) for x, y, w in integers(rings.homogeneous)]
    if rings.form == "rational":
        return [(Fraction(a, b), Fraction(c, d)) for a, b, c, d in integers(rings.rational)]
    s, tracks = Fraction(rings.scale), exact_tracks(index)
    return [
        (a[0] + s * b[0], a[1] + s * b[1]) for a, b in (tracks[track] for track in rings.tracks)
    ]


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
    """The canonical JSON of the set that the rings bound, by their features."""
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


# What the rings are.


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
        assert index.area(scale)[1] == math.inf
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


# The arrays themselves.


def arrays(rings: Rings) -> Iterator[tuple[str, NDArray[Any]]]:
    for name in ("ring_ends", "edges", *NUMBERS[rings.form]):
        yield name, getattr(rings, name)


@pytest.mark.parametrize("form", FORMS)
def test_arrays_are_contiguous_views_that_cannot_be_written(index: Index, form: str) -> None:
    kinds = {"ring_ends": "uint32", "edges": "uint32", "x": "float64", "y": "float64",
             "homogeneous": "uint64", "rational": "uint64", "tracks": "uint32"}  # fmt: skip
    per = {"homogeneous": 3, "rational": 4}
    rings = index.rings(scales(index)[0], form)
    for name, array in arrays(rings):
        assert array.dtype == numpy.dtype(kinds[name])
        assert array.flags.c_contiguous and array.flags.aligned
        assert array.size == 0 or not (array.flags.writeable or array.flags.owndata)
        if name == "ring_ends":
            assert array.shape == (len(rings.features()),)
            assert array.tolist() == sorted(set(array.tolist()))
            assert array.size == 0 or (array[0] > 0 and array[-1] == len(rings))
        elif name in per:
            assert array.shape[:2] == (len(rings), per[name])
            assert array.shape[2] >= 1
        else:
            assert array.shape == (len(rings),)
        if array.size == 0:
            continue
        with pytest.raises(ValueError):
            array[...] = 0
        assert numpy.shares_memory(array, getattr(rings, name))


def test_tracks_are_told_in_integers_doubles_and_texts_alike(index: Index) -> None:
    exact, words, doubles = exact_tracks(index), index.track_integers, index.track_doubles
    assert words.dtype == numpy.uint64 and doubles.dtype == numpy.float64
    assert words.shape[:2] == (len(exact), 5) and doubles.shape == (len(exact), 4)
    for array in (words, doubles):
        assert array.flags.c_contiguous and not array.flags.writeable
        with pytest.raises(ValueError):
            array[...] = 0
    for (a, b), (x0, y0, x1, y1, c), near in zip(
        exact, integers(words), doubles.tolist(), strict=True
    ):
        assert c > 0
        assert (a, b) == ((Fraction(x0, c), Fraction(y0, c)), (Fraction(x1, c), Fraction(y1, c)))
        for coordinate, double in zip((*a, *b), near, strict=True):
            assert abs(Fraction(double) - coordinate) <= abs(coordinate) / 2**52


def test_integers_have_as_many_words_as_they_need_and_their_signs(
    indices: dict[str, Index],
) -> None:
    scale = "1" + 25 * "0" + "/7"
    for form in ("homogeneous", "rational"):
        short, long = (
            getattr(indices[name].rings(at, form), form)
            for name, at in (("letters", "1"), (LONG, scale))
        )
        assert short.shape[2] == 1
        assert long.shape[2] >= 3
        for words in (short, long):
            numbers = [number for row in integers(words) for number in row]
            assert min(numbers) < 0 < max(numbers)
        numbers = [number for row in integers(long) for number in row]
        assert max(abs(number) for number in numbers) > 2**128
    assert indices["letters"].track_integers.shape[2] == 1
    assert indices[LONG].track_integers.shape[2] >= 3
    # A word of two's complement, not of sign and magnitude: -1 is all ones.
    whole = Index(
        _core.read_text("POLYGON((-1 -1,0 -1,0 0,-1 0,-1 -1))", "wkt"),
        _core.read_text("POINT(0 0)", "wkt"),
    )
    found = {tuple(row.ravel().tolist()) for row in whole.rings("1", "rational").rational}
    ones = 2**64 - 1
    assert found == {(ones, 1, ones, 1), (ones, 1, 0, 1), (0, 1, ones, 1), (0, 1, 0, 1)}


@pytest.mark.parametrize("shift", [2**k + d for k in (62, 63, 64, 127, 128) for d in (-1, 0, 1)])
def test_numbers_at_the_ends_of_words(shift: int) -> None:
    triangle = _core.read_text("POLYGON((0 0,1 0,0 1,0 0))", "wkt")
    for sign in ("", "-"):
        point = _core.read_text(f"POINT({sign}{shift} 0)", "wkt")
        index = Index(triangle, point, "1", "2")
        x = int(f"{sign}{shift}")
        for form in ("homogeneous", "rational", "track"):
            found = points(index, index.rings("1", form))
            assert set(found) == {(x, 0), (x + 1, 0), (x, 1)}, form
        rounded = index.rings("1")
        for double in rounded.x.tolist():
            assert min(abs(Fraction(double) - x - d) for d in (0, 1)) <= Fraction(rounded.error)


@pytest.mark.parametrize("opened", [False, True])
def test_arrays_outlive_the_index_and_the_rings(tmp_path: Path, opened: bool) -> None:
    P, Q = operands("letters")
    made = Index(P, Q)
    path = tmp_path / "letters.index"
    made.save(str(path))
    index = Index.open(str(path)) if opened else Index(P, Q)
    del made
    kept: list[NDArray[Any]] = [index.track_integers, index.track_doubles]
    for form in FORMS:
        kept += [array for _, array in arrays(index.rings("7/5", form))]
    kept += [array for rings in index.batch(["1", "2"], "double", 2) for _, array in arrays(rings)]
    before = [array.copy() for array in kept]
    rings = index.rings("7/5", "homogeneous")
    path.unlink()
    del index
    gc.collect()
    others = [Index(P, Q).rings("7/5", "homogeneous").homogeneous for _ in range(20)]
    gc.collect()
    assert all(numpy.array_equal(a, b) for a, b in zip(kept, before, strict=True))
    # Rings need no index either.
    assert numpy.array_equal(rings.homogeneous, others[0])
    assert len(rings) == len(rings.edges)


# What needs no rings.


def test_the_area_is_within_its_error(index: Index) -> None:
    for scale in scales(index):
        exact = Fraction(_core.minkowski_sum(index.P, index.Q, scale).region.area())
        value, error = index.area(scale)
        assert 0 <= error < math.inf
        assert abs(Fraction(value) - exact) <= Fraction(error), scale


@pytest.mark.parametrize("name", [name for name in NAMES if name != LONG])
def test_the_error_of_the_area_is_small(indices: dict[str, Index], name: str) -> None:
    for scale in scales(indices[name]):
        value, error = indices[name].area(scale)
        assert error <= 1e-9 * (1 + value)


def test_the_polynomial_of_the_area_is_exact(index: Index) -> None:
    for scale in scales(index):
        exact = Fraction(_core.minkowski_sum(index.P, index.Q, scale).region.area())
        a0, a1, a2 = map(Fraction, index.area_polynomial(scale))
        assert a0 + Fraction(scale) * (a1 + Fraction(scale) * a2) == exact, scale


def test_one_polynomial_holds_up_to_the_next_events(indices: dict[str, Index]) -> None:
    index = indices["several components"]
    for low, high in zip(index.event_scales(), index.event_scales()[1:], strict=False):
        a, b = Fraction(low), Fraction(high)
        told = {tuple(index.area_polynomial(str(a + (b - a) * k / 4))) for k in (1, 2, 3)}
        assert len(told) == 1
        a0, a1, a2 = map(Fraction, told.pop())
        for s in (a, b):
            exact = Fraction(_core.minkowski_sum(index.P, index.Q, str(s)).region.area())
            assert a0 + s * (a1 + s * a2) == exact


def test_components_and_holes_and_the_sum_are_those_of_the_static_route(index: Index) -> None:
    for scale in scales(index):
        expected = _core.minkowski_sum(index.P, index.Q, scale, tight_passages=True)
        found = index.sum(scale, True)
        counts = (expected.components, expected.holes)
        assert index.components_and_holes(scale) == counts, scale
        assert (found.components, found.holes) == counts
        assert found.region.canonical_json() == expected.region.canonical_json()
        assert found.tight_passages == expected.tight_passages
        assert index.sum(scale).tight_passages is None
    assert index.first_difference(scales(index)) == ""


def test_neighbours_are_the_events_beside_a_scale(index: Index) -> None:
    events = index.event_scales()
    exact = [Fraction(event) for event in events]
    assert exact == sorted(set(exact))
    low, high = index.window
    for scale in scales(index, 20):
        s = Fraction(scale)
        below = [event for event in exact if event < s]
        above = [event for event in exact if event > s]
        assert index.neighbours(scale) == (
            str(below[-1]) if below else None,
            s in exact,
            str(above[0]) if above else None,
        )
    within = [
        e
        for e in exact
        if (low is None or e >= Fraction(low)) and (high is None or e <= Fraction(high))
    ]
    assert {Fraction(row[0]) for row in index.boundary_events()} <= set(within)


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
    """Beginning with its least track."""
    at = ring.index(min(ring))
    return ring[at:] + ring[:at]


# Many questions.


def same(one: Rings, other: Rings) -> bool:
    """The same in all they tell."""
    heads = [(r.scale, r.form, len(r), r.features()) for r in (one, other)]
    errors = [r.error if r.form == "double" else None for r in (one, other)]
    return (
        heads[0] == heads[1]
        and errors[0] == errors[1]
        and all(
            a.dtype == b.dtype and numpy.array_equal(a, b)
            for (_, a), (_, b) in zip(arrays(one), arrays(other), strict=True)
        )
    )


@pytest.mark.parametrize("threads", [1, 2, 5])
@pytest.mark.parametrize("form", FORMS)
def test_a_batch_is_the_single_answers_in_their_order(
    indices: dict[str, Index], form: str, threads: int
) -> None:
    for name in ("several components", "letters", LONG, "nothing"):
        index = indices[name]
        asked = scales(index)[::-1]
        asked += asked[:3]
        batch = index.batch(asked, form, threads)
        assert [rings.scale for rings in batch] == asked
        for scale, rings in zip(asked, batch, strict=True):
            assert same(rings, index.rings(scale, form)), (name, scale)
    assert index.batch([], form, threads) == []


def test_batches_and_rings_are_doubles_where_no_form_is_named(indices: dict[str, Index]) -> None:
    index = indices["islands"]
    assert index.rings("2").form == index.batch(["2"])[0].form == "double"


def test_a_scale_may_be_told_in_any_way(indices: dict[str, Index]) -> None:
    index = indices["islands"]
    for text in ("5/2", "2.5", "25e-1", "10/4"):
        rings = index.rings(text)
        assert rings.scale == "5/2"
        assert same(rings, index.rings("5/2"))


def test_several_threads_get_the_same_answers() -> None:
    P, Q = operands("letters")
    index = Index(P, Q, "1/4", "4", 2)
    asked = scales(index, 30)

    def answer(scale: str) -> list[Any]:
        return [
            *(index.rings(scale, form) for form in FORMS),
            index.sum(scale).region.canonical_json(),
            index.area(scale),
            index.area_polynomial(scale),
            index.components_and_holes(scale),
            index.neighbours(scale),
            index.topology_events(),
            index.lives("hole"),
        ]

    expected = {scale: answer(scale) for scale in asked}
    with ThreadPoolExecutor(8) as pool:
        for scale, found in zip(asked * 3, pool.map(answer, asked * 3), strict=True):
            wanted = expected[scale]
            assert found[len(FORMS) :] == wanted[len(FORMS) :], scale
            assert all(map(same, found[: len(FORMS)], wanted[: len(FORMS)])), scale


def test_indices_may_be_built_at_the_same_time() -> None:
    names = ("letters", "islands", "several components", "random 2")
    with ThreadPoolExecutor(4) as pool:
        built = list(pool.map(lambda name: Index(*operands(name)), names * 3))
    for name, index in zip(names * 3, built, strict=True):
        assert index.first_difference(["1", "7/5"]) == "", name


def test_progress_tells_of_each_stage_and_may_end_the_build() -> None:
    told: list[tuple[str, int, int]] = []
    P, Q = operands("letters")
    Index(P, Q, None, None, 2, 0, lambda *now: told.append(now))
    assert list(dict.fromkeys(stage for stage, _, _ in told)) == list(STAGES)
    assert all(0 <= done <= total for _, done, total in told)
    for stage in STAGES:
        done = [now[1] for now in told if now[0] == stage]
        assert done == sorted(done)

    def stop(stage: str, done: int, total: int) -> None:
        raise InterruptedError(stage)

    with pytest.raises(InterruptedError):
        Index(P, Q, None, None, 2, 0, stop)


# The file.


def everything(index: Index) -> list[Any]:
    asked = scales(index, 6)
    return [
        index.window,
        index.P.to_json(),
        index.Q.to_json(),
        index.edges(),
        index.counts(),
        index.event_scales(),
        index.boundary_events(),
        index.topology_events(),
        *(index.features(kind) + index.lives(kind) for kind in ("hole", "component")),
        index.tracks(),
        index.track_integers.tolist(),
        index.track_doubles.tolist(),
        *((index.area(s), index.area_polynomial(s), index.components_and_holes(s)) for s in asked),
        *(index.sum(s).region.canonical_json() for s in asked),
        *(
            array.tolist()
            for form in FORMS
            for s in asked
            for _, array in arrays(index.rings(s, form))
        ),
    ]


def test_a_saved_index_gives_the_same_answers(index: Index, tmp_path: Path) -> None:
    path, copy = tmp_path / "sums.index", tmp_path / "copy.index"
    index.save(str(path))
    assert path.stat().st_size == index.counts()["bytes"]
    opened = Index.open(str(path))
    expected = everything(index)
    assert everything(opened) == expected
    assert opened.is_of(index.P, index.Q)
    opened.save(str(copy))
    assert copy.read_bytes() == path.read_bytes()
    # Also over itself, and after the file is no more.
    opened.save(str(path))
    assert everything(opened) == expected
    path.unlink()
    assert everything(opened) == expected
    assert [file.name for file in tmp_path.iterdir()] == ["copy.index"]


@pytest.mark.parametrize("how", ["saved over", "replaced", "deleted"])
def test_an_open_index_is_as_it_was_after_its_file_is_another(
    indices: dict[str, Index], tmp_path: Path, how: str
) -> None:
    path, other = tmp_path / "sums.index", tmp_path / "other.index"
    indices["letters"].save(str(path))
    opened = Index.open(str(path))
    if how == "saved over":
        indices["nothing"].save(str(path))
    elif how == "replaced":
        other.write_bytes(b"short")
        os.replace(other, path)
    else:
        path.unlink()
    assert everything(opened) == everything(indices["letters"])


def test_whose_index_it_is(indices: dict[str, Index]) -> None:
    P, Q = operands("several components")
    index = indices["several components"]
    assert index.is_of(P, Q)
    assert index.is_of(_core.PolygonSet.from_json(P.to_json()), Q)
    assert not index.is_of(Q, P)
    assert not index.is_of(P, P)
    assert not index.is_of(P.translated("1/1000000000000000000000", "0"), Q)


# Refusals.


def code_of(refused: pytest.ExceptionInfo[_core.BadInput]) -> str:
    assert refused.value.problem and refused.value.mend
    return refused.value.code


QUESTIONS = {
    "rings": lambda index, s: index.rings(s),
    "rings in lowest terms": lambda index, s: index.rings(s, "rational"),
    "batch": lambda index, s: index.batch(["1", s, "2"], "double", 2),
    "sum": lambda index, s: index.sum(s),
    "area": lambda index, s: index.area(s),
    "area_polynomial": lambda index, s: index.area_polynomial(s),
    "components_and_holes": lambda index, s: index.components_and_holes(s),
    "neighbours": lambda index, s: index.neighbours(s),
    "first_difference": lambda index, s: index.first_difference([s]),
}


@pytest.mark.parametrize("question", QUESTIONS)
def test_scales_that_are_none_or_outside_the_window_are_refused(
    indices: dict[str, Index], question: str
) -> None:
    ask = QUESTIONS[question]
    bad = {
        "x": "not-a-number",
        "": "not-a-number",
        "nan": "not-a-number",
        "1/0": "zero-denominator",
    }
    beyond = (
        "5.0000000000000000000001",
        "33333333333333333/100000000000000000",
        "0",
        "-1",
        "1e400",
    )
    for text, code in bad.items():
        with pytest.raises(_core.BadInput) as refused:
            ask(indices["letters"], text)
        assert code_of(refused) == code
    for scale in beyond:
        with pytest.raises(_core.BadInput) as refused:
            ask(indices["letters"], scale)
        assert code_of(refused) == "outside-window"
    for scale in ("0", "-1"):
        with pytest.raises(_core.BadInput) as refused:
            ask(indices["islands"], scale)
        assert code_of(refused) == "outside-window"
    for scale in ("1/3", "5"):
        ask(indices["letters"], scale)


def test_a_form_that_is_none_is_refused(indices: dict[str, Index]) -> None:
    for form in ("", "float", "Double", "tracks"):
        for ask in (
            lambda form: indices["islands"].rings("1", form),
            lambda form: indices["islands"].batch(["1"], form),
        ):
            with pytest.raises(_core.BadInput) as refused:
                ask(form)
            assert code_of(refused) == "no-form"


@pytest.mark.parametrize("form", FORMS)
def test_what_a_form_has_not_is_refused(indices: dict[str, Index], form: str) -> None:
    rings = indices["islands"].rings("1", form)
    of_forms = {**NUMBERS, "double": ("x", "y", "error")}
    for other, names in of_forms.items():
        for name in names:
            if other == form:
                getattr(rings, name)
                continue
            with pytest.raises(_core.BadInput) as refused:
                getattr(rings, name)
            assert code_of(refused) == "other-form"
            assert name in refused.value.problem and form in refused.value.problem


@pytest.mark.parametrize(
    "window", [("2", "1"), ("0", "1"), ("-1", None), (None, "0"), (None, "-2")]
)
def test_a_window_without_scales_is_refused(window: tuple[str | None, str | None]) -> None:
    with pytest.raises(_core.BadInput) as refused:
        Index(*operands("islands"), *window)
    assert code_of(refused) == "bad-window"


def test_more_memory_than_allowed_is_refused() -> None:
    with pytest.raises(_core.LimitExceeded) as refused:
        Index(*operands("islands"), "1", "2", 1, 1 << 20)
    assert code_of(refused) == "memory-limit"


def test_files_that_cannot_be_read_or_written_are_refused(
    indices: dict[str, Index], tmp_path: Path
) -> None:
    for path, code in ((tmp_path, "no-file"), (tmp_path / "absent", "no-file")):
        with pytest.raises(_core.BadInput) as refused:
            Index.open(str(path))
        assert code_of(refused) == code
        assert str(path) in str(refused.value)
    for path in (tmp_path, tmp_path / "no" / "folder"):
        with pytest.raises(_core.BadInput) as refused:
            indices["islands"].save(str(path))
        assert code_of(refused) == "cannot-write"
    assert list(tmp_path.iterdir()) == []


# Drawn operands.


@settings(DRAWN, max_examples=40)
@given(pairs(holes=1, components=2, without_area=True), st.integers(1, 12), st.integers(1, 12))
def test_drawn_operands_at_events_and_elsewhere(both: Any, n: int, d: int) -> None:
    P, Q = map(to_set, both)
    index = Index(P, Q)
    for scale in {str(Fraction(n, d)), *index.event_scales()[:3], *index.event_scales()[-2:]}:
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


@settings(DRAWN, max_examples=25)
@given(
    pairs(magnitude=10**20, denominators=(10**9 + 7, 7), components=2),
    st.integers(1, 10**30),
    st.integers(1, 10**30),
)
def test_drawn_operands_with_long_numbers(both: Any, n: int, d: int) -> None:
    P, Q = map(to_set, both)
    index = Index(P, Q)
    for scale in {str(Fraction(n, d)), *index.event_scales()[:2]}:
        expected = _core.minkowski_sum(P, Q, scale)
        text = expected.region.canonical_json()
        for form in ("homogeneous", "rational", "track"):
            assert region(index, index.rings(scale, form)) == text, form
        value, error = index.area(scale)
        assert abs(Fraction(value) - Fraction(expected.region.area())) <= Fraction(error)
