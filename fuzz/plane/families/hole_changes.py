"""Changes of whole rings: holes that the other operand fits or nearly fits, parts copied from one
operand into the other. As in vertex_changes.py: shape, other operand, factor between their
sizes."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.plane import Polygon, Ring, Shape, extent, moved
from minkref.fuzz.plane.families.vertex_changes import Change

TINY = Fraction(1, 2**20)
FITS = (Fraction(1), Fraction(1), 1 + TINY, 1 - TINY, Fraction(3, 2), Fraction(1, 2))


def holed(dice: random.Random, shape: Shape) -> Polygon | None:
    """Draws a polygon with holes."""
    polygons = [polygon for polygon in shape if len(polygon) > 1]
    return dice.choice(polygons) if polygons else None


def regions(shape: Shape) -> Shape:
    return [polygon for polygon in shape if len(polygon[0]) > 2]


def add_hole(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """A hole shaped like a polygon of the other operand, turned by half, that fits the polygon or
    nearly does; at a random place."""
    if not regions(shape) or not regions(other):
        return shape
    polygon, source = dice.choice(regions(shape)), dice.choice(regions(other))[0]
    factor = dice.choice(FITS) / size
    hole: Ring = [(-x * factor, -y * factor) for x, y in source]
    x, y, width, height = extent(polygon[0])
    u, v, w, h = extent(hole)
    s, t = Fraction(dice.randint(1, 7), 8), Fraction(dice.randint(1, 7), 8)
    dx, dy = x + (width - w) * s - u, y + (height - h) * t - v
    polygon.append([(a + dx, b + dy) for a, b in hole])
    return shape


def remove_hole(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    polygon = holed(dice, shape)
    if polygon:
        del polygon[dice.randrange(1, len(polygon))]
    return shape


def fit_hole(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """Stretches a hole to the width and height of the other operand, or nearly."""
    polygon = holed(dice, shape)
    if not polygon or not regions(other):
        return shape
    k = dice.randrange(1, len(polygon))
    x, y, width, height = extent(polygon[k])
    _, _, w, h = extent(dice.choice(regions(other))[0])
    fx, fy = (dice.choice(FITS) * Fraction(each) / size for each in (w, h))
    polygon[k] = [(x + (a - x) * fx / width, y + (b - y) * fy / height) for a, b in polygon[k]]
    return shape


def move_hole(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """Moves a hole until one vertex meets another ring's vertex."""
    polygon = holed(dice, shape)
    if polygon:
        k = dice.randrange(1, len(polygon))
        p = dice.choice(polygon[k])
        q = dice.choice(dice.choice([ring for j, ring in enumerate(polygon) if j != k]))
        polygon[k] = [(x + q[0] - p[0], y + q[1] - p[1]) for x, y in polygon[k]]
    return shape


def copy_part(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    """Copies a polygon from the other operand, as a replacement or an addition."""
    if not other:
        return shape
    part: Shape = [[list(ring) for ring in dice.choice(other)]]
    if shape and dice.random() < 0.5:
        return [*shape[1:], *part]
    if not shape or len(part[0][0]) < 3:
        return part
    right = max(p[0] for polygon in shape for p in polygon[0])
    x, _, _, _ = extent(part[0][0])
    return [*shape, *moved(part, right - x + dice.randint(0, 3), 0)]


def remove_polygon(dice: random.Random, shape: Shape, other: Shape, size: Fraction) -> Shape:
    if len(shape) > 1:
        del shape[dice.randrange(len(shape))]
    return shape


HOLE_CHANGES: tuple[Change, ...] = (
    add_hole,
    add_hole,
    remove_hole,
    fit_hole,
    fit_hole,
    move_hole,
    copy_part,
    remove_polygon,
)
