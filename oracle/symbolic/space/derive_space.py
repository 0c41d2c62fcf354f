"""Solves the conditions of facets and edges in space, all data symbolic.

A facet moves as the points X(s, a, b); its plane is normal . x = slope s + constant. The normal is
the product of the spanning vectors, which has a power of s as a factor: divided out. Every
condition is then a determinant. Its degree in s is found, not assumed.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import sympy as sp

from ..derive_plane import linear_in_s, power_of_s, s

FACETS = ("fv", "vf", "ee")


def symbols(letter: str, count: int) -> tuple[Any, ...]:
    return tuple(sp.symbols([f"{letter}{i}" for i in range(count)]))


def spanned_facet(kind: str, data: tuple[Any, ...], a: Any, b: Any) -> Any:
    """fv: a corner of P's facet, two more, Q's vertex; vf: P's vertex, three corners of Q's facet;
    ee: both ends of P's edge, both ends of Q's."""
    w, x, y, z = (sp.Matrix(data[i : i + 3]) for i in (0, 3, 6, 9))
    if kind == "fv":
        return s * (w + a * (x - w) + b * (y - w)) + z
    if kind == "vf":
        return s * w + x + a * (y - x) + b * (z - x)
    return s * (w + a * (x - w)) + y + b * (z - y)


def moving_line(kind: str, data: tuple[Any, ...]) -> tuple[Any, Any]:
    """A point and the direction of an edge: S, T, or D, the diagonal s e_P + e_Q of an ee-facet."""
    if kind == "D":
        w, x, y, z = (sp.Matrix(data[i : i + 3]) for i in (0, 3, 6, 9))
        return s * w + y, s * (x - w) + z - y
    w, x, y = (sp.Matrix(data[i : i + 3]) for i in (0, 3, 6))
    return (s * w + y, x - w) if kind == "S" else (s * w + x, y - x)


def plane(kind: str) -> dict[str, Any]:
    """Normal and offset as polynomials in the data; raises ArithmeticError unless, divided by the
    power of s, the normal stands still and the offset is linear."""
    a, b = sp.symbols("a b")
    X = spanned_facet(kind, symbols("a", 12), a, b)
    normal = [sp.expand(x) for x in X.diff(a).cross(X.diff(b))]
    power = power_of_s(normal)
    normal = [sp.expand(x / s**power) for x in normal]
    offset = sp.Poly(sp.expand(sp.Matrix(normal).dot(X.subs({a: 0, b: 0}))), s)
    if any(x.has(s) for x in normal) or offset.degree() != 1:
        raise ArithmeticError(f"the plane of a facet {kind} is not linear in s")
    slope, constant = (str(x) for x in offset.all_coeffs())
    return {
        "power_of_s": power,
        "degree": 1,
        "normal": [str(x) for x in normal],
        "slope": slope,
        "constant": constant,
    }


def vertex_in_plane() -> dict[str, Any]:
    """s p + q in the plane n . x = k s + l. Data n, k, l; p, q."""
    n, rest, v = symbols("a", 3), symbols("a", 5)[3:], symbols("b", 6)
    at = s * sp.Matrix(v[:3]) + sp.Matrix(v[3:])
    return linear_in_s(sp.expand(sp.Matrix(n).dot(at) - rest[0] * s - rest[1]))


def parallel_planes() -> dict[str, Any]:
    """Two planes with one normal: n . x = k s + l and n . x = k' s + l'."""
    k, m = symbols("a", 2), symbols("b", 2)
    return linear_in_s((k[0] - m[0]) * s + k[1] - m[1])


def four_planes() -> dict[str, Any]:
    """Four planes n . x = k s + l through one point."""
    rows = [symbols(letter, 5) for letter in "abcd"]
    matrix = sp.Matrix([[*row[:3], row[3] * s + row[4]] for row in rows])
    return linear_in_s(matrix.det(method="berkowitz"))


def lines_meet(kinds: str) -> dict[str, Any]:
    """Lines of two moving edges in one plane: the gap of two points of theirs and both directions
    are dependent. Coefficients of the powers of s, the highest first."""
    sizes = {"S": 9, "T": 9, "D": 12}
    (x, d), (y, e) = (
        moving_line(kind, symbols(letter, sizes[kind]))
        for kind, letter in zip(kinds, "ab", strict=True)
    )
    polynomial = sp.Poly(sp.expand(sp.Matrix.hstack(x - y, d, e).det(method="berkowitz")), s)
    return {
        "degree": int(polynomial.degree()),
        "coefficients": [str(c) for c in polynomial.all_coeffs()],
    }


def solutions() -> dict[str, dict[str, Any]]:
    """Every general solution in space, by name. Exact; seconds."""
    found = {f"plane {kind}": plane(kind) for kind in FACETS}
    found["vertex in plane"] = vertex_in_plane()
    found["parallel planes"] = parallel_planes()
    found["four planes"] = four_planes()
    for kinds in map("".join, product("STD", repeat=2)):
        found[f"lines {kinds}"] = lines_meet(kinds)
    return found
