"""Sets of the reference as plain fractions, and back."""

from __future__ import annotations

from typing import cast

from minkref import _core
from minkref.fuzz.geometry.plane import Shape


def shape_of(polygons: _core.PolygonSet) -> Shape:
    """Returns the rings as stored."""
    return cast(Shape, polygons.rings())


def set_of(shape: Shape) -> _core.PolygonSet:
    """Makes the set of these rings; validates nothing and turns no ring."""
    return _core.PolygonSet(shape, validate=False)
