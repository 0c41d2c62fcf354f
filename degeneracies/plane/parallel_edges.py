"""Parallel edges, and edges on one line."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.certify.case_text import ring_numbers
from minkref.certify.plane.coincidence import ends_of
from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.degeneracies.plane.mining import mined, upright_pair
from minkref.degeneracies.plane.shapes import changed, left_of
from minkref.fuzz.geometry.plane import Point, Ring


def _with_edge(dice: Random, a: Point, b: Point) -> Ring:
    """A triangle or a quadrangle on the left of an edge."""
    c = left_of(dice, a, b, 9)
    between = [(left_of(dice, a, b, 9))] if dice.random() < 0.5 else []
    for d in between:
        sides = ((b, d, c), (d, c, a))
        if all((q[0] - p[0]) * (r[1] - p[1]) > (q[1] - p[1]) * (r[0] - p[0]) for p, q, r in sides):
            return [a, b, d, c]
    return [a, b, c]


def _parallel(dice: Random, sense: int) -> Draft:
    d = dice.randint(1, 5), dice.randint(-4, 4)
    p, q = dice.randint(1, 3), dice.randint(1, 3) * sense
    P = _with_edge(dice, (0, 0), (p * d[0], p * d[1]))
    Q = _with_edge(dice, (0, 0), (q * d[0], q * d[1]))
    zero = ("orientation", ((0, 0), (1, 0), (1, 1)))
    scale = Fraction(dice.randint(1, 9), dice.randint(1, 9))
    return changed(dice, Draft([[P]], [[Q]], scale, (zero,)))


def _same(dice: Random, size: int) -> Draft:
    return _parallel(dice, 1)


def _opposite(dice: Random, size: int) -> Draft:
    return _parallel(dice, -1)


def _edge(facts: Facts, operand: int) -> tuple[Fraction, Fraction]:
    (x, y), (u, v) = (facts.vertices.P, facts.vertices.Q)[operand][:2]
    return u - x, v - y


def _sense(facts: Facts) -> Fraction:
    """Positive if the first edges of P and Q have the same direction, negative if opposite, zero if
    not parallel."""
    (x, y), (u, v) = _edge(facts, 0), _edge(facts, 1)
    return x * u + y * v if x * v == y * u else Fraction(0)


def _once(dice: Random, size: int) -> Draft:
    return mined(dice, upright_pair, _is_once)


def _is_once(facts: Facts) -> bool:
    """An S-edge and a T-edge meet on a line that they share at this scale and at no other."""
    rings = ring_numbers(facts.P), ring_numbers(facts.Q)
    for row in facts.arrangement:
        kinds = {edge[0] for edge in row["edges"]}
        if row["kind"] != "parallel" or kinds != {"S", "T"}:
            continue
        first, second = (ends_of(edge, rings) for edge in row["edges"])
        apart = ("orientation", (*first, second[0]))
        if facts.vertices.sign_between(apart, facts.scale, 2 * facts.scale) != 0:
            return True
    return False


def _always(dice: Random, size: int) -> Draft:
    """An edge of P on the axis, and two edges of Q, at the feet of an arch."""
    a, b, gap = (dice.randint(1, 6) for _ in range(3))
    low = dice.randint(1, 4)
    high = low + dice.randint(1, 4)
    P = _with_edge(dice, (0, 0), (a, 0))
    Q: Ring = [
        (0, 0), (b, 0), (b, low), (b + gap, low), (b + gap, 0), (2 * b + gap, 0),
        (2 * b + gap, high), (0, high),
    ]  # fmt: skip
    zero = ("orientation", ((0, 0), (1, 0), (0, 4)))
    scale = Fraction(dice.randint(1, 9), dice.randint(1, 9))
    return changed(dice, Draft([[P]], [[Q]], scale, (zero,)))


FAMILIES = (
    Family(
        "parallel-same",
        "an edge of P and one of Q with the same direction",
        _same,
        lambda facts: _sense(facts) > 0,
    ),
    Family(
        "parallel-opposite",
        "an edge of P and one of Q with opposite directions",
        _opposite,
        lambda facts: _sense(facts) < 0,
    ),
    Family(
        "one-line-at-a-scale",
        "an S-edge and a T-edge on one supporting line at one scale",
        _once,
        _is_once,
    ),
    Family(
        "one-line-always",
        "an S-edge and a T-edge on one supporting line at all scales",
        _always,
        lambda facts: (
            facts.vertices.sign_between(facts.zeros[0], facts.scale, 2 * facts.scale) == 0
        ),
    ),
)
