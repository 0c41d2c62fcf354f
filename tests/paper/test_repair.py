"""The paper's repair of convex sums (Section 6): with all sentences corrected and exact numbers the
repair equals the proven update; each printed sentence alone loses the sum of two small bodies."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.judges.space.convex_claims import (
    ClaimComparison,
    compare_claims,
    largest_distance,
)
from minkref.fuzz.space.convex_sum import body_of
from minkref.fuzz.space.generators.convex import box, random_hull
from minkref.fuzz.space.generators.over_polygon import random_prism
from minkref.fuzz.space.hull import convex_hull
from minkref.oracle.symbolic.space.incompatibility import descent
from thoroughness import draws

Body = _core.ConvexPolyhedron
Scaling = tuple[str, str, str]
Draw = Callable[[random.Random], Body]
CORRECTED = {name: corrected for name, _, corrected, _ in _core.repair_readings()}
UNIT = ("1", "1", "1")
RANDOM_PAIRS = draws(80, 240)


def random_scaling(dice: random.Random) -> Scaling:
    x, y, z = (str(Fraction(dice.randint(1, 9), dice.randint(1, 4))) for _ in range(3))
    return (x, y, z)


def hull(dice: random.Random) -> Body:
    return body_of(random_hull(dice, dice.randint(4, 10), dice.choice((1, 2, 9))))


def random_box(dice: random.Random) -> Body:
    low = tuple(Fraction(dice.randint(-3, 0)) for _ in range(3))
    high = tuple(Fraction(dice.randint(1, 4)) for _ in range(3))
    return body_of(box(low, high))


def prism(dice: random.Random) -> Body:
    return body_of(convex_hull(random_prism(dice, 2, 3).polyhedron().vertices))


def body(*points: tuple[int, int, int]) -> Body:
    return body_of(convex_hull(tuple(map(Fraction, point)) for point in points))


def repaired(
    P: Body, Q: Body, scaling: Scaling, readings: dict[str, str], arithmetic: str = "rational"
) -> _core.PaperRepair:
    repair = _core.PaperRepair(P, Q, UNIT, arithmetic, readings)
    repair.update(scaling)
    return repair


@pytest.mark.parametrize(
    ("first", "second"), [(hull, hull), (random_box, random_box), (prism, prism), (hull, prism)]
)
def test_all_corrected_in_rational_numbers_is_the_proven_update(first: Draw, second: Draw) -> None:
    """Compares pairs and, against the static route, facets."""
    dice = random.Random(f"{first.__name__} {second.__name__}")
    for _ in range(RANDOM_PAIRS // 4):
        P, Q = first(dice), second(dice)
        scalings = [random_scaling(dice) for _ in range(4)]
        repair = _core.PaperRepair(P, Q, scalings[0], "rational", CORRECTED)
        proven = _core.DynamicConvexSum(P, Q, scalings[0])
        for scaling in scalings[1:]:
            told = dict(repair.update(scaling))
            proven.update(scaling)
            assert repair.has_exact_pairs()
            assert proven.equals_route("traversal")
            corners = {pair for _, ring in repair.facets() for pair in ring}
            assert corners == set(proven.pairs())
            assert told["without_end"] == told["chains_stuck"] == 0
        assert compare_claims(P, Q, scalings[-1], repair.facets()).fault is None


SIMPLEX = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
SKEW = ((0, 0, 0), (0, 0, 1), (1, 0, 0), (1, 1, 0))
MISPRINTS = {
    "degree": (SIMPLEX, ("1", "2", "2"), {"degree": "printed"}, "not-supporting"),
    "errors": (SIMPLEX, ("1", "2", "2"), {"errors": "facets-of-P"}, "not-supporting"),
    "chains": (
        SKEW,
        ("1", "1", "2"),
        {"errors": "chains-from-P", "search": "beside-errors"},
        "not-supporting",
    ),
    "search": (SIMPLEX, ("1", "2", "2"), {"search": "ee-errors"}, "missing"),
    "closed": (SIMPLEX, ("3", "1", "1"), {"ties": "closed"}, "overlapping"),
    "open": (SIMPLEX, ("3", "1", "1"), {"ties": "open"}, "missing"),
}


@pytest.mark.parametrize("name", MISPRINTS)
def test_each_printed_sentence_loses_the_sum_of_two_tetrahedra(name: str) -> None:
    """The smallest that a search found; with the corners 0 and 1."""
    corners, scaling, printed, fault = MISPRINTS[name]
    P, Q = body(*SIMPLEX), body(*corners)
    right = repaired(P, Q, scaling, CORRECTED)
    wrong = repaired(P, Q, scaling, CORRECTED | printed)
    assert compare_claims(P, Q, scaling, right.facets()).fault is None
    found = compare_claims(P, Q, scaling, wrong.facets())
    assert found.fault == fault
    assert not wrong.has_exact_pairs()
    assert_is_witness(P, Q, scaling, found)


def assert_is_witness(P: Body, Q: Body, scaling: Scaling, found: ClaimComparison) -> None:
    """A vertex beyond a claimed facet lies above the facet's plane, by a tetrahedron's volume; a
    missing facet bounds the hull."""
    factors = tuple(map(Fraction, scaling))
    first, second = P.surface().points(), Q.surface().points()

    def corner(pair: tuple[int, int]) -> tuple[Fraction, ...]:
        p, q = first[pair[0]], second[pair[1]]
        return tuple(s * Fraction(x) + Fraction(y) for s, x, y in zip(factors, p, q, strict=True))

    ring = [corner(pair) for pair in found.ring]
    if found.vertex is not None:
        assert sextuple(*ring[:3], corner(found.vertex)) > 0
    elif found.fault == "missing":
        every = [corner((p, q)) for p in range(P.vertices) for q in range(Q.vertices)]
        assert all(sextuple(*ring[:3], point) <= 0 for point in every)


def sextuple(
    a: tuple[Fraction, ...], b: tuple[Fraction, ...], c: tuple[Fraction, ...],
    d: tuple[Fraction, ...],
) -> Fraction:  # fmt: skip
    """Six times the tetrahedron's volume, positive if d lies above the plane through a, b, c."""
    u, v, w = ([x - y for x, y in zip(p, a, strict=True)] for p in (b, c, d))
    return (
        w[0] * (u[1] * v[2] - u[2] * v[1])
        + w[1] * (u[2] * v[0] - u[0] * v[2])
        + w[2] * (u[0] * v[1] - u[1] * v[0])
    )


