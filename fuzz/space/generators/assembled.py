"""Solids assembled from convex bodies: with a cavity, two components, spikes or dents."""

from __future__ import annotations

import random
from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, area_vector, middle, primitive
from minkref.fuzz.space.generators.convex import box, random_hull

GRID = 24  # multiples give spikes and dents integer tips


def hollow_box(dice: random.Random, most: int) -> tuple[Polyhedron, Polyhedron]:
    """A box with a cavity, and what fills the cavity."""
    inner = random_hull(dice, dice.choice((4, 4, 5)), most)
    if dice.random() < 0.4:
        inner = box(*inner.box)
    low, high = inner.box
    x, y, z = (low[k] - dice.randint(1, 2) for k in range(3))
    u, v, w = (high[k] + dice.randint(1, 2) for k in range(3))
    return box((x, y, z), (u, v, w)).with_faces_of(inner.turned_inside_out()), inner


def side_by_side(
    one: Polyhedron, other: Polyhedron, axis: int, gap: Fraction, shift: Point
) -> Polyhedron:
    """Two components; the other follows the first along the axis, at this distance, moved by
    `shift` along the other axes."""
    way = [shift[0], shift[1], shift[2]]
    way[axis] = one.box[1][axis] + gap - other.box[0][axis]
    return one.with_faces_of(other.translated((way[0], way[1], way[2])))


def spiked(dice: random.Random, body: Polyhedron, chance: float) -> Polyhedron:
    """A body with pyramids on some faces, and pyramids cut out of others: a spike stays in the
    prism over its face, a dent in the cone over its face from the middle, so none meet. Integer if
    the body's coordinates are multiples of GRID."""
    vertices, faces = list(body.vertices), []
    centre = middle(body.vertices)
    for face in body.faces:
        ring = [body.vertices[k] for k in face]
        foot = middle(ring)
        if dice.random() < chance:
            n = primitive(area_vector([body.wholes[k] for k in face]))
            t = Fraction(dice.randint(1, 8), max(1, max(map(abs, n)) // 4))
            x, y, z = (a + Fraction(int(t * b)) for a, b in zip(foot, n, strict=True))
            if (x, y, z) == foot or not _over(ring, foot, (x, y, z)):
                x, y, z = (a + b for a, b in zip(foot, n, strict=True))
        elif dice.random() < 0.3:
            x, y, z = (a + (b - a) / 2 for a, b in zip(foot, centre, strict=True))
        else:
            faces.append(face)
            continue
        vertices.append((x, y, z))
        faces += [(face[k - 1], face[k], len(vertices) - 1) for k in range(len(face))]
    return Polyhedron(tuple(vertices), tuple(faces))


def _over(ring: list[Point], foot: Point, tip: Point) -> bool:
    """The way from the foot to the tip runs along the normal of the face."""
    u = [a - b for a, b in zip(tip, foot, strict=True)]
    return all(
        sum(a * (q - p) for a, p, q in zip(u, ring[0], point, strict=True)) == 0 for point in ring
    )


def big_tetrahedron(dice: random.Random, most: int) -> Polyhedron:
    return random_hull(dice, 4, most).scaled(Fraction(GRID))
