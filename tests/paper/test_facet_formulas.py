"""The contacts of two facets as the paper's text has them, over rational numbers, against computer
algebra: each sentence of Section 5 as printed and in its right form, in all combinations."""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from itertools import product

import pytest
from minkref import _core
from minkref.oracle.symbolic.space.paper_contacts import Corner, FacetPair, facet
from thoroughness import draws

PAIRS = draws(2, 24)
Point = tuple[int, int, int]
CHOICES = {
    "corner": ("lines", "itself"),
    "crossing": ("points", "determinant"),
    "solve": ("printed", "least-squares", "corrected"),
    "ends": ("sides", "lines"),
}
PARALLEL = {
    "corner": ("lines", "itself"),
    "solve": ("printed", "least-squares", "corrected"),
    "parallel": ("followed", "left-out"),
}
COPLANAR = {
    "coplanar": ("turned", "dropped", "left-out"),
    "plane-observation": ("printed", "corrected"),
    "plane-solve": ("printed", "least-squares", "corrected"),
    "plane-interval": ("printed", "corrected"),
}
OTHERS = {
    "corner": "lines", "crossing": "points", "solve": "printed", "ends": "sides",
    "parallel": "followed", "coplanar": "turned", "plane-observation": "printed",
    "plane-solve": "printed", "plane-interval": "printed",
}  # fmt: skip


def point(dice: random.Random, most: int = 3) -> Point:
    return dice.randint(-most, most), dice.randint(-most, most), dice.randint(-most, most)


def turns(corners: list[Corner]) -> Point:
    """A normal at the scale 1."""
    a, b, c = (tuple(Fraction(s) + t for s, t in zip(p, q, strict=True)) for p, q in corners[:3])
    u, v = ([y - x for x, y in zip(a, end, strict=True)] for end in (b, c))
    return (
        u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0],
    )  # fmt: skip


def drawn_facet(dice: random.Random) -> list[Corner]:
    """A triangle of P at a vertex of Q, one of Q at a vertex of P, or a parallelogram."""
    while True:
        kind = dice.randrange(3)
        if kind < 2:
            at = point(dice)
            ring = [point(dice), point(dice), point(dice)]
            corners: list[Corner] = [(p, at) if kind == 0 else (at, p) for p in ring]
        else:
            p, q = (point(dice), point(dice)), (point(dice), point(dice))
            corners = [(p[i], q[j]) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
        if any(turns(corners)):
            return corners


def flat_facet(dice: random.Random, height: tuple[int, int]) -> list[Corner]:
    """The same, parallel to z = 0, at the height a s + b."""
    a, b = height
    while True:
        corners = [((*p[:2], a), (*q[:2], b)) for p, q in drawn_facet(dice)]
        if turns(corners)[2]:
            return corners


def has_parallel_sides(first: list[Corner], second: list[Corner]) -> bool:
    def ways(corners: list[Corner]) -> list[tuple[Fraction, Fraction]]:
        places = [[Fraction(a) + b for a, b in zip(p, q, strict=True)] for p, q in corners]
        return [
            (b[0] - a[0], b[1] - a[1]) for a, b in zip(places, places[1:] + places[:1], strict=True)
        ]

    return any(u[0] * v[1] == u[1] * v[0] for u, v in product(ways(first), ways(second)))


@dataclass(frozen=True)
class Drawn:
    """Two facets, as texts and by computer algebra."""

    first: list[Corner]
    second: list[Corner]
    symbolic: FacetPair


def drawn(first: list[Corner], second: list[Corner]) -> Drawn:
    return Drawn(first, second, FacetPair(facet(first), facet(second)))


@cache
def general_pairs() -> list[Drawn]:
    dice = random.Random(51)
    return [drawn(drawn_facet(dice), drawn_facet(dice)) for _ in range(PAIRS)]


@cache
def parallel_pairs() -> list[Drawn]:
    dice = random.Random(52)
    return [
        drawn(flat_facet(dice, (0, dice.randint(1, 3))), flat_facet(dice, (1, 0)))
        for _ in range(2 * PAIRS)
    ]


@cache
def coplanar_pairs() -> list[Drawn]:
    dice = random.Random(56)
    pairs: list[Drawn] = []
    while len(pairs) < 2 * PAIRS:
        first, second = flat_facet(dice, (2, 1)), flat_facet(dice, (2, 1))
        if not has_parallel_sides(first, second):
            pairs.append(drawn(first, second))
    return pairs


def text(corners: list[Corner]) -> list[tuple[tuple[str, ...], tuple[str, ...]]]:
    return [(tuple(map(str, p)), tuple(map(str, q))) for p, q in corners]


def compare(pairs: list[Drawn], readings: dict[str, str]) -> int:
    """The number of events; all scales must be equal."""
    given, events = {**OTHERS, **readings}, 0
    for pair in pairs:
        contacts = _core.facet_contacts(text(pair.first), text(pair.second), given)
        found = [scale and Fraction(scale) for _, scale in contacts]
        expected = [
            scale and Fraction(int(scale.p), int(scale.q))
            for scale in pair.symbolic.contacts(given)
        ]
        assert found == expected, (pair.first, pair.second)
        events += sum(map(bool, found))
    return events


def combinations(choices: dict[str, tuple[str, ...]]) -> list[dict[str, str]]:
    return [dict(zip(choices, values, strict=True)) for values in product(*choices.values())]


@pytest.mark.parametrize("readings", combinations(CHOICES), ids=lambda one: ",".join(one.values()))
def test_facets_in_general_position(readings: dict[str, str]) -> None:
    assert compare(general_pairs(), readings) > 0


@pytest.mark.parametrize("readings", combinations(PARALLEL), ids=lambda one: ",".join(one.values()))
def test_parallel_facets(readings: dict[str, str]) -> None:
    events = compare(parallel_pairs(), readings)
    has_a_scale = readings["corner"] == "itself" and readings["parallel"] == "followed"
    assert (events > 0) == has_a_scale


@pytest.mark.parametrize("readings", combinations(COPLANAR), ids=lambda one: ",".join(one.values()))
def test_coplanar_facets(readings: dict[str, str]) -> None:
    events = compare(coplanar_pairs(), readings)
    assert (events > 0) == (readings["coplanar"] != "left-out")
