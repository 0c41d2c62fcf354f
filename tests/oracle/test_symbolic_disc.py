"""A disc swept along a polygon: algebraic scales, checked against the definition of the contact."""

from __future__ import annotations

import random
from itertools import combinations, pairwise, product

import sympy as sp
from minkref.fuzz.plane.families.small_operands import star
from minkref.oracle.symbolic import solutions
from minkref.oracle.symbolic.disc.disc import (
    Offset,
    arcs,
    eliminated_polynomial,
    offsets,
    three_circles,
    three_lines,
)
from minkref.oracle.symbolic.disc.disc_contact import (
    Feature,
    adjacent,
    pair_disc_events,
    polygon_events,
)
from minkref.oracle.symbolic.disc.radicals import Radical, number, square_root
from minkref.oracle.symbolic.moving import cross
from minkref.oracle.symbolic.rational import Rational
from minkref.oracle.symbolic.standing import minus
from mpmath import mp, mpf
from symbolic_digits import ROUNDING, crossings, decimal, reached
from thoroughness import draws

SEED = 1729
SLOT = [(0, 0), (12, 0), (12, 6), (8, 6), (8, 2), (4, 2), (4, 6), (0, 6)]


def random_ring(rng: random.Random, size: int, corners: int) -> list[tuple[int, int]]:
    """A star with the middle inside; simple, for its angles are different."""
    while True:
        ring = star(rng, size, corners)
        around = [*ring[1:], ring[0]]
        if len(ring) > 3 and all(
            a[0] * b[1] > a[1] * b[0] for a, b in zip(ring, around, strict=True)
        ):
            return ring


def value_at(polynomial: list[int] | tuple[int, ...], x: Radical) -> Radical:
    found = number(0)
    for coefficient in polynomial:
        found = found * x + coefficient
    return found


def test_walls_of_a_slot_meet_where_the_disc_fills_it() -> None:
    """Walls at distance 4: offset edges face each other on one line at s r = 2."""
    events = polygon_events(SLOT, Rational(1))
    scales = {event.scale.value for event in events}
    assert number(2) in scales
    facing = [e for e in events if e.scale.value == number(2) and e.name == "end on line"]
    assert facing and all(e.scale.polynomial == (1, -2) for e in facing)
    halved = polygon_events(SLOT, Rational(2))
    assert [e.scale.value for e in halved] == [(e.scale.value or number(0)) / 2 for e in events]


def test_circles_of_two_prongs_touch_at_half_their_distance() -> None:
    prongs = [(0, 0), (9, 0), (7, 5), (5, 1), (3, 2), (1, 6)]
    a, b = (arc for arc in arcs(prongs) if arc.centre[1] > 4)
    (event,) = [e for e in pair_disc_events(a, b, Rational(1)) if e.name == "circles"]
    assert event.scale.polynomial == (4, 0, -37)  # s = sqrt(6^2 + 1) / 2
    assert event.scale.interval is not None and event.scale.interval[0] < event.scale.interval[1]


def test_degrees_are_those_stated_and_reached() -> None:
    kept = solutions.read()
    stated = {n: x["degree"] for n, x in kept.items() if n.startswith("disc ")}
    assert stated == {
        "disc end on line": 4,
        "disc end on circle": 2,
        "disc circle on line": 2,
        "disc circles": 2,
        "disc three lines": 8,
        "disc three circles": 2,
    }
    # Edges with squared lengths 5, 10 and 13, whose products are no squares.
    edges = [
        Offset((Rational(x), Rational(y)), (Rational(x + dx), Rational(y + dy)))
        for (x, y), (dx, dy) in (((0, 0), (2, 1)), ((9, 2), (-1, 3)), ((3, 7), (-2, -3)))
    ]
    found = three_lines(edges[0], edges[1], edges[2], Rational(1))
    mirrored = [Offset(e.q, e.p) for e in edges]
    inside = three_lines(mirrored[0], mirrored[1], mirrored[2], Rational(1))
    assert {found.case, inside.case} == {"once", "never"}
    root = found if found.case == "once" else inside
    assert len(root.polynomial) == 1 + 8


def test_minimal_polynomials_are_those_of_sympy() -> None:
    x = sp.Symbol("x")
    for a, b, c in ((2, 3, 0), (5, 5, 1), (8, 18, 0), (2, 3, 6), (12, 27, 3)):
        ours = square_root(Rational(a)) + square_root(Rational(b)) * 3 - square_root(Rational(c, 7))
        value = sp.sqrt(a) + 3 * sp.sqrt(b) - sp.sqrt(sp.Rational(c, 7))
        expected = sp.Poly(sp.minimal_polynomial(value, x), x).all_coeffs()
        assert ours.minimal_polynomial() == [int(k) for k in expected]


def test_radicals_obey_the_laws_of_a_field() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)

    def drawn() -> Radical:
        roots = (square_root(Rational(rng.randint(0, 30), rng.randint(1, 9))) for _ in range(3))
        return sum((x * rng.randint(-3, 3) for x in roots), number(rng.randint(-4, 4)))

    for _ in range(draws(50, 150)):
        a, b, c = drawn(), drawn(), drawn()
        assert (a + b) * c == a * c + b * c
        assert (a - a).sign() == 0
        if b.terms:
            assert a / b * b == a
        low, high = a.isolated()
        assert low <= high and a.sign() == (decimal(a) > 0) - (decimal(a) < 0)
        assert (a - low).sign() >= 0 and (number(high) - a).sign() >= 0


