"""Holes of the sum that close, open, merge, or never exist."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random

from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.degeneracies.plane.mining import mined
from minkref.degeneracies.plane.shapes import changed, corridor, framed, number
from minkref.fuzz.geometry.plane import Ring, Shape, box
from minkref.fuzz.plane.families.drawing import convex

CORRIDORS: tuple[tuple[tuple[int, int], ...], ...] = (
    ((0, 0), (6, 0), (6, 6)),
    ((0, 0), (0, -7), (5, -7)),
    ((0, 6), (0, 0), (7, 0), (7, 6)),
    ((0, 0), (6, 0), (6, 6), (12, 6)),
    ((0, 0), (0, 6), (-6, 6), (-6, 12), (-12, 12)),
)


def _changes(facts: Facts, change: str) -> list[dict[str, object]]:
    return [row for row in facts.topology if row["feature"] == "hole" and row["change"] == change]


def _dies_by(kind: str) -> Callable[[Facts], bool]:
    def belongs(facts: Facts) -> bool:
        """Whether a hole dies at a point with events of this kind only."""
        kinds: dict[object, set[str]] = {}
        for row in facts.arrangement:
            kinds.setdefault(row["at"], set()).add(row["kind"])
        return any(
            kinds.get(row["at"]) == {kind} and [row["at"]] in facts.passages
            for row in _changes(facts, "death")
        )

    return belongs


_by_pair, _by_triple = _dies_by("pair"), _dies_by("triple")


def _framed_pair(dice: Random) -> tuple[Shape, Shape]:
    """A triangle or quadrangle, and a frame around a ring that may have a reflex vertex."""
    hole = convex(dice, dice.randint(3, 5), 12)
    if dice.random() < 0.4:
        a, b, c, d = (dice.randint(2, 9) for _ in range(4))
        hole = [(0, 0), (a + b, dice.randint(-2, 2)), (a + b, c), (a, c + dice.randint(0, 2)),
                (a, c + d), (dice.randint(-2, 0), c + d)]  # fmt: skip
    return [[convex(dice, dice.randint(3, 4), 4)]], [framed([hole])]


def _pair(dice: Random, size: int) -> Draft:
    return mined(dice, _framed_pair, _by_pair)


def _triple(dice: Random, size: int) -> Draft:
    return mined(dice, _framed_pair, _by_triple)


def _segment(dice: Random, size: int) -> Draft:
    """A box in a longer hole with the same width."""
    width, height = number(dice, 1, 6), number(dice, 1, 6)
    longer = number(dice, 1, 9)
    hole = box(0, 0, width, height + longer)
    return changed(dice, Draft([[box(0, 0, width, height)]], [framed([hole])], Fraction(1)))


def _polyline(dice: Random, size: int) -> Draft:
    """A square in a winding corridor as wide as the square."""
    width = Fraction(dice.randint(1, 6), dice.choice((1, 2, 3)))
    hole = corridor([(4 * x, 4 * y) for x, y in dice.choice(CORRIDORS)], width)
    return changed(dice, Draft([[box(0, 0, width, width)]], [framed([hole])], Fraction(1)))


def _born(dice: Random, size: int) -> Draft:
    """A growing frame, and a body that just fits the frame's hole."""
    return mined(dice, lambda dice: _framed_pair(dice)[::-1], _is_born)


def _is_born(facts: Facts) -> bool:
    return bool(_changes(facts, "birth"))


def _merge(dice: Random, size: int) -> Draft:
    """A frame that grows around two rooms with a door between, and a box as wide as the door."""
    door, room = number(dice, 1, 4), number(dice, 1, 4)
    depth = number(dice, 1, 4)
    wide, high = door + 2 * room, door + number(dice, 1, 6)
    hole: Ring = [
        (0, 0), (high, 0), (high, room), (high + depth, room), (high + depth, 0),
        (2 * high + depth, 0), (2 * high + depth, wide), (high + depth, wide),
        (high + depth, room + door), (high, room + door), (high, wide), (0, wide),
    ]  # fmt: skip
    Q = box(0, 0, door / 2, door)
    return changed(dice, Draft([framed([hole])], [[Q]], Fraction(1)))


def _is_merge(facts: Facts) -> bool:
    return bool(_changes(facts, "merge"))


def _small(dice: Random, size: int) -> Draft:
    """Holes shaped like P: most too small, one fitting, one larger."""
    P = convex(dice, dice.randint(3, 5), 5)
    factors = [Fraction(1), Fraction(dice.randint(5, 9), 4)]
    factors += [Fraction(1, dice.randint(2, 6)) for _ in range(dice.randint(2, 4))]
    holes: list[Ring] = []
    x0 = Fraction(0)
    for factor in dice.sample(factors, len(factors)):
        hole: Ring = [(-x * factor, -y * factor) for x, y in P]
        low, high = min(x for x, _ in hole), max(x for x, _ in hole)
        holes.append([(x - low + x0, y) for x, y in hole])
        x0 += high - low + 1
    return changed(dice, Draft([[P]], [framed(holes)], Fraction(1)))


def _is_small(facts: Facts) -> bool:
    """Whether at least two holes of Q leave no hole in the sum, and one does."""
    below, _, above = facts.counts
    return facts.Q.ring_count - 1 - below[1] >= 2 and above[1] >= 1 and bool(facts.topology)


def _has_passage(least: int, most: int | None = None) -> Callable[[Facts], bool]:
    def belongs(facts: Facts) -> bool:
        """A hole dies, and a tight passage of so many points is left."""
        lengths = [len(points) for points in facts.passages]
        fits = [n for n in lengths if n >= least and (most is None or n <= most)]
        return bool(fits and _changes(facts, "death"))

    return belongs


FAMILIES = (
    Family(
        "hole-to-point-by-pair",
        "a hole that closes to a point as a vertex passes an edge",
        _pair,
        _by_pair,
    ),
    Family(
        "hole-to-point-by-triple",
        "a hole that closes to a point as three edges pass through it",
        _triple,
        _by_triple,
    ),
    Family("hole-to-segment", "a hole that closes to a segment", _segment, _has_passage(2, 2)),
    Family("hole-to-polyline", "a hole that closes to a polyline", _polyline, _has_passage(3)),
    Family("hole-born", "a hole that is born inside the sum", _born, _is_born),
    Family("holes-merge", "two holes that merge", _merge, _is_merge),
    Family(
        "holes-too-small", "several holes of which few survive, one by nothing", _small, _is_small
    ),
)
