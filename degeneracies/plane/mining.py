"""Searches small random pairs for critical scales of a certain kind."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import Any

from minkref import _core
from minkref.degeneracies.family import NothingDrawn
from minkref.degeneracies.plane.draft import Draft, Facts
from minkref.degeneracies.plane.shapes import changed, number
from minkref.fuzz.geometry.plane import Shape, box
from minkref.fuzz.plane.families.drawing import convex, shape_text
from minkref.fuzz.plane.families.hard_numbers import polygon
from minkref.fuzz.plane.families.outlines import comb

PATIENCE = 60
FROM, TO = "1/16", "16"
Pair = tuple[Shape, Shape]
Row = dict[str, Any]


def mined(dice: Random, draw: Callable[[Random], Pair], accept: Callable[[Facts], bool]) -> Draft:
    """Returns a pair with an accepted critical scale, in other coordinates."""
    for _ in range(PATIENCE):
        P, Q = draw(dice)
        try:
            first, second = (_core.PolygonSet.from_json(shape_text(shape)) for shape in (P, Q))
            first.validate("P")
            second.validate("Q")
            events = _core.ArrangementEvents(first, second, FROM, TO)
        except _core.BadInput:
            continue
        rows = events.rows(events.of_kind("arrangement"))
        scales = sorted({Fraction(row[0]) for row in rows})
        dice.shuffle(scales)
        for scale in scales[:12]:
            draft = Draft(P, Q, scale)
            if accept(Facts.of(draft)):
                return changed(dice, draft)
    raise NothingDrawn


def of_kind(kind: str) -> Callable[[Facts], bool]:
    return lambda facts: any(row["kind"] == kind for row in facts.arrangement)


def small_pair(dice: Random) -> Pair:
    """Polygons of three to seven vertices, perhaps with a hole."""
    return [polygon(dice, dice.randint(3, 6), False)], [polygon(dice, dice.randint(3, 7))]


def convex_pair(dice: Random) -> Pair:
    return [[convex(dice, dice.randint(3, 5), 6)]], [polygon(dice, dice.randint(4, 7), False)]


def upright_pair(dice: Random) -> Pair:
    """A box or an L, and a comb: all edges upright or level."""
    w, h = number(dice, 1, 6), number(dice, 1, 6)
    P = box(0, 0, w, h)
    if dice.random() < 0.5:
        P = [(0, 0), (w, 0), (w, h / 3), (w / 2, h / 3), (w / 2, h), (0, h)]
    teeth = dice.randint(2, 3)
    widths, gaps = ([number(dice, 1, 5) for _ in range(n)] for n in (teeth, teeth - 1))
    return [[P]], [[comb(dice, widths, gaps)]]


def ends_at(facts: Facts, row: Row) -> list[int]:
    """Counts, for each edge of an event, its ends at the event's place."""
    place = Fraction(row["at"][0]), Fraction(row["at"][1])
    return [facts.convolution.ends(edge).count(place) for edge in row["edges"]]


def overlap_is_whole(facts: Facts, row: Row) -> bool:
    """Whether one of two overlapping edges equals the shared segment."""
    shared = {tuple(map(Fraction, row[name])) for name in ("at", "to")}
    return any(set(facts.convolution.ends(edge)) == shared for edge in row["edges"])
