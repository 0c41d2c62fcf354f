"""Cuts at notches against the rule word for word, in plain fractions."""

from __future__ import annotations

import random
from fractions import Fraction

import cut_rule
import pytest
from minkref import PolygonSet, _core, read_text
from minkref.fuzz.plane.families.catalogue import FAMILIES
from thoroughness import draws

SEED = 830
#: Their pairs have few vertices, or reflex ones.
KINDS = (
    "random", "holes", "touching", "passing", "cells", "nested", "comb", "star", "spiral",
    "lattice", "rational", "leaning", "offset", "magnitude",
)  # fmt: skip


def edges(P: PolygonSet) -> list[cut_rule.Wall]:
    rings = [[(Fraction(x), Fraction(y)) for x, y in ring] for rings in P.rings() for ring in rings]
    return [wall for ring in rings for wall in zip(ring, ring[1:] + ring[:1], strict=True)]


def found(P: PolygonSet, notches: list[tuple[str, str]]) -> list[tuple[int, object, object]]:
    return [
        (notch, tuple(map(Fraction, start)), tuple(map(Fraction, end)))
        for start, end, notch, _ in _core.cut_at_notches(P, notches)[0]
    ]


@pytest.mark.parametrize("family", KINDS)
def test_each_cut_is_the_shortest_that_is_seen_and_resolves_its_notch(family: str) -> None:
    dice = random.Random(f"{SEED} {family}")
    for index in range(draws(3, 40)):
        pair = FAMILIES[family].pair(SEED, 7 * index)
        for text in (pair.P, pair.Q):
            P = read_text(text, "json")
            if not P.is_region:
                continue
            every = _core.reflex_vertices(P)
            shuffled = dice.sample(every, len(every))
            for notches in (every, shuffled[: 2 * len(every) // 3]):
                places = [(Fraction(x), Fraction(y)) for x, y in notches]
                expected = cut_rule.cuts(edges(P), places)
                assert found(P, notches) == expected, (SEED, family, index, text, notches)


def test_the_rule_sees_reflex_vertices_and_no_others() -> None:
    for index in range(draws(20, 200)):
        P = read_text(FAMILIES["random"].pair(SEED, index).P, "json")
        walls = edges(P)
        vertices = sorted({start for start, _ in walls})
        reflex = [v for v in vertices if cut_rule.reflex_sector(v, walls, walls)]
        told = [(Fraction(x), Fraction(y)) for x, y in _core.reflex_vertices(P)]
        assert told == reflex, (SEED, index)
