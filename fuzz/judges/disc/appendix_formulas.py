"""Events of two features by the Appendix's formulas as they stand (Behar & Lien 2012), set up and
solved over sums of square roots: each place I(s) is equated to an end, giving two equations in one
unknown, and only common roots count. docs/disc.md, "Pair events", says how ambiguous formulas are
read.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from minkref.oracle.symbolic.disc import disc
from minkref.oracle.symbolic.disc.disc import Arc, Offset, Place
from minkref.oracle.symbolic.disc.disc_contact import Feature, ends, moved_out, on, on_arc
from minkref.oracle.symbolic.disc.radicals import Radical, number, square_root
from minkref.oracle.symbolic.moving import Point
from minkref.oracle.symbolic.rational import Rational

#: whose end, which; ("", 0) is a tangent
Slot = tuple[str, int]
#: the scale, and whether the place is on both features
Told = dict[Slot, tuple[Radical, bool]]
Vector = tuple[Radical, Radical]


def printed_events(a: Feature, b: Feature, r: Rational) -> Told:
    """At scales s > 0, for a disc of radius r at the scale 1. Exact."""
    if isinstance(a, Offset) and isinstance(b, Offset):
        return _of_segments(a, b, r)
    if isinstance(a, Arc) and isinstance(b, Arc):
        return _of_arcs(a, b, r)
    if isinstance(a, Arc) and isinstance(b, Offset):
        return _of_arc_and_segment(a, b, r, "ab")
    if isinstance(a, Offset) and isinstance(b, Arc):
        return _of_arc_and_segment(b, a, r, "ba")
    raise TypeError("a feature is an Offset or an Arc")


def _of_segments(a: Offset, b: Offset, r: Rational) -> Told:
    """Parallel segments have no crossing that could be expressed in s."""
    told: Told = {}
    if disc.cross(a.edge, b.edge) == 0:
        return told
    for name, own, other in (("a", a, b), ("b", b, a)):
        for k, end in enumerate((own.p, own.q)):
            scale = disc.end_on_line(end, own, other, r).value
            if scale is None:
                continue
            place = moved_out(end, own, r, scale)
            parameters = [_parameter(place, edge, r, scale) for edge in (own, other)]
            rejected = (t.sign() > 0 or (t - 1).sign() > 0 for t in parameters)
            if not any(rejected):
                told[name, k] = scale, on(place, a, scale, r) and on(place, b, scale, r)
    return told if len({scale for scale, _ in told.values()}) == 2 else {}


def _of_arcs(a: Arc, b: Arc, r: Rational) -> Told:
    """I(s) = M(s) (+-perp), from the middle of the centres; M(s)^2 = (s^2 - s0^2) r."""
    told: Told = {}
    tangent = disc.circles(a, b, r).value
    if tangent is None:
        return told
    middle = _half_way(a.centre, b.centre)
    if on(middle, a, tangent, r) and on(middle, b, tangent, r):
        told["", 0] = tangent, True
    way = _plain(b.centre, a.centre)
    for name, own, other in (("a", a, b), ("b", b, a)):
        for k, (_, edge) in enumerate(ends(own)):
            m = _normal(edge)
            # (centre + s r m - middle) . way = 0
            slope = _dot(m, way) * r
            if slope.sign() == 0:
                continue
            scale = _dot(_minus(middle, _place(own.centre)), way) / slope
            if scale.sign() <= 0:
                continue
            place = moved_out(own.centre, edge, r, scale)
            off = _minus(place, middle)
            if (_dot(off, off) - (scale * scale - tangent * tangent) * r).sign() == 0:
                if on(place, other, scale, r):
                    told[name, k] = scale, True
    return told


def _of_arc_and_segment(arc: Arc, line: Offset, r: Rational, names: str) -> Told:
    """The line stays at the distance s0 r from the centre, and meets the disc of radius s r."""
    told: Told = {}
    tangent = disc.circle_on_line(arc, line, r).value
    if tangent is None:
        return told
    foot = moved_out(arc.centre, line, -r, tangent)
    if on(foot, arc, tangent, r) and on(foot, line, tangent, r):
        told["", 0] = tangent, True
    n, centre = _normal(line), _place(arc.centre)
    for k, end in enumerate((line.p, line.q)):
        # n . (end + s r n - centre) = -s0 r
        scale = -tangent - _dot(n, _minus(_place(end), centre)) / r
        place = moved_out(end, line, r, scale)
        if scale.sign() > 0 and _crosses(place, foot, scale, tangent, r):
            if on_arc(place, arc, scale, r):
                told[names[1], k] = scale, True
    for k, (_, edge) in enumerate(ends(arc)):
        slope = _dot(n, _normal(edge))  # n . (s r m) = -s0 r
        if slope.sign() == 0 or (scale := -tangent / slope).sign() <= 0:
            continue
        place = moved_out(arc.centre, edge, r, scale)
        t = _parameter(place, line, r, tangent)
        if not _crosses(place, foot, scale, tangent, r):
            raise AssertionError("the end of an arc is on its circle")
        if t.sign() >= 0 and (1 - t).sign() >= 0:
            told[names[0], k] = scale, on(place, line, scale, r)
    return told


def _crosses(place: Place, foot: Place, scale: Radical, tangent: Radical, r: Rational) -> bool:
    """Whether a place is as far from the foot as r sqrt(s^2 - s0^2)."""
    off = _minus(place, foot)
    square = (scale * scale - tangent * tangent) * r * r
    return (_dot(off, off) - square).sign() == 0


def _parameter(place: Place, edge: Offset, r: Rational, scale: Radical) -> Radical:
    """Returns 0 at an offset edge's start, 1 at its end."""
    x, y = edge.edge
    off = _minus(place, moved_out(edge.p, edge, r, scale))
    return (off[0] * x + off[1] * y) / (x * x + y * y)


def _normal(edge: Offset) -> Vector:
    x, y = edge.edge
    length = square_root(x * x + y * y)
    return number(y) / length, number(-x) / length


def _half_way(a: Point, b: Point) -> Place:
    return number((a[0] + b[0]) / 2), number((a[1] + b[1]) / 2)


def _place(p: Point) -> Place:
    return number(p[0]), number(p[1])


def _plain(a: Point, b: Point) -> Vector:
    return _minus(_place(a), _place(b))


def _minus(a: Sequence[Any], b: Sequence[Any]) -> Vector:
    return a[0] - b[0], a[1] - b[1]


def _dot(a: Vector, b: Vector) -> Radical:
    return a[0] * b[0] + a[1] * b[1]
