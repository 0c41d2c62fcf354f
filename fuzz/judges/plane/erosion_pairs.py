"""Draws pairs to erode: a set, a shape with room inside or an exact fit, and a scale."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.plane import Point, box
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.dice import Dice
from minkref.fuzz.plane.families.drawing import shape_text

MOST = 400  # products of the numbers of vertices, for the slow engine
GENERAL = ("random", "convex", "holes", "collinear", "star", "rational", "spiral", "thin")
DEGENERATE = (
    "fit", "comb", "lattice", "cells", "touching", "nested", "spiral", "small-holes", "passing",
    "degenerate", "leaning",
)  # fmt: skip
FACTORS = ("1", "1", "5/4", "3/2", "2", "3", "5")
PATIENCE = 200


def erosion_case(seed: int, index: int) -> Case:
    """Draw a case by seed and index: P, Q, and a scale to erode at; every third case degenerate."""
    name = f"erosion:{seed}:{index}"
    for attempt in range(PATIENCE):
        dice = Dice(f"minkref {name} {attempt}")
        drawn = _degenerate(dice, seed, index) if index % 3 == 2 else _general(dice, seed, index)
        if drawn is None:
            continue
        P, Q, scale = drawn
        if P.is_region and not Q.is_empty and P.vertices * Q.vertices <= MOST:
            return Case(CaseName(name, "erosion"), P, Q, scale, "P", "Q")
    raise RuntimeError(f"{name} draws nothing")


Drawn = tuple[_core.PolygonSet, _core.PolygonSet, str]


def _operands(dice: Dice, families: tuple[str, ...], seed: int, index: int) -> Drawn:
    pair = FAMILIES[dice.choice(families)].pair(seed, index // 4 + dice.randrange(60))
    P, Q = (_core.PolygonSet.from_json(text) for text in (pair.P, pair.Q))
    return P, Q, pair.scale


def _general(dice: Dice, seed: int, index: int) -> Drawn | None:
    """Draw a pair from a family, at a scale with room for Q, or barely."""
    P, Q, _ = _operands(dice, GENERAL, seed, index)
    return _with_room(dice, P, Q)


def _with_room(dice: Dice, P: _core.PolygonSet, Q: _core.PolygonSet) -> Drawn | None:
    if not P.is_region or Q.is_empty:
        return None
    least = _core.least_scale_with_room(P, Q)
    if least is None:
        return None
    return P, Q, str((Fraction(least) or 1) * Fraction(dice.choice(FACTORS)))


def _degenerate(dice: Dice, seed: int, index: int) -> Drawn | None:
    P, Q, scale = _operands(dice, DEGENERATE, seed, index)
    kind = dice.randrange(6)
    if kind == 0:  # what is around P, by -Q: fits of the sum, now in a container
        return (_core.Outside(P).set, _core.negated(Q), scale) if P.is_region else None
    if kind == 1:  # a sum: eroded by Q, P is back at the least
        if not P.is_region or Q.is_empty:
            return None
        return _core.minkowski_sum(P, Q, scale).region, Q, "1"
    if kind == 2:  # at a scale at which the erosion changes
        found = _with_room(dice, P, Q)
        return None if found is None else _at_event(dice, *found)
    if kind == 3:  # a point or a segment
        ends: list[Point] = [
            (dice.randint(-3, 3), dice.randint(-3, 3)) for _ in range(dice.randint(1, 2))
        ]
        if len(set(ends)) < len(ends):
            return None
        flat = _core.PolygonSet.from_json(shape_text([[ends]]))
        return _with_room(dice, P, flat)
    if kind == 4:  # a room that a box fills from wall to wall
        width, height = dice.randint(1, 3), dice.randint(1, 3)
        walls = _slot(dice, width, height)
        return walls, _core.PolygonSet([box(0, 0, width, height)]), "1"
    return _with_room(dice, P, Q)


def _slot(dice: Dice, width: int, height: int) -> _core.PolygonSet:
    """Join rooms by passages as wide as the box."""
    bars = [box(dice.randint(0, 6), dice.randint(0, 6), width, dice.randint(1, 9))]
    bars += [box(dice.randint(0, 6), dice.randint(0, 6), dice.randint(1, 9), height)]
    bars += [box(dice.randint(0, 6), dice.randint(0, 6), width + 1, height + dice.randint(0, 2))]
    return _core.combined("union", [_core.PolygonSet([bar]) for bar in bars])[0]


def _at_event(dice: Dice, P: _core.PolygonSet, Q: _core.PolygonSet, scale: str) -> Drawn:
    if P.vertices * Q.vertices > MOST:
        return P, Q, scale
    first = Fraction(_core.least_scale_with_room(P, Q) or 1)
    window = str(first / 2 or Fraction(1, 2)), str(6 * first or 6)
    index = _core.ScaleIndex(_core.Outside(P).set, _core.negated(Q), *window)
    scales = list(map(str, index.event_scales()))
    return P, Q, dice.choice(scales) if scales else scale
