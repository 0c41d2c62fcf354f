"""The search for a fault and the check of the fault agree, though they share nothing."""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

import pytest
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.fault_search import decided, inside, outside
from minkref.fuzz.space.known_sum import known_sum
from minkref.fuzz.space.meeting import Meeting
from minkref.fuzz.space.pair import SpacePair
from minkref.fuzz.space.pairs import FAMILIES, space_pair
from minkref.fuzz.space.witness import holds
from thoroughness import THOROUGH, draws

DISTANCES = (Fraction(1, 1000), Fraction(1, 3))


def near_the_boundary(pair: SpacePair, dice: random.Random) -> Point:
    """A sum of two vertices, perhaps moved a little, or some point of the box."""
    s = pair.meeting.scale
    (p0, p1), (q0, q1) = pair.meeting.sP.box, pair.Q.box
    if dice.random() < 0.5:
        x, y, z = (
            p0[k] + q0[k] + (p1[k] + q1[k] - p0[k] - q0[k]) * Fraction(dice.randint(-1, 13), 12)
            for k in range(3)
        )
        return (x, y, z)
    p, q = dice.choice(pair.P.vertices), dice.choice(pair.Q.vertices)
    step = Fraction(dice.randint(-1, 1), 1000)
    return (s[0] * p[0] + q[0] + step, s[1] * p[1] + q[1], s[2] * p[2] + q[2])


@pytest.mark.parametrize("family", FAMILIES)
def test_decisions_distances_and_witnesses_agree(family: str) -> None:
    for index in (0, 7, 33) if THOROUGH else ((0, 7)[len(family) % 2],):
        pair = space_pair(family, 1, index)
        meeting, known = pair.meeting, known_sum(pair)
        dice = random.Random(index)
        for _ in range(draws(3, 5)):
            x = near_the_boundary(pair, dice)
            witness = decided(pair, x)
            assert holds(pair.P, pair.Q, pair.scale, witness)
            assert holds(pair.P, pair.Q, pair.scale, outside(x)) != witness.in_truth
            assert known.contains(x) == witness.in_truth
            assert (meeting.decide(x).contact != "empty") == witness.in_truth
            for distance in DISTANCES:
                apart = meeting.apart(x, distance)
                assert holds(pair.P, pair.Q, pair.scale, outside(x), distance) == apart
                assert apart or not known.clear_of(x, distance)
                deep = meeting.deep(x, distance)
                if deep is not None:
                    assert deep.p is not None and deep.q is not None
                    proof = inside(x, deep.p, deep.q)
                    assert holds(pair.P, pair.Q, pair.scale, proof, distance)
                    assert known.may_cover(x, distance)


def test_interiors_of_polycubes_meet_iff_those_of_two_cells_do() -> None:
    for index in (6, 17, 23):
        pair = space_pair("polycube", 4, index)
        meeting = Meeting(pair.P, pair.Q, Fraction(1))
        corners = {
            (a[0] + b[0], a[1] + b[1], a[2] + b[2]) for a in pair.P_cells for b in pair.Q_cells
        }
        low, high = (f(c[k] for c in corners for k in range(3)) for f in (min, max))
        for n, x in enumerate(product(range(2 * low - 1, 2 * high + 6), repeat=3)):
            if n % 23:
                continue
            place = (Fraction(x[0], 2), Fraction(x[1], 2), Fraction(x[2], 2))
            gaps = [max(abs(place[k] - c[k] - 1) for k in range(3)) for c in corners]
            nearest = min(gaps)
            kind = "overlap" if nearest < 1 else "touch" if nearest == 1 else "empty"
            assert meeting.decide(place).contact == kind
