"""Flat parts with round bores and rounded corners, gears of any number of teeth, a block with a
round cavity: parts as they are drawn, many faces in parallel planes. Coordinates are integers."""

from __future__ import annotations

from fractions import Fraction
from math import cos, pi, sin

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.plane.families.integer_rings import Ring
from minkref.fuzz.space.generators.machined import plate, prism_over
from minkref.fuzz.space.generators.round import geodesic_sphere


def bore(x: int, y: int, radius: int, corners: int) -> Ring:
    """A round hole; runs clockwise, as holes do."""
    # The floats only choose points of the grid.
    turns = [-2 * pi * (k + 0.5) / corners for k in range(corners)]
    return [(x + round(radius * cos(t)), y + round(radius * sin(t))) for t in turns]


def bored_plate(bores: int, corners: int, size: int) -> Polyhedron:
    """A plate with so many bores in a row, each of so many corners."""
    holes = [bore((2 * k + 1) * size, size, size // 2, corners) for k in range(bores)]
    outer = [(0, 0), (2 * bores * size, 0), (2 * bores * size, 2 * size), (0, 2 * size)]
    return prism_over(outer, holes, 0, size // 2)


def rounded_bracket(corners: int, arc: int, size: int) -> Polyhedron:
    """An L profile with arms `size` wide and three times as long, with a bore of `corners` corners
    in each arm and in the corner, or none for 0; its convex corners are arcs with `arc` edges, or
    sharp for 0."""
    long, r = 3 * size, size // 3
    outline: Ring = []
    for x, y, turn in ((0, 0, 2), (long, 0, 3), (long, size, 0)):
        outline += _corner(x, y, turn, r, arc)
    outline.append((size, size))
    for x, y, turn in ((size, long, 0), (0, long, 1)):
        outline += _corner(x, y, turn, r, arc)
    half = size // 2
    centres = ((half, half), (5 * half, half), (half, 5 * half))
    holes = [bore(x, y, size // 4, corners) for x, y in centres if corners]
    return prism_over(outline, holes, 0, size // 2)


def _corner(x: int, y: int, turn: int, r: int, arc: int) -> Ring:
    """A right angle whose arc starts so many quarter turns from the x axis."""
    if arc == 0:
        return [(x, y)]
    cx, cy = x + (r if turn in (1, 2) else -r), y + (r if turn in (2, 3) else -r)
    angles = [pi / 2 * (turn + k / arc) for k in range(arc + 1)]
    return [(cx + round(r * cos(a)), cy + round(r * sin(a))) for a in angles]


def spur_gear(teeth: int, radius: int, high: int, corners: int = 0) -> Polyhedron:
    """Four corners for each tooth, as deep as half a tooth's pitch, and a bore with so many
    corners; 4 `teeth` + 2 faces without a bore."""
    depth = pi / (2 * teeth)
    outline: Ring = []
    for k in range(4 * teeth):
        angle = 2 * pi * (k + 0.5) / (4 * teeth)
        far = radius if k % 4 < 2 else radius * (1 - depth)
        outline.append((round(far * cos(angle)), round(far * sin(angle))))
    holes = [bore(0, 0, radius // 3, corners)] if corners else []
    return prism_over(outline, holes, 0, high)


def hollow_block(splits: int, radius: int) -> Polyhedron:
    """A cube about the origin, minus a geodesic sphere of this radius, three fifths of its half
    side."""
    side = 10 * radius // 3
    back = Fraction(-(side // 2))
    block = plate(side, side, side).translated((back, back, back))
    return block.with_faces_of(geodesic_sphere(splits, radius).turned_inside_out())
