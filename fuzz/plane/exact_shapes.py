"""Sets of the reference as plain fractions, and back."""

from __future__ import annotations

from typing import cast

from minkref import _core
from minkref.fuzz.geometry.plane import Shape


def shape_of(polygons: _core.PolygonSet) -> Shape:
    """The rings as they are stored."""
    return cast(Shape, polygons.rings())


def set_of(shape: Shape) -> _core.PolygonSet:
    """The set of these rings; nothing is validated and no ring is turned."""
    return _core.PolygonSet(shape, validate=False)