def test_as_printed_the_simplex_beside_itself_is_lost() -> None:
    P = body(*SIMPLEX)
    scaling = ("1", "2", "2")
    found = compare_claims(P, P, scaling, repaired(P, P, scaling, {}).facets())
    assert found.fault == "not-supporting"
    assert_is_witness(P, P, scaling, found)


@pytest.mark.parametrize("form", ["printed", "corrected"])
def test_degrees_witnesses_and_ends_are_those_of_computer_algebra(form: str) -> None:
    """Compares every descent step of a few updates; an edge level with the facet counts as not
    above; the degree is squared. If several edges are witnesses, the step takes one of them, and
    the rest of the descent is not compared."""
    dice = random.Random(11)
    steps = ends = without_end = 0
    for _ in range(draws(20, 50)):
        P, Q = hull(dice), hull(dice)
        scaling = random_scaling(dice)
        readings = {"degree": form, "ties": "closed"}
        repair = _core.PaperRepair(P, Q, UNIT, "rational", readings)
        rings = [[p for p, _ in ring] for kind, ring in repair.facets() if kind == "fv"]
        before = [ring[0][1] for kind, ring in repair.facets() if kind == "fv"]
        errors = {error["facet"]: error for error in dict(repair.update(scaling))["errors"]}
        points, corners = Q.surface().points(), P.surface().points()
        for number, (ring, start) in enumerate(zip(rings, before, strict=True)):
            facet = [corners[p] for p in ring]
            way, end = descent(facet, points, neighbours(Q), start, scaling, form)
            if not way:
                assert number not in errors
                continue
            error = errors[number]
            several = len(way[-1][1]) > 1
            assert several or len(way) == len(error["steps"])
            for step, (at, witnesses, most) in zip(error["steps"], way, strict=not several):
                assert (step[0], Fraction(step[2])) == (at, Fraction(int(most.p), int(most.q)))
                assert step[1] in witnesses
                steps += 1
            if not several:
                assert error["end"] == end
                ends += end is not None
                without_end += end is None
    assert min(steps, 2 * ends) > draws(15, 40)
    assert (without_end > 0) is (form == "printed")


