"""Solves the conditions of a place as far from a point and from two other features of a polygon.

The point is the origin, x the place and r its distance. Another point q gives q . x = q . q / 2,
and the line of an edge from p along e, of length k, with the polygon to its left, gives
n . x = n . p + r k with n = (e.y, -e.x). So both are of the form a . x = b + c r.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

r = sp.Symbol("r")


def solutions() -> dict[str, dict[str, Any]]:
    """From a . x = b + c r, d . x = e + f r and x . x = r^2: the quadratic equation of r and the
    place; where a and d are parallel, r from both. Exact."""
    a, d, x = (sp.Matrix(sp.symbols(f"{name}0 {name}1")) for name in "adx")
    b, c, e, f = sp.symbols("b c e f")
    place = sp.solve([a.dot(x) - b - c * r, d.dot(x) - e - f * r], list(x), dict=True)[0]
    turn = a[0] * d[1] - a[1] * d[0]
    scaled = [sp.cancel(place[unknown] * turn) for unknown in x]
    quadratic = sp.Poly(sp.expand(scaled[0] ** 2 + scaled[1] ** 2 - (r * turn) ** 2), r)
    # d = (a . d / a . a) a
    level = sp.Poly(sp.expand(a.dot(a) * (e + f * r) - a.dot(d) * (b + c * r)), r)
    return {
        "diagram crossing": {
            "turn": str(sp.expand(turn)),
            "place": [str(sp.expand(coordinate)) for coordinate in scaled],
            "coefficients": [str(sp.expand(quadratic.nth(k))) for k in (2, 1, 0)],
        },
        "diagram parallel": {
            "numerator": str(sp.expand(-level.nth(0))),
            "denominator": str(sp.expand(level.nth(1))),
        },
    }