def test_scales_are_roots_of_their_polynomials_and_isolated() -> None:
    """The minimal polynomial vanishes exactly; it has one root inside the interval (Sturm); and it
    divides the polynomial from which the lengths were eliminated."""
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    x = sp.Symbol("x")
    seen: dict[int, int] = {}
    for _ in range(count := draws(250, 500)):
        ring = random_ring(rng, rng.choice([3, 8, 30]), 6)
        # With the ring reversed, the disc is inside the polygon, and its offset edges close in.
        e = rng.sample(offsets(rng.choice([ring, ring[::-1]])), 3)
        v, w = minus(e[1].p, e[0].p), minus(e[2].p, e[0].p)
        found = three_lines(e[0], e[1], e[2], Rational(1))
        if found.value is None or found.interval is None:
            continue
        degree = len(found.polynomial) - 1
        seen[degree] = seen.get(degree, 0) + 1
        assert value_at(found.polynomial, found.value).sign() == 0
        minimal = sp.Poly([*found.polynomial], x)
        low, high = (sp.Rational(int(q.numerator), int(q.denominator)) for q in found.interval)
        assert minimal.count_roots(low, high) == 1
        general = eliminated_polynomial(
            "three lines", Rational(1), d=e[0].edge, e=e[1].edge, f=e[2].edge, v=v, w=w
        )
        whole = sp.Poly([sp.Rational(int(q.numerator), int(q.denominator)) for q in general], x)
        assert whole.rem(minimal).is_zero
    assert seen.get(8, 0) > count / 50 and seen.get(4, 0) > count / 100, seen


def test_three_circles_pass_through_one_point_at_the_circumradius() -> None:
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    for _ in range(60):
        found = arcs(random_ring(rng, 8, 7))
        if len(found) < 3:
            continue
        a, b, c = rng.sample(found, 3)
        scale = three_circles(a, b, c, Rational(2))
        twice = abs(cross(minus(b.centre, a.centre), minus(c.centre, a.centre)))
        sides = [minus(u.centre, v.centre) for u, v in ((a, b), (b, c), (c, a))]
        product_of_squares = Rational(1)
        for side in sides:
            product_of_squares *= side[0] ** 2 + side[1] ** 2
        if twice == 0:
            assert scale.case == "never"
            continue
        assert scale.value is not None
        # The product of the sides is four times the area times the circumradius.
        assert (scale.value * 2) ** 2 == number(product_of_squares / (2 * twice) ** 2)


def test_a_scan_over_scales_finds_no_other_event() -> None:
    """Between neighbouring scales at which features touch, the number of points shared by two
    features stays constant. Pairs that touch at every scale (on one line) are counted, and few."""
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    changes = level = pairs = 0
    for _ in range(count := draws(5, 14)):
        ring = random_ring(rng, 6, 6)
        features: list[Feature] = [*offsets(ring), *arcs(ring)]
        for a, b in combinations(features, 2):
            if adjacent(a, b):
                continue
            events = pair_disc_events(a, b, Rational(1))
            if any(e.scale.case == "always" for e in events):
                level += 1
                continue
            pairs += 1
            marks = sorted({decimal(e.scale.value) for e in events if e.meet and e.scale.value})
            limits = [mpf(0), *marks, (marks[-1] if marks else mpf(1)) * 2 + 30]
            counts = []
            for low, high in pairwise(limits):
                scan = [low + (high - low) * k / mpf("17.03") for k in range(1, 18)]
                here = {crossings(a, b, s) for s in scan}
                assert len(here) == 1, (ring, a, b, marks)
                counts.append(here.pop())
            changes += sum(x != y for x, y in pairwise(counts))
    assert changes > 30 * count / 14 and 10 * level < pairs


def test_features_that_meet_reach_the_point_of_contact() -> None:
    """Angle on an arc and reach on an edge, in 60 digits, against the exact answer."""
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    seen = {True: 0, False: 0}
    for _ in range(count := draws(8, 24)):
        ring = random_ring(rng, 6, 6)
        features: list[Feature] = [*offsets(ring), *arcs(ring)]
        for a, b in combinations(features, 2):
            for event in pair_disc_events(a, b, Rational(1)):
                if event.scale.value is None or event.at is None:
                    continue
                s = decimal(event.scale.value)
                x, y = (decimal(k) for k in event.at)
                there = all(reached(f, x, y, s) for f in (a, b))
                assert event.meet == there
                seen[there] += 1
    assert min(seen.values()) > 50 * count / 24


def test_scales_satisfy_the_definition_in_sixty_digits() -> None:
    """The distance of the end from the line or the circle, and of the circle from the line or the
    other circle, is the radius up to rounding."""
    print(f"seed {SEED}")
    rng = random.Random(SEED)
    for _ in range(6):
        ring = random_ring(rng, 6, 6)
        for a, b in product(arcs(ring), offsets(ring)):
            for event in pair_disc_events(a, b, Rational(1, 3)):
                if event.scale.value is None or event.at is None:
                    continue
                radius = decimal(event.scale.value) / 3
                x, y = (decimal(k) for k in event.at)
                p, e = ([mpf(int(k)) for k in v] for v in (b.p, b.edge))
                from_line = ((x - p[0]) * e[1] - (y - p[1]) * e[0]) / mp.hypot(*e)
                from_centre = mp.hypot(x - int(a.centre[0]), y - int(a.centre[1]))
                assert abs(from_line - radius) < ROUNDING
                assert abs(from_centre - radius) < ROUNDING