def neighbours(body: Body) -> dict[int, set[int]]:
    found: dict[int, set[int]] = {k: set() for k in range(body.vertices)}
    for ring in body.surface().rings():
        for a, b in zip(ring, [*ring[1:], ring[0]], strict=True):
            found[a].add(b)
            found[b].add(a)
    return found


def test_a_degree_that_is_never_zero_never_ends() -> None:
    """Printed, and with the degree itself as the test: at the compatible vertex too it is a
    distance."""
    P, Q = body(*SIMPLEX), body(*SKEW)
    readings = CORRECTED | {"degree": "printed", "test": "degree"}
    repair = _core.PaperRepair(P, Q, UNIT, "rational", readings)
    told = dict(repair.update(UNIT))
    assert told["fv_errors"] == told["vf_errors"] == P.facets
    assert told["without_end"] == 2 * P.facets
    assert all(error["end"] is None for error in told["errors"])
    met = [[step[0] for step in error["steps"]] for error in told["errors"]]
    assert all(len(way) == len(set(way)) for way in met)


@pytest.mark.parametrize("arithmetic", ["double", "mpfr:53", "mpfr:200"])
def test_rounded_coordinates_are_an_ulp_off(arithmetic: str) -> None:
    dice = random.Random(3)
    bits = int(arithmetic.partition(":")[2] or 53)
    most = Fraction(0)
    for _ in range(20):
        P, Q, scaling = hull(dice), hull(dice), random_scaling(dice)
        repair = repaired(P, Q, scaling, CORRECTED, arithmetic)
        off = largest_distance(P, Q, scaling, repair, bits)
        assert off <= 2
        most = max(most, off)
        exact = repaired(P, Q, scaling, CORRECTED)
        assert largest_distance(P, Q, scaling, exact, bits) == 0
    assert most > 0


def test_doubles_and_mpfr_of_53_bits_answer_alike() -> None:
    dice = random.Random(4)
    for readings in ({}, CORRECTED):
        for _ in range(20):
            P, Q, scaling = hull(dice), hull(dice), random_scaling(dice)
            one, other = (
                repaired(P, Q, scaling, readings, arithmetic)
                for arithmetic in ("double", "mpfr:53")
            )
            assert one.facets() == other.facets()
            pairs = [pair for _, ring in one.facets() for pair in ring]
            assert one.coordinates(pairs) == other.coordinates(pairs)


def test_a_wrong_scaling_arithmetic_reading_or_vertex_is_refused() -> None:
    P = body(*SIMPLEX)
    for scaling, arithmetic, readings in (
        (("0", "1", "1"), "rational", {}),
        (UNIT, "mpfr:x", {}),
        (UNIT, "rational", {"degree": "right"}),
        (UNIT, "rational", {"no reading": "printed"}),
    ):
        with pytest.raises(_core.BadInput):
            _core.PaperRepair(P, P, scaling, arithmetic, readings)
    repair = _core.PaperRepair(P, P, UNIT)
    with pytest.raises(_core.BadInput):
        repair.update(("1", "-1", "1"))
    assert repair.has_exact_pairs()
    with pytest.raises(IndexError):
        repair.coordinates([(4, 0)])
