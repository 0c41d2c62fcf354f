"""Facets and edges in space: degrees of the conditions, hand-made events, laws."""

from __future__ import annotations

import random

import pytest
from minkref.oracle.symbolic import solutions
from minkref.oracle.symbolic.pairs import Interval
from minkref.oracle.symbolic.rational import Rational, rationals
from minkref.oracle.symbolic.space.space_events import (
    edge_contact,
    facet_contact,
    four_event,
    lines_polynomial,
    plane_event,
    planes_parallel,
    vertex_event,
)
from minkref.oracle.symbolic.space.space_moving import (
    MovingFacet,
    SpaceSegment,
    SpaceVertex,
    dot,
    facet,
    vector,
)
from minkref.oracle.symbolic.space.space_standing import in_polygon, shared

SEED = 99
CORNER = ((0, 0, 0), (6, 0, 0), (0, 6, 0))


def edge(kind: str, first: object, last: object, other: object) -> SpaceSegment:
    a, b, c = vector(first), vector(last), vector(other)
    if kind == "S":
        return SpaceSegment("S", SpaceVertex(a, c), SpaceVertex(b, c))
    return SpaceSegment("T", SpaceVertex(c, a), SpaceVertex(c, b))


def random_edge(rng: random.Random, size: int) -> SpaceSegment:
    while True:
        a, b, c = ([rng.randint(-size, size) for _ in range(3)] for _ in range(3))
        if a != b:
            return edge(rng.choice("ST"), a, b, c)


def random_facet(rng: random.Random, size: int) -> MovingFacet:
    while True:
        kind = rng.choice(["fv", "vf", "ee"])
        points = [[rng.randint(-size, size) for _ in range(3)] for _ in range(4)]
        cut = {"fv": 3, "vf": 1, "ee": 2}[kind]
        try:
            return facet(kind, points[:cut], points[cut:])
        except ValueError:
            continue


def test_conditions_in_space_are_linear_but_for_diagonals() -> None:
    kept = solutions.read()
    powers = {kind: kept[f"plane {kind}"]["power_of_s"] for kind in ("fv", "ee", "vf")}
    assert powers == {"fv": 2, "ee": 1, "vf": 0}
    for name in ("plane fv", "plane vf", "plane ee", "vertex in plane", "four planes"):
        assert kept[name]["degree"] == 1
    diagonals = {"SS": 0, "ST": 0, "TS": 0, "TT": 0, "SD": 1, "DS": 1, "TD": 1, "DT": 1, "DD": 2}
    for kinds, more in diagonals.items():
        assert kept[f"lines {kinds}"]["degree"] == 1 + more


def test_a_diagonal_taken_for_an_edge_has_a_quadratic_condition() -> None:
    """Against a vertical T-edge the condition is cross(s A + B, s E + F) = s^2 cross(A, E) +
    s (cross(A, F) + cross(B, E)) + cross(B, F), with A = (1,0), B = (0,1), E = (0,17),
    F = (5,24): 17 s^2 + 24 s - 5, of discriminant 916 = 4 * 229, no square."""
    diagonal = SpaceSegment(
        "D",
        SpaceVertex(vector((1, 0, 0)), vector((0, 1, 0))),
        SpaceVertex(vector((1, 17, 3)), vector((5, 25, 1))),
    )
    upright = edge("T", (0, 0, 0), (0, 0, 1), (0, 0, 0))
    assert lines_polynomial(diagonal, upright) == [17, 24, -5]
    assert lines_polynomial(upright, diagonal) in ([17, 24, -5], [-17, -24, 5])
    with pytest.raises(ValueError, match="turns"):
        diagonal.direction()


def test_a_vertex_comes_to_a_facet_and_to_its_plane_only() -> None:
    """The plane z = s of an fv-facet, the vertex (x, y, 10 - s): both at 5."""
    plane = facet("fv", [(x, y, z + 1) for x, y, z in CORNER], [(0, 0, 0)])
    within = vertex_event(plane, SpaceVertex(vector((0, 0, -1)), vector((1, 1, 10))))
    assert (within.case, str(within.s), within.meet) == ("once", "5", True)
    beside = vertex_event(plane, SpaceVertex(vector((0, 0, -1)), vector((99, 1, 10))))
    assert (beside.case, str(beside.s), beside.meet) == ("once", "5", False)
    assert vertex_event(plane, SpaceVertex(vector((0, 0, 1)), vector((0, 0, 2)))).case == "never"
    assert vertex_event(plane, SpaceVertex(vector((0, 0, 1)), vector((4, 4, 0)))).case == "always"


def test_parallel_planes_coincide_once_always_or_never() -> None:
    rising = facet("fv", [(x, y, z + 1) for x, y, z in CORNER], [(0, 0, 0)])
    standing = facet("vf", [(0, 0, 0)], [(x, y, z + 4) for x, y, z in CORNER])
    found = plane_event(rising, standing)
    assert (str(found.s), found.meet) == ("4", True)
    away = facet("vf", [(50, 0, 0)], [(x, y, z + 4) for x, y, z in CORNER])
    assert plane_event(rising, away).meet is False
    assert plane_event(standing, facet("vf", [(1, 1, 0)], CORNER)).case == "never"


