"""Drawings of counterexamples in space, projected along (1, 1, 1), with rounded coordinates."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.reports.audit.space import Vector
from minkref.reports.conformance.solid_drawing import projected, solid_layers, wire_layer
from minkref.reports.drawing import Layer, Segment, picture

WIDTH = 300
Lines = Iterable[tuple[Vector, Vector]]


def flat(place: Vector) -> tuple[float, float]:
    x, y, z = place
    return projected((float(x), float(y), float(z)))


def lines(style: str, segments: Lines) -> Layer:
    found: list[Segment] = [(*flat(a), *flat(b)) for a, b in segments]
    return Layer(style, segments=found)


def outline(style: str, corners: Sequence[Vector]) -> Layer:
    return lines(style, pairwise([*corners, corners[0]]))


def facets_picture(
    first: Iterable[Sequence[Vector]], second: Iterable[Sequence[Vector]], caption: str
) -> str:
    """Facets by their outlines."""
    layers = [outline("first-edge", corners) for corners in first]
    return picture([*layers, *(outline("second-edge", c) for c in second)], caption, WIDTH)


def plan_picture(
    rings: Iterable[Sequence[tuple[float, float]]], point: tuple[float, float], caption: str
) -> str:
    """Outlines in the plane, and a point."""
    layers = [
        Layer("second-edge", segments=[(*a, *b) for a, b in pairwise([*ring, ring[0]])])
        for ring in rings
    ]
    return picture([*layers, Layer("witness", point=point)], caption, WIDTH)


def solids_picture(
    solids: Sequence[tuple[Polyhedron, str]],
    caption: str,
    point: Vector | None = None,
    marked: Lines = (),
) -> str:
    """Draws solids in the styles `first` or `second`, `wire` solids by edges only, marked edges and
    a point."""
    layers: list[Layer] = []
    for solid, style in solids:
        if style == "wire":
            wire = wire_layer(solid, "wire")
            layers += [wire] if wire else []
        else:
            layers += solid_layers(solid, style) or []
    layers.append(lines("second-edge", marked))
    if point is not None:
        layers.append(Layer("witness", point=flat(point)))
    return picture(layers, caption, WIDTH)
