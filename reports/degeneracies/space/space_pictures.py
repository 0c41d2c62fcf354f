"""Pictures of a degenerate case in space: both bodies, and the sum below, at and above the scaling,
in a parallel projection without the faces that look away. Exact numbers decide which faces look
away; coordinates move to a frame of size one before they become doubles."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point, Whole, area_vector, dot
from minkref.fuzz.space.convex_sum import body_of, polyhedron_of
from minkref.reports.conformance.solid_drawing import projected, shade
from minkref.reports.degeneracies.pictures import Drawn
from minkref.reports.drawing import Layer, Segment, bounds, picture
from minkref.space.scaling import read_scaling, text_of

Corners = Sequence[int]
Bodies = tuple[_core.ConvexPolyhedron, _core.ConvexPolyhedron]
Frame = tuple[Point, Fraction]  # the least corner, the longest side


@dataclass(frozen=True)
class Shown:
    """A body; `tied`: the numbers of faces that meet the other body's faces; `edges`: tied
    edges."""

    solid: Polyhedron
    tied: set[int] = field(default_factory=set)
    edges: list[tuple[int, int]] = field(default_factory=list)


def space_case_pictures(P: Polyhedron, Q: Polyhedron, value: dict[str, Any]) -> list[Drawn]:
    """Pictures of a case-v1 in space: P and Q separately, the sums in one frame."""
    rows = value["degeneracy"]["coincidences"]
    drawn = []
    for name, solid in (("P", P), ("Q", Q)):
        shown = _operand(solid, [row[name] for row in rows])
        style = "first" if name == "P" else "second"
        drawn.append(Drawn(name, picture(_layers(shown, style, _frame([solid])), name, 220)))
    bodies = body_of(P), body_of(Q)
    beside, others = _siblings(value["scales"])
    for frame in (beside, others):
        drawn += _sums(bodies, frame) if frame else []
    return drawn


def _sums(bodies: Bodies, wanted: list[tuple[str, str]]) -> list[Drawn]:
    """Sums at some scalings in one frame, each with a caption."""
    sums = [_sum(_core.convex_sum(*bodies, read_scaling(scale))) for scale, _ in wanted]
    frame = _frame(shown.solid for shown in sums)
    layers = [_layers(shown, "sum", frame) for shown in sums]
    box = bounds(layer for each in layers for layer in each)
    return [
        Drawn(caption, picture(each, caption, 300, box))
        for (_, caption), each in zip(wanted, layers, strict=True)
    ]


def _siblings(scales: list[str]) -> tuple[list[tuple[str, str]], list[tuple[str, str]]]:
    """The first scalings below and above along one axis, with the scaling between; and the last
    scaling elsewhere. All have captions."""
    at = _factors(scales[0])
    middle = text_of(read_scaling(scales[0]))
    below: list[tuple[str, str]] = []
    above: list[tuple[str, str]] = []
    others: list[tuple[str, str]] = []
    for scale in scales[1:]:
        steps = [a - b for a, b in zip(_factors(scale), at, strict=True)]
        step = sum(steps, Fraction(0))
        if sum(map(bool, steps)) != 1 or abs(step) >= 1:
            others.append((scale, f"the sum at {text_of(read_scaling(scale))}"))
        elif step < 0:
            below.append((scale, f"the sum just below {middle}"))
        else:
            above.append((scale, f"the sum just above {middle}"))
    return [*below[:1], (scales[0], f"the sum at {middle}"), *above[:1]], others[-1:]


def _factors(scale: str) -> list[Fraction]:
    return [Fraction(factor) for factor in read_scaling(scale)]


def _operand(solid: Polyhedron, marked: list[Corners]) -> Shown:
    """The solid with tied facets and edges, found from the corners of some coincidences."""
    tied = {
        number
        for corners in marked
        if len(corners) > 2
        for number, face in enumerate(solid.faces)
        if _in_plane(solid, corners, face)
    }
    edges = [(corners[0], corners[1]) for corners in marked if len(corners) == 2]
    return Shown(solid, tied, edges)


def _in_plane(solid: Polyhedron, corners: Corners, face: Face) -> bool:
    points = solid.wholes
    n = area_vector([points[k] for k in corners[:3]])
    return all(dot(n, points[k]) == dot(n, points[corners[0]]) for k in face)


def _sum(found: _core.ConvexSum) -> Shown:
    """The sum, with tied facets: sums of two facets, or of a facet and an edge."""
    tied = {
        number for number, (p, q) in enumerate(found.facet_parents) if max(len(p), len(q)) > 2
        and min(len(p), len(q)) > 1
    }  # fmt: skip
    return Shown(polyhedron_of(found.surface), tied)


def _layers(shown: Shown, style: str, frame: Frame) -> list[Layer]:
    """The faces towards the eye, each a layer with one of three shades."""
    solid = shown.solid
    places = [_place(vertex, frame) for vertex in solid.vertices]
    layers = []
    seen: set[tuple[int, int]] = set()
    for number, face in enumerate(solid.faces):
        n = area_vector([solid.wholes[k] for k in face])
        if sum(n) > 0:
            heights = [dot(n, point) for point in solid.wholes]
            seen |= {(a, b) for a, b in shown.edges if heights[a] == heights[b] == max(heights)}
            kind = "tied" if number in shown.tied else style
            layers.append(Layer(f"{kind} shade{shade(_unit(n))}", [[[places[k] for k in face]]]))
    lines: list[Segment] = [(*places[a], *places[b]) for a, b in sorted(seen)]
    return [*layers, Layer("tied-edge", segments=lines)]


def _unit(vector: Whole) -> tuple[float, float, float]:
    """Along a vector that may be too long for doubles."""
    most = max(map(abs, vector))
    x, y, z = (float(Fraction(c, most)) for c in vector)
    return x, y, z


def _frame(solids: Iterable[Polyhedron]) -> Frame:
    columns = list(zip(*(vertex for solid in solids for vertex in solid.vertices), strict=True))
    x, y, z = (min(column) for column in columns)
    return (x, y, z), max(max(column) - min(column) for column in columns)


def _place(point: Point, frame: Frame) -> tuple[float, float]:
    low, side = frame
    x, y, z = (float((c - least) / side) for c, least in zip(point, low, strict=True))
    return projected((x, y, z))
