"""A solid moved to contain the origin."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import area_vector, middle
from minkref.fuzz.space.membership import winding_number


def around_origin(solid: Polyhedron) -> Polyhedron:
    """Moves the solid by integers until it contains the origin. The place lies straight below the
    middle of the first face with such a place."""
    for face in solid.faces:
        ring = [solid.vertices[k] for k in face]
        n = area_vector([solid.wholes[k] for k in face])
        largest = max(map(abs, n))
        foot = middle(ring)
        low, high = solid.box
        depth = max(b - a for a, b in zip(low, high, strict=True))
        while depth >= 1:
            depth /= 2
            x, y, z = (
                Fraction(round(a - depth * b / largest)) for a, b in zip(foot, n, strict=True)
            )
            if winding_number(solid, (x, y, z)) == 1:
                return solid.translated((-x, -y, -z))
    raise ValueError("no integer point is found inside of the solid")
