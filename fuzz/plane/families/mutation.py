"""Pairs close to a given pair: changes that know about rings, holes, the other operand and
events."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.plane import Shape, read_shape
from minkref.fuzz.plane.families.drawing import is_valid, shape_text
from minkref.fuzz.plane.families.hole_changes import HOLE_CHANGES
from minkref.fuzz.plane.families.probes import scale_probes
from minkref.fuzz.plane.families.vertex_changes import VERTEX_CHANGES

PATIENCE = 24
LONGEST = 40  # digits of a coordinate
MOST_VERTICES = 120
MOST_PAIRS = 900  # vertex pairs, for requests of events
CHANGES = (*VERTEX_CHANGES, *HOLE_CHANGES)


def mutate(dice: random.Random, P: str, Q: str, scale: str) -> tuple[str, str, str]:
    """Makes a valid pair by one to three changes; returns the given pair if no attempt is valid."""
    texts = (P, Q)
    for _ in range(dice.choice((1, 1, 2, 3))):
        if dice.random() < 0.15:
            scale = next_to_event(dice, *texts, scale)
        else:
            texts = _changed(dice, texts, scale)
    return (*texts, scale)


def _changed(dice: random.Random, texts: tuple[str, str], scale: str) -> tuple[str, str]:
    for _ in range(PATIENCE):
        shapes = [read_shape(text) for text in texts]
        which = dice.randrange(2)
        # Coordinates that fit sP fit P only after division by s.
        size = Fraction(scale) if which == 0 else 1 / Fraction(scale)
        shapes[which] = dice.choice(CHANGES)(dice, shapes[which], shapes[1 - which], size)
        made = (shape_text(shapes[0]), shape_text(shapes[1]))
        if made != texts and _is_small(shapes) and _is_pair(made):
            return made
    return texts


def _is_small(shapes: list[Shape]) -> bool:
    points = [p for shape in shapes for polygon in shape for ring in polygon for p in ring]
    return len(points) <= MOST_VERTICES and all(
        len(str(number)) <= LONGEST for p in points for number in p
    )


def _is_pair(texts: tuple[str, str]) -> bool:
    """Whether both are valid, and at least one is a region or empty."""
    if not all(is_valid(text) for text in texts):
        return False
    sets = [_core.PolygonSet.from_json(text) for text in texts]
    return any(each.is_region or each.is_empty for each in sets)


def next_to_event(dice: random.Random, P: str, Q: str, scale: str) -> str:
    """A scale at, just below or just above a boundary event of the pair."""
    vertices = [_core.PolygonSet.from_json(text).vertices for text in (P, Q)]
    if vertices[0] * vertices[1] > MOST_PAIRS:
        return scale
    near = [probe for position, probe in scale_probes(P, Q, 64) if position != "far"]
    return dice.choice(near) if near else scale
