"""Checks the witness of an offset with joins and caps in plain fractions. No code from the finder.

A missing point lies in the union of the set, the sides' rectangles, and the joins and caps, also at
a radius smaller by the tolerance, and so does the square around it: between all heights at which
something begins, ends or crosses, also a side of the square, one line through it is covered. A
point too much is farther than the tolerance from all of these.

A sharp join is a whole kite, and only sets whose moved sides stay simple come here: this is checked
first. To erode, the pieces lie inside, and are taken away together with all that is outside.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import isqrt
from typing import Any

from minkref.fuzz.verdicts.verdict import Witness

Pair = tuple[Fraction, Fraction]
Ring = list[Pair]
NOWHERE = (Fraction(0), Fraction(0))
ONE = 1 << 70
ARC = 96  # parts of a quarter of a circle
HALVINGS = 7  # of a sector
SURE = Fraction(1, 1 << 36)  # of the radius: more than roots lose
NEAR_LIMIT = Fraction(1, 2000)  # of a mitre's limit


@dataclass(frozen=True)
class Body:
    """Rings, even-odd; with a radius, the disc about the only point."""

    rings: list[Ring]
    radius: Fraction = Fraction(0)

    def is_clear(self, x: Pair, more: Fraction) -> bool:
        """Whether a point is farther than `more`, clearly."""
        if self.radius:
            (a, b), far = self.rings[0][0], self.radius + more
            return (x[0] - a) ** 2 + (x[1] - b) ** 2 > far * far
        return not _winds(x, self) and all(_distance(x, ring) > more * more for ring in self.rings)


def holds(literal: str, witness: Witness) -> bool:
    """Whether the witness proves what it says about the case, whose text this is."""
    value = json.loads(literal)
    radius, half = Fraction(str(value["radius"])), Fraction(witness.tolerance)
    x = (Fraction(witness.point[0]), Fraction(witness.point[1]))
    if value.get("join") == "sharp" and not moves_simply(rings_of(value, radius < 0), abs(radius)):
        return False
    covered, radius = witness.in_truth != (radius < 0), abs(radius)
    if covered:
        smaller = _bodies(value, radius - half, True)
        early = not all(body.is_clear(x, radius * SURE) for body in smaller)
        if half:
            bodies = list(_bodies(value, radius, True))
            return early and half > radius * SURE and _covered(x, half, bodies)
        return early
    apart = half + radius * SURE
    return all(body.is_clear(x, apart) for body in _bodies(value, radius + half, False))


def _bodies(value: dict[str, Any], r: Fraction, due: bool) -> Iterator[Body]:
    given, join, cap = value["offset"], value.get("join", "round"), value.get("cap", "round")
    inward = Fraction(str(value["radius"])) < 0
    limit = Fraction(str(value.get("limit", 1)))
    for line in given.get("lines", ()):
        points = [(Fraction(x), Fraction(y)) for x, y in line]
        for way in (points, points[::-1]):
            yield from _right_of(way, r, join, limit, due)
            yield from _end(way, r, cap, due)
        if len(points) == 1 and cap == "round":
            yield _circle(points[0], r) if due else Body([points], r)
    rings = rings_of(value, inward)
    if rings:
        yield Body([*rings, _frame(rings)] if inward else rings)
    for ring in rings:
        yield from _right_of([*ring, ring[0], ring[1]], r, join, limit, due)


def rings_of(value: dict[str, Any], inward: bool) -> list[Ring]:
    """The rings of the set, or of its outside: what grows lies on their left."""
    found = []
    for polygon in value["offset"].get("polygons", ()):
        for k, points in enumerate((polygon["outer"], *polygon.get("holes", []))):
            ring = [(Fraction(x), Fraction(y)) for x, y in points]
            area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(ring[-1:] + ring, ring))  # noqa: B905
            found.append(ring if ((area > 0) == (k == 0)) != inward else ring[::-1])
    return found


def _frame(rings: list[Ring]) -> Ring:
    """A square far around all rings."""
    far = 4 * max(abs(x) for ring in rings for p in ring for x in p) + 4
    return [(-far, -far), (far, -far), (far, far), (-far, far)]


def moves_simply(rings: list[Ring], time: Fraction) -> bool:
    """Whether rings whose sides move to the right at unit speed keep all sides, and no two sides
    meet until the time: no vertex comes to the line of a side within it."""
    if len({p for ring in rings for p in ring}) < sum(map(len, rings)):
        return False
    sides = [
        (a, b, _moving(z, a, b), _moving(a, b, c))
        for ring in rings
        for z, a, b, c in zip(ring[-1:] + ring, ring, ring[1:] + ring[:1], ring[2:] + ring[:2])  # noqa: B905
    ]
    for a, b, u, w in sides:
        (ax, ay), (bx, by) = a, b
        gone = (bx - ax) * (w[0] - u[0]) + (by - ay) * (w[1] - u[1])
        if (bx - ax) ** 2 + (by - ay) ** 2 + gone * time <= 0:
            return False
        for p, _, v, _ in sides:
            if p not in (a, b) and _comes(p, v, (a, b, u, w), time):
                return False
    return True


def _moving(z: Pair, a: Pair, b: Pair) -> Pair:
    """The velocity of the vertex a, between z and b."""
    d, e = _unit(z, a), _unit(a, b)
    n, m = (d[1], -d[0]), (e[1], -e[0])
    share = 1 + n[0] * m[0] + n[1] * m[1]
    return ((n[0] + m[0]) / share, (n[1] + m[1]) / share)


def _comes(p: Pair, v: Pair, side: tuple[Pair, Pair, Pair, Pair], time: Fraction) -> bool:
    """Whether a moving point lies on a moving side at some time: the area of the triangle with the
    side's ends vanishes there."""
    a, b, u, w = side
    d = _unit(a, b)
    height = d[1] * (p[0] - a[0]) - d[0] * (p[1] - a[1])
    rise = d[1] * (v[0] - u[0]) - d[0] * (v[1] - u[1])
    if rise == 0 or not 0 <= -height / rise <= time:
        return False
    t = -height / rise
    here, start, end = _go(p, v, t), _go(a, u, t), _go(b, w, t)
    along = [(x[0] - here[0]) * d[0] + (x[1] - here[1]) * d[1] for x in (start, end)]
    return along[0] <= 0 <= along[1]


