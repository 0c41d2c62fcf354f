"""Where the paper's Appendix puts points, by computer algebra: each formula in each reading, set
into the equations of the curves through the point. A formula holds if the residual is 0 for all
data.

Without loss of generality a segment lies along the x-axis with P above it, so the outward normal is
(0, -1); any other pair is turned and moved. The origin, the centre of sQ, is anywhere.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import sympy as sp

r, s = sp.symbols("r s", positive=True)
a, b, g = sp.symbols("a b g", positive=True)
x, y = sp.symbols("x y", real=True)
OUTWARD = sp.Matrix([0, -1])
Point = Any


def moved_end(points: str, normal: str) -> Point:
    """p(s) = p + (s - 1) r (⊥ l) for the end (x, y) of an edge; `from-origin` where the origin lies
    on the outer side of the edge."""
    way = OUTWARD if normal == "outward" else -OUTWARD
    p = sp.Matrix([x, y])
    start = p + r * way if points == "convolution" else p
    return start + (s - 1) * r * way


def distance_from_offset_line(p: Point) -> Any:
    """The signed distance from the edge's line, moved outwards by s r."""
    return sp.simplify(OUTWARD.dot(p - sp.Matrix([x, y])) - s * r)


def crossing_of_circles(radical: str, middle: str, height: str) -> Point:
    """I(s) for centres (x, y) and (x + 2 a, y), so that s0 = a / r."""
    s0 = a / r
    out = (sp.sqrt((s**2 - s0**2) * r) if radical == "printed" else r * sp.sqrt(s**2 - s0**2)) + (
        y if height == "added" else 0
    )
    way = sp.Matrix([0, out])
    return sp.Matrix([x + a, y]) + way if middle == "added" else way


def squares_off_circles(p: Point) -> tuple[Any, ...]:
    """The squared distance from each centre less the squared radius."""
    return tuple(
        sp.simplify(sp.expand((p[0] - x - k) ** 2 + (p[1] - y) ** 2 - (s * r) ** 2))
        for k in (0, 2 * a)
    )


def crossing_with_line(line: str) -> Point:
    """Where a circle about (0, -g), at the distance g before the edge, crosses the edge's line: as
    printed the line stays where it is touched."""
    s0 = g / (2 * r)
    if line == "printed":
        return sp.Matrix([r * sp.sqrt(s**2 - s0**2), -g + s0 * r])
    return sp.Matrix([sp.sqrt(g * (2 * s * r - g)), -s * r])


def off_circle_and_line(p: Point) -> tuple[Any, Any]:
    """The squared distance from (0, -g) less (s r)^2, and the height above the line y = -s r."""
    return sp.simplify(sp.expand(p[0] ** 2 + (p[1] + g) ** 2 - (s * r) ** 2)), sp.simplify(
        p[1] + s * r
    )


def readings_that_hold() -> dict[str, list[tuple[str, ...]]]:
    """For each formula the combinations of readings with which it holds for all data."""
    return {
        "segments": [
            chosen
            for chosen in product(("convolution", "polygon"), ("outward", "from-origin"))
            if distance_from_offset_line(moved_end(*chosen)) == 0
        ],
        "circles": [
            chosen
            for chosen in product(
                ("printed", "corrected"), ("added", "left-out"), ("left-out", "added")
            )
            if all(off == 0 for off in squares_off_circles(crossing_of_circles(*chosen)))
        ],
        "line": [
            (chosen,)
            for chosen in ("printed", "corrected")
            if all(off == 0 for off in off_circle_and_line(crossing_with_line(chosen)))
        ],
    }
