"""Solves the contact conditions of two and three moving segments, all data symbolic.

The two segments as sets of points are X(s, t) and Y(s, u), written down as docs/definitions.md has
them. Contact at scale s means that X(s, t) = Y(s, u) has a solution with t and u in [0, 1]. Contact
can only begin or end where t or u is 0 or 1, so that condition is put in and the other unknown
eliminated. The result is a polynomial in s, given in its factors; which of the factors bounds
contact, and on which side, is not asked here.
"""

from __future__ import annotations

from itertools import combinations_with_replacement, product
from typing import Any

import sympy as sp

s = sp.Symbol("s", positive=True)
CONDITIONS = ("t=0", "t=1", "u=0", "u=1")


def data_symbols(letter: str) -> tuple[Any, ...]:
    return tuple(sp.symbols([f"{letter}{i}" for i in range(6)]))


def moving_point(kind: str, data: tuple[Any, ...], t: Any) -> Any:
    """The point of parameter t: `data` in the order of MovingSegment."""
    a, b, c = (sp.Matrix(data[i : i + 2]) for i in (0, 2, 4))
    return s * (a + t * (b - a)) + c if kind == "S" else s * a + b + t * (c - b)


def direction(kind: str, data: tuple[Any, ...]) -> Any:
    a, b, c = (sp.Matrix(data[i : i + 2]) for i in (0, 2, 4))
    return b - a if kind == "S" else c - b


def power_of_s(polynomials: list[Any]) -> int:
    """The highest power of s that divides all of them."""
    return int(min(min(m[0] for m in sp.Poly(p, s).monoms()) for p in polynomials))


def linear_in_s(polynomial: Any) -> dict[str, Any]:
    """A polynomial that is linear in s but for a power of s, which has no positive root, solved:
    `denominator` s = `numerator`. Raises ArithmeticError for another degree than 1."""
    expanded = sp.expand(polynomial)
    power = power_of_s([expanded])
    in_s = sp.Poly(sp.expand(expanded / s**power), s)
    if in_s.degree() != 1:
        raise ArithmeticError(f"degree {in_s.degree()} in s where 1 was expected")
    slope, offset = in_s.all_coeffs()
    return {
        "power_of_s": power,
        "degree": 1,
        "numerator": str(sp.expand(-offset)),
        "denominator": str(sp.expand(slope)),
    }


def end_on_line(kinds: str, condition: str) -> dict[str, Any]:
    """The scales at which X(s, t) = Y(s, u) can be solved for the other unknown, t or u being
    fixed by `condition`, and that unknown as a function of s."""
    t, u = sp.symbols("t u")
    A, B = data_symbols("a"), data_symbols("b")
    fixed, value = {"t": t, "u": u}[condition[0]], sp.Integer(condition[2])
    other = u if fixed == t else t
    gap = (moving_point(kinds[0], A, t) - moving_point(kinds[1], B, u)).subs(fixed, value)
    solved = linear_in_s(sp.resultant(gap[0], gap[1], other))
    # The segment of the other unknown has a length, so the normal equation always has a solution.
    side, data = (kinds[1], B) if other == u else (kinds[0], A)
    along = direction(side, data)
    slope, offset = sp.Poly(sp.expand(gap.dot(along)), other).all_coeffs()
    power = power_of_s([slope, offset])
    above, below = -offset / s**power, slope / s**power
    solved["other"] = {"numerator": str(sp.expand(above)), "denominator": str(sp.expand(below))}
    return solved


def ends_meet(kinds: str, t: int, u: int) -> dict[str, Any]:
    """For segments on one line at all scales: the scale at which the end t of the one passes the
    end u of the other, measured along the direction of the second."""
    A, B = data_symbols("a"), data_symbols("b")
    gap = moving_point(kinds[0], A, sp.Integer(t)) - moving_point(kinds[1], B, sp.Integer(u))
    return linear_in_s(gap.dot(direction(kinds[1], B)))


def concurrent(kinds: str) -> dict[str, Any]:
    """The scale at which the lines of three moving segments pass through one point: x on each line
    is one linear equation in x; three have a solution only where their determinant is zero."""
    rows = []
    for kind, letter in zip(kinds, "abc", strict=True):
        data = data_symbols(letter)
        d, start = direction(kind, data), moving_point(kind, data, sp.Integer(0))
        rows.append([-d[1], d[0], sp.expand(d[0] * start[1] - d[1] * start[0])])
    return linear_in_s(sp.Matrix(rows).det(method="berkowitz"))


def solutions() -> dict[str, dict[str, Any]]:
    """Every general solution in the plane, by name. Exact; seconds."""
    found: dict[str, dict[str, Any]] = {}
    for kinds in map("".join, product("ST", repeat=2)):
        for condition in CONDITIONS:
            found[f"pair {kinds} {condition}"] = end_on_line(kinds, condition)
        for t, u in product((0, 1), repeat=2):
            found[f"ends {kinds} t={t} u={u}"] = ends_meet(kinds, t, u)
    for kinds in map("".join, combinations_with_replacement("ST", 3)):
        found[f"triple {kinds}"] = concurrent(kinds)
    return found
