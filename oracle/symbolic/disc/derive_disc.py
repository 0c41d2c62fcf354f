"""Solves the conditions of offset edges and arcs: a disc of radius s r swept along a polygon.

The polygon stands still. Its edge from p along e, of length k, is offset to the line
n . x = h + s r, with n = (e.y, -e.x) / k, h = n . p, between p + s r n and p + e + s r n. An arc
has a vertex for its centre and the radius s r. Lengths are symbols, k^2 = L; each condition is
linear in s over them, and the lengths are then eliminated.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from ..derive_plane import s

r = sp.Symbol("r", positive=True)
Expressions = Sequence[Any]


def vectors(text: str) -> list[Any]:
    return [sp.Matrix(sp.symbols(f"{name}0 {name}1")) for name in text.split()]


def lengths(text: str) -> tuple[Any, ...]:
    return tuple(sp.symbols(text, positive=True, seq=True))


def normal(e: Any, length: Any) -> Any:
    return sp.Matrix([e[1], -e[0]]) / length


def end_on_line() -> tuple[Any, Expressions]:
    """The end p + s r n of one offset edge on the line of another; w leads from the other's start
    to p, d and e are their edges."""
    (w, d, e), (k, m) = vectors("w d e"), lengths("k m")
    n = normal(e, m)
    return n.dot(w + s * r * normal(d, k)) - s * r, ((k, d.dot(d)), (m, e.dot(e)))


def end_on_circle() -> tuple[Any, Expressions]:
    """The end of an offset edge (and of the arc there) on the circle of an arc; w leads from the
    centre of the arc to p."""
    (w, e), (k,) = vectors("w e"), lengths("k")
    x = w + s * r * normal(e, k)
    return x.dot(x) - (s * r) ** 2, ((k, e.dot(e)),)


def circle_on_line() -> tuple[Any, Expressions]:
    """The circle of an arc touches the line of an offset edge: its centre, at w from the start of
    the edge, is as far from the line as the radius is long."""
    (w, e), (k,) = vectors("w e"), lengths("k")
    return (normal(e, k).dot(w) - s * r) ** 2 - (s * r) ** 2, ((k, e.dot(e)),)


def circles() -> tuple[Any, Expressions]:
    """Two circles touch: their centres are 2 s r apart, w being the way from one to the other."""
    (w,), (k,) = vectors("w"), lengths("k")
    return k - 2 * s * r, ((k, w.dot(w)),)


def three_lines() -> tuple[Any, Expressions]:
    """Three offset lines pass through one point. d, e, f are the edges, v and w lead from the
    start of the first to those of the others."""
    (d, e, f, v, w), found = vectors("d e f v w"), lengths("k m o")
    starts, edges = (sp.zeros(2, 1), v, w), (d, e, f)
    rows = []
    for start, edge, length in zip(starts, edges, found, strict=True):
        n = sp.Matrix([edge[1], -edge[0]])
        rows.append([n[0], n[1], n.dot(start) + s * r * length])
    determinant = sp.Matrix(rows).det(method="berkowitz")
    return determinant, tuple((x, y.dot(y)) for x, y in zip(found, edges, strict=True))


def three_circles() -> tuple[Any, Expressions]:
    """Three circles of radius s r pass through one point: it is as far from each centre; v and w
    lead from the first centre to the others. k is that distance times four times their area."""
    (v, w), (k,) = vectors("v w"), lengths("k")
    x = sp.symbols("x0 x1")
    to = [sp.Matrix(x).dot(way) - way.dot(way) / 2 for way in (v, w)]
    point = sp.solve(to, x, dict=True)[0]
    area = v[0] * w[1] - v[1] * w[0]
    square = sp.cancel((point[x[0]] ** 2 + point[x[1]] ** 2) * (2 * area) ** 2)
    return s * r * 2 * area - k, ((k, sp.expand(square)),)


CONDITIONS = {
    "end on line": end_on_line,
    "end on circle": end_on_circle,
    "circle on line": circle_on_line,
    "circles": circles,
    "three lines": three_lines,
    "three circles": three_circles,
}


def eliminated(linear: Any, squares: Expressions) -> dict[str, Any]:
    """The polynomial in s without lengths. Its coefficients are in terms of those of the linear
    condition a + b s, sums over products of lengths, so it is derived for all a and b at once:
    `c1` is written for the second coefficient."""
    found = sp.Poly(linear, s, *(length for length, _ in squares))
    terms, polynomial = [], sp.Integer(0)
    squared = sp.symbols([f"L{i}" for i in range(len(squares))])
    for i, (monomial, coefficient) in enumerate(found.terms()):
        symbol = sp.Symbol(f"c{i}")
        terms.append(str(sp.expand(coefficient)))
        powers = (x**k for x, k in zip(found.gens, monomial, strict=True))
        polynomial += symbol * sp.prod(powers)
    for (length, _), square in zip(squares, squared, strict=True):
        polynomial = sp.resultant(polynomial, length**2 - square, length)
    coefficients = sp.Poly(polynomial, s).all_coeffs()
    return {
        "terms": terms,
        "coefficients": [str(sp.expand(c)) for c in coefficients],
        "degree": len(coefficients) - 1,
    }


def solutions() -> dict[str, dict[str, Any]]:
    """Every general solution about discs, by name. Exact; seconds."""
    found = {}
    for name, condition in CONDITIONS.items():
        expression, squares = condition()
        top = sp.expand(sp.numer(sp.together(expression)))
        for length, square in squares:
            top = sp.expand(sp.rem(top, length**2 - square, length))
        linear = sp.Poly(top, s)
        if linear.degree() != 1:
            raise ArithmeticError(f"{name}: degree {linear.degree()} over the lengths")
        slope, offset = linear.all_coeffs()
        data = sorted(map(str, top.free_symbols - {s, *(x for x, _ in squares)}))
        found[f"disc {name}"] = {
            "data": data,
            "lengths": [str(length) for length, _ in squares],
            "squares": [str(sp.expand(square)) for _, square in squares],
            "numerator": str(sp.expand(-offset)),
            "denominator": str(sp.expand(slope)),
            **eliminated(top, squares),
        }
    return found