def _right_of(way: Ring, r: Fraction, join: str, limit: Fraction, due: bool) -> Iterator[Body]:
    for k in range(len(way) - 1):
        a, b = way[k], way[k + 1]
        u = _unit(a, b)
        yield Body([[a, b, _go(b, (u[1], -u[0]), r), _go(a, (u[1], -u[0]), r)]])
        if k + 2 < len(way):
            yield from _join(b, u, _unit(b, way[k + 2]), r, join, limit, due)


def _join(v: Pair, u: Pair, w: Pair, r: Fraction, join: str, limit: Fraction, due: bool
          ) -> Iterator[Body]:  # fmt: skip
    if not due and join in ("round", "bevel"):
        yield Body([[v]], r)
        return
    turned = u[0] * w[1] - u[1] * w[0]
    cosine = u[0] * w[0] + u[1] * w[1]
    if turned <= 0:
        if cosine < 0 and not due:
            yield Body([[v]], r * limit)
        return
    p, q = (u[1], -u[0]), (w[1], -w[0])
    start, end = _go(v, p, r), _go(v, q, r)
    share = (1 - cosine) / turned  # of the tangent: of half the turn
    ratio = 1 + share * share  # its root times the radius is how far the tip is
    if join == "round":
        ways = [p, q]
        for _ in range(HALVINGS):
            middles = [_unit(_go(a, b, Fraction(1)), NOWHERE) for a, b in pairwise(ways)]
            middles = [(-x, -y) for x, y in middles]
            ways = [w for pair in zip(ways, middles, strict=False) for w in pair] + [q]
        yield Body([[v, *(_go(v, way, r) for way in ways)]])
    elif join == "bevel" or (due and join == "mitre" and ratio > (limit * (1 - NEAR_LIMIT)) ** 2):
        yield Body([[v, start, end]])
    else:
        tip = _go(start, u, r * share)
        most = limit if join == "mitre" else Fraction(1)
        if join == "mitre":
            most *= 1 - NEAR_LIMIT if due else 1 + NEAR_LIMIT
        if join == "sharp" or ratio <= most * most:
            yield Body([[v, start, tip, end]])
            return
        root = Fraction(isqrt(int(ratio * ONE * ONE)), ONE)
        # Along the side from `start` to the cut: the axis turns half as far as the corner.
        along = max((most * root - 1) / share, Fraction(0)) if share else Fraction(0)
        yield Body([[v, start, _go(start, u, r * along), _go(end, w, -r * along), end]])


