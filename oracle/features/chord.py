"""Nearest points along a part of the medial axis, and depths below the line through them."""

from __future__ import annotations

from .graph import Part
from .levels import Levels
from .number import Number, number, root
from .outline import Corner, Edge, Point, cross, dot
from .place import Exact, Place

Chord = tuple[Exact, Exact]


def chord_at(levels: Levels, part: Part, level: int) -> Chord:
    """The nearest points where a part reaches a level, or passes it."""
    return chord(levels, part, None if level == levels.infinity else levels.squares[level])


def chord(levels: Levels, part: Part, square: Number | None) -> Chord:
    """The nearest points where a part has a squared radius (None: at infinity)."""
    a, b = (levels.graph.outline.sites[k] for k in part.pair)
    if isinstance(a, Corner):
        assert isinstance(b, Corner)
        return _exact(a.at), _exact(b.at)
    assert square is not None
    if isinstance(b, Corner):
        return _from_edge(a, b, square, part.rises), _exact(b.at)
    return _between_edges(a, b, square)


def chord_of(levels: Levels, pair: tuple[int, int], place: Place) -> Chord:
    """The points of two sites nearest to a place."""
    return _foot(levels, pair[0], place), _foot(levels, pair[1], place)


def _foot(levels: Levels, site: int, place: Place) -> Exact:
    own = levels.graph.outline.sites[site]
    if isinstance(own, Corner):
        return _exact(own.at)
    nx, ny = own.normal
    part = (place.x * nx + place.y * ny - own.height) / own.square
    return place.x - part * nx, place.y - part * ny


def _exact(p: Point) -> Exact:
    return number(p[0]), number(p[1])


def _from_edge(edge: Edge, corner: Corner, square: Number, side: int) -> Exact:
    """The foot on an edge: h and r being the heights of corner and place, the place is sqrt(2 h r -
    h^2) beside the corner."""
    over = edge.over(corner.at)
    height = root(square) * root(1 / edge.square)
    beside = root(height * (2 * over / edge.square) - (over / edge.square) ** 2) * side
    part = over / edge.square
    return (beside * edge.along[0] + (corner.at[0] - part * edge.normal[0]),
            beside * edge.along[1] + (corner.at[1] - part * edge.normal[1]))  # fmt: skip


def _between_edges(a: Edge, b: Edge, square: Number) -> Chord:
    """Feet move along both edges from the lines' crossing, as far as the radius grows."""
    turn, along = cross(a.normal, b.normal), dot(a.normal, b.normal)
    x = (a.height * b.normal[1] - b.height * a.normal[1]) / turn
    y = (a.normal[0] * b.height - b.normal[0] * a.height) / turn
    far = (root(a.square * b.square) - along) / turn * root(square)
    s, t = far * root(1 / a.square), far * root(1 / b.square) * -1
    (ax, ay), (bx, by) = a.along, b.along
    return (s * ax + x, s * ay + y), (t * bx + x, t * by + y)


def depth(at: Point, chord: Chord) -> Number:
    """The squared distance of a point from the line through a chord."""
    (px, py), (qx, qy) = chord
    dx, dy = qx - px, qy - py
    twice: Number = dx * (at[1] - py) - dy * (at[0] - px)
    return (twice * twice) / (dx * dx + dy * dy)
