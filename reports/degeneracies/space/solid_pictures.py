"""Pictures of a case's operands, polyhedra of any shape: front faces cover the faces behind."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.reports.conformance.solid_drawing import projected, solid_layers
from minkref.reports.degeneracies.pictures import Drawn
from minkref.reports.drawing import Layer, picture

WIDTH = 300


def solid_pictures(P: Polyhedron, Q: Polyhedron) -> list[Drawn]:
    """Pictures of P and Q; none for a point."""
    drawn = []
    for name, solid, style in (("P", P, "first"), ("Q", Q, "second")):
        layers = _layers(_framed(solid), style)
        if layers:
            drawn.append(Drawn(name, picture(layers, name, WIDTH)))
    return drawn


def _layers(solid: Polyhedron, style: str) -> list[Layer] | None:
    if not solid.is_thin:
        return solid_layers(solid, style)
    if len(solid.vertices) == 1:
        return None
    a, b = (projected((float(x), float(y), float(z))) for x, y, z in solid.vertices)
    return [Layer("tied-edge", segments=[(*a, *b)])]


def _framed(solid: Polyhedron) -> Polyhedron:
    """Moves the solid to a box of size one at the origin, for numbers of any size."""
    low, high = solid.box
    side = max(b - a for a, b in zip(low, high, strict=True)) or Fraction(1)
    return solid.translated((-low[0], -low[1], -low[2])).scaled(1 / side)