def _end(way: Ring, r: Fraction, cap: str, due: bool) -> Iterator[Body]:
    if len(way) < 2 or cap == "flat":
        return
    v, u = way[-1], _unit(way[-2], way[-1])
    n = (u[1], -u[0])
    left, right = _go(v, n, -r), _go(v, n, r)
    if cap == "square":
        yield Body([[left, right, _go(right, u, r), _go(left, u, r)]])
    else:
        yield _circle(v, r) if due else Body([[v]], r)


def _circle(v: Pair, r: Fraction) -> Body:
    """A polygon inside the circle: rational points of the unit circle, times the radius."""
    found = []
    for k in range(-ARC, ARC):
        t = Fraction(k, ARC)
        x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        found += [(x, y)]
    return Body([[_go(v, way, r) for way in found + [(-x, -y) for x, y in found]]])


def _unit(a: Pair, b: Pair) -> Pair:
    x, y = b[0] - a[0], b[1] - a[1]
    square = x * x + y * y
    n, d = square.numerator, square.denominator
    scale = ONE * (1 << max(0, d.bit_length() - n.bit_length()))
    length = Fraction(isqrt(n * d * scale * scale), d * scale)
    return (x / length, y / length)


def _go(a: Pair, way: Pair, far: Fraction) -> Pair:
    return (a[0] + far * way[0], a[1] + far * way[1])


def _sides(body: Body) -> Iterator[tuple[Pair, Pair]]:
    for ring in body.rings:
        yield from zip(ring[-1:] + ring[:-1], ring, strict=True)


def _covered(x: Pair, half: Fraction, bodies: list[Body]) -> bool:
    left, right, low, high = x[0] - half, x[0] + half, x[1] - half, x[1] + half
    sides = [
        (a, b) for body in bodies for a, b in _sides(body)
        if min(a[0], b[0]) <= right and max(a[0], b[0]) >= left
        and min(a[1], b[1]) <= high and max(a[1], b[1]) >= low
    ]  # fmt: skip
    heights = {low, high, *(p[1] for side in sides for p in side if low < p[1] < high)}
    sides += [((x, low), (x, high)) for x in (left, right)]
    heights |= {y for k, one in enumerate(sides) for other in sides[:k]
                if (y := _crossing(one, other)) is not None and low < y < high}  # fmt: skip
    ordered = sorted(heights)
    return all(_line_covered((a + b) / 2, left, right, bodies) for a, b in pairwise(ordered))


def _crossing(one: tuple[Pair, Pair], other: tuple[Pair, Pair]) -> Fraction | None:
    """The height at which two lines cross."""
    (a, b), (c, d) = one, other
    ux, uy, wx, wy = b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]
    turned = ux * wy - uy * wx
    if turned == 0:
        return None
    return a[1] + uy * ((c[0] - a[0]) * wy - (c[1] - a[1]) * wx) / turned


def _line_covered(y: Fraction, left: Fraction, right: Fraction, bodies: list[Body]) -> bool:
    spans = []
    for body in bodies:
        cuts = sorted(
            a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])
            for a, b in _sides(body) if (a[1] > y) != (b[1] > y)
        )  # fmt: skip
        spans += list(zip(cuts[::2], cuts[1::2], strict=True))
    reach = left
    for start, end in sorted(spans):
        if start > reach:
            break
        reach = max(reach, end)
    return reach >= right


def _winds(x: Pair, body: Body) -> bool:
    cuts = [
        a[0] + (b[0] - a[0]) * (x[1] - a[1]) / (b[1] - a[1]) > x[0]
        for a, b in _sides(body) if (a[1] > x[1]) != (b[1] > x[1])
    ]  # fmt: skip
    return sum(cuts) % 2 == 1


def _distance(x: Pair, ring: Ring) -> Fraction:
    """Squared, from the ring's sides."""
    found = []
    for a, b in _sides(Body([ring])):
        ux, uy, wx, wy = b[0] - a[0], b[1] - a[1], x[0] - a[0], x[1] - a[1]
        length = ux * ux + uy * uy
        t = min(max((ux * wx + uy * wy) / length, Fraction(0)), Fraction(1)) if length else 0
        found.append((wx - t * ux) ** 2 + (wy - t * uy) ** 2)
    return min(found)
