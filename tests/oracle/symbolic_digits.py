"""A swept disc's offset edges and arcs with 60 digits: a second way to find their common points."""

from __future__ import annotations

from typing import Any

from minkref.oracle.symbolic.disc.disc import Arc, Offset, cross
from minkref.oracle.symbolic.disc.radicals import Radical
from mpmath import mp, mpf

mp.dps = 60
ROUNDING = mpf(10) ** -50


def decimal(x: Radical) -> Any:
    return sum(
        (mpf(int(c.numerator)) / int(c.denominator) * mp.sqrt(m) for m, c in x.terms), mpf(0)
    )


def place(x: Any, feature: Any, s: Any) -> tuple[Any, Any]:
    """A point of an edge, offset by s, with 60 digits."""
    e = [mpf(int(k)) for k in feature.edge]
    length = mp.hypot(*e)
    return mpf(int(x[0])) + s * e[1] / length, mpf(int(x[1])) - s * e[0] / length


def crossings(a: Any, b: Any, s: Any) -> int:
    """The number of points shared by two features at a scale without an event, with 60 digits."""
    if isinstance(a, Arc) and isinstance(b, Offset):
        a, b = b, a
    centres = [[mpf(int(k)) for k in x.centre] for x in (a, b) if isinstance(x, Arc)]
    if isinstance(a, Offset):
        p, q = place(a.p, a, s), place(a.q, a, s)
        d = (q[0] - p[0], q[1] - p[1])
    if isinstance(b, Offset):
        u, v = place(b.p, b, s), place(b.q, b, s)
        e = (v[0] - u[0], v[1] - u[1])
        below = cross(d, e)
        if below == 0:
            return 0
        off = (u[0] - p[0], u[1] - p[1])
        return int(0 < cross(off, e) / below < 1 and 0 < cross(off, d) / below < 1)
    if len(centres) == 1:
        c = centres[0]
        off = (p[0] - c[0], p[1] - c[1])
        half = d[0] * off[0] + d[1] * off[1]
        square, rest = d[0] ** 2 + d[1] ** 2, off[0] ** 2 + off[1] ** 2 - s**2
        root = half**2 - square * rest
        if root < 0:
            return 0
        times = [(-half + sign * mp.sqrt(root)) / square for sign in (1, -1)]
        return sum(0 < t < 1 and within(b, off[0] + t * d[0], off[1] + t * d[1]) for t in times)
    (c, f) = centres
    w = (f[0] - c[0], f[1] - c[1])
    square = w[0] ** 2 + w[1] ** 2
    if square > 4 * s**2:
        return 0
    height = mp.sqrt((s**2 - square / 4) / square)
    found = [(w[0] / 2 - k * w[1], w[1] / 2 + k * w[0]) for k in (height, -height)]
    return sum(within(a, *x) and within(b, x[0] - w[0], x[1] - w[1]) for x in found)


def within(arc: Arc, x: Any, y: Any) -> bool:
    (a, b), (c, d) = ([mpf(int(k)) for k in e.edge] for e in (arc.before, arc.after))
    return bool(b * y + a * x > 0 and -x * c - y * d > 0)


def reached(feature: Any, x: Any, y: Any, s: Any) -> bool:
    """Whether a point of its line or circle belongs to the feature itself."""
    if isinstance(feature, Arc):
        off = mp.atan2(y - int(feature.centre[1]), x - int(feature.centre[0]))
        first, last = (
            mp.atan2(-int(e.edge[0]), int(e.edge[1])) for e in (feature.before, feature.after)
        )
        turn, reach = ((angle - first + ROUNDING) % (2 * mp.pi) for angle in (last, off))
        return bool(reach <= turn + ROUNDING)
    p = place(feature.p, feature, s)
    e = [mpf(int(k)) for k in feature.edge]
    t = ((x - p[0]) * e[0] + (y - p[1]) * e[1]) / (e[0] ** 2 + e[1] ** 2)
    return bool(-ROUNDING <= t <= 1 + ROUNDING)
