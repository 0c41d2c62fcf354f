"""Whether a result's faces close up, however they are cut and numbered."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise

from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, cross, dot, minus, primitive

Line = tuple[Whole, Whole]


def open_edge(polyhedron: Polyhedron) -> Point | None:
    """Returns the middle of a stretch along which faces run more often one way than the other; None
    for a closed surface. Vertices with equal coordinates count as one, and an edge may be cut into
    several on one of its sides. O(n log n) for n edges."""
    found = open_stretch(polyhedron.wholes, polyhedron.faces)
    if found is None:
        return None
    a, b = found
    half = Fraction(1, 2 * polyhedron.denominator)
    return (half * (a[0] + b[0]), half * (a[1] + b[1]), half * (a[2] + b[2]))


def open_stretch(points: Sequence[Whole], faces: Iterable[Face]) -> tuple[Whole, Whole] | None:
    """Returns the ends of such a stretch for some faces, given by vertex numbers."""
    flow: Counter[tuple[Whole, Whole]] = Counter()
    for face in faces:
        for i, j in zip(face, face[1:] + face[:1], strict=True):
            a, b = points[i], points[j]
            if a < b:
                flow[(a, b)] += 1
            elif b < a:
                flow[(b, a)] -= 1
    lines: dict[Line, list[tuple[int, Whole, int]]] = {}
    for (a, b), count in flow.items():
        if count:
            direction = primitive(minus(b, a))
            ends = lines.setdefault((direction, cross(direction, a)), [])
            ends += [(dot(direction, a), a, count), (dot(direction, b), b, -count)]
    for ends in lines.values():
        ends.sort()
        running = 0
        for (here, a, count), (there, b, _) in pairwise(ends):
            running += count
            if running and here != there:
                return a, b
    return None