def test_coplanar_facets_begin_and_end_to_meet() -> None:
    """A resting facet, [0,6] by [0,6] below the diagonal, and the same facet moved by (s - 10,
    0)."""
    still, moving = facet("vf", [(0, 0, 0)], CORNER), facet("vf", [(1, 0, 0)], CORNER)
    moved = facet("vf", [(1, 0, 0)], [(x - 10, y, z) for x, y, z in CORNER])
    assert plane_event(still, moved).case == "always"
    assert facet_contact(still, moved) == [Interval(Rational(4), Rational(16))]
    assert facet_contact(still, moving) == [Interval(None, Rational(6))]


def test_edges_in_one_plane_at_all_scales_meet_as_in_that_plane() -> None:
    a = edge("S", (0, 0, 0), (0, 1, 1), (0, 0, 0))
    b = edge("T", (2, -1, -1), (2, 1, 1), (0, 0, 0))
    assert edge_contact(a, b) is None
    c = edge("T", (0, 2, 2), (0, 3, 3), (0, 0, 0))
    assert edge_contact(a, c) == Interval(Rational(2), None)
    d = edge("T", (-1, 2, 2), (1, 2, 2), (0, 0, 0))
    assert edge_contact(a, d) == Interval(Rational(2), None)


def test_a_scan_finds_no_other_contact_of_edges() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    met = 0
    for _ in range(600):
        size = rng.choice([1, 2])
        a, b = random_edge(rng, size), random_edge(rng, size)
        found = edge_contact(a, b)
        assert found == edge_contact(b, a)
        met += found is not None
        limits = [x for x in (found.low, found.high) if x is not None] if found else []
        for s in [*limits, *(Rational(rng.randint(1, 24), rng.choice([1, 2, 3])) for _ in "12345")]:
            inside = (
                found is not None
                and (found.low or 0) <= s
                and (found.high is None or s <= found.high)
            )
            assert (shared(a.at(s), b.at(s)) is not None) == inside
    assert met > 60


def test_lines_meet_only_at_roots_of_their_polynomial() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    for _ in range(300):
        a, b = random_edge(rng, 9), random_edge(rng, 9)
        slope, constant = lines_polynomial(a, b)
        for s in rationals(("1/3", 1, "5/2", 8)):
            (x, y), (z, w) = a.at(s), b.at(s)
            rows = [[q - p for p, q in zip(x, u, strict=True)] for u in (y, z, w)]
            coplanar = determinant(rows) == 0
            assert coplanar == (slope * s + constant == 0)


def determinant(m: list[list[Rational]]) -> Rational:
    return (
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    )


def test_a_facet_found_by_its_vertex_event_has_the_vertex_in_its_plane() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    inside = 0
    for _ in range(500):
        plane = random_facet(rng, 4)
        p, q = ([rng.randint(-3, 3) for _ in range(3)] for _ in range(2))
        event = vertex_event(plane, SpaceVertex(vector(p), vector(q)))
        if event.s is not None and event.at is not None:
            n = plane.plane()
            assert dot(n[:3], event.at) == n[3] * event.s + n[4]
            inside += in_polygon(event.at, plane.corners(event.s))
    assert inside > 10


def test_four_planes_pass_through_one_point_at_their_event() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    once = 0
    for _ in range(300):
        facets = [random_facet(rng, 4) for _ in range(4)]
        try:
            event = four_event(facets)
        except ValueError:
            continue
        if event.s is None or event.at is None:
            continue
        once += 1
        for plane in (each.plane() for each in facets):
            assert dot(plane[:3], event.at) == plane[3] * event.s + plane[4]
    assert once > 80


def test_facets_of_four_faces_of_a_shrinking_tetrahedron_meet_in_one_point() -> None:
    """x >= s, y >= s, z >= s, x + y + z <= 12 is a tetrahedron until s = 4, and then the point
    (4,4,4): the hole of a sum in space that dies where four facets meet."""
    big = 40
    low = [
        facet("vf", [(1, 0, 0)], [(0, -big, -big), (0, big, -big), (0, 0, big)]),
        facet("vf", [(0, 1, 0)], [(-big, 0, -big), (big, 0, -big), (0, 0, big)]),
        facet("vf", [(0, 0, 1)], [(-big, -big, 0), (big, -big, 0), (0, big, 0)]),
    ]
    slanted = facet("vf", [(0, 0, 0)], [(12, 0, 0), (0, 12, 0), (0, 0, 12)])
    event = four_event([*low, slanted])
    assert (event.case, str(event.s), event.meet) == ("once", "4", True)
    assert event.at == rationals((4, 4, 4))
    assert not planes_parallel(low[0], slanted)
