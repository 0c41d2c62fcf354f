"""Formulas from Behar & Lien 2012, Section 4, by computer algebra: where two convolution edges
intersect, when the intersection reaches an end, and for which scales the edges meet. Each as
printed and corrected."""

from __future__ import annotations

from dataclasses import dataclass

import sympy

S = sympy.Symbol("s", real=True)
EVERY, NONE = "every scale", "no scale"


@dataclass(frozen=True)
class Edge:
    """An edge from start to end, two points linear in S."""

    start: sympy.Matrix
    end: sympy.Matrix

    def at(self, scale: object) -> Edge:
        return Edge(self.start.subs(S, scale), self.end.subs(S, scale))


def s_edge(p0: tuple[object, object], p1: tuple[object, object], q: tuple[object, object]) -> Edge:
    """Make the edge s e_P + v_Q (Section 4.1)."""
    return Edge(S * _vector(p0) + _vector(q), S * _vector(p1) + _vector(q))


def t_edge(q0: tuple[object, object], q1: tuple[object, object], p: tuple[object, object]) -> Edge:
    """Make the edge e_Q + s v_P (Section 4.1)."""
    return Edge(_vector(q0) + S * _vector(p), _vector(q1) + S * _vector(p))


def parallel(a: Edge, b: Edge) -> bool:
    one, other = a.at(1), b.at(1)
    return bool(_cross(one.end - one.start, other.end - other.start) == 0)


def intersection(a: Edge, b: Edge, printed: bool) -> sympy.Matrix:
    """Return x(s) = x0 + (s - 1) sigma from Section 4.2, using the intersections at scales 1 and 2:
    by Observation 1 as printed, or by solving l_a(r) = l_b(t)."""
    first, second = (_at_scale(a.at(k), b.at(k), printed) for k in (1, 2))
    return first + (S - 1) * (second - first)


def _at_scale(a: Edge, b: Edge, printed: bool) -> sympy.Matrix:
    v, w, u = a.end - a.start, b.end - b.start, a.start - b.start
    if printed:
        r = (v[1] * u[0] - v[0] * u[0]) / (v[0] * w[1] - v[1] * w[0])
        return a.start + r * v
    r, t = sympy.symbols("r t")
    (solution,) = sympy.linsolve(list(a.start + r * v - b.start - t * w), [r, t])
    return a.start + solution[0] * v


def scale_of_contact(x: sympy.Matrix, end: sympy.Matrix, way: str, along: sympy.Matrix) -> object:
    """Solve x(s) = end(s) (Sections 4.2.1 and 4.2.2): a number, EVERY or NONE. `way`: `printed`,
    all equations at once; `least-squares`; `corrected`, the equation along the edge."""
    apart = x - end
    if way == "least-squares":
        square = sympy.expand(apart.dot(apart))
        if sympy.Poly(square, S).degree() == 2:
            return sympy.solve(sympy.diff(square, S), S)[0]
        return EVERY if square == 0 else NONE
    equations = list(apart) if way == "printed" else [apart.dot(along)]
    found = sympy.linsolve([sympy.expand(equation) for equation in equations], [S])
    if found == sympy.EmptySet:
        return NONE
    ((value,),) = found
    return EVERY if value.has(S) else value


def region(
    a: Edge, b: Edge, observation: str, solve: str, interval: str
) -> tuple[object, object] | None:
    """Find the closed interval of scales s > 0 at which two edges, not parallel, meet (Section
    4.2.3): its bounds, None for a missing bound. As printed, starts bound the interval from below
    and ends from above."""
    x = intersection(a, b, observation == "printed")
    lower: list[sympy.Rational] = []
    upper: list[sympy.Rational] = []
    for edge in (a, b):
        along = edge.at(1).end - edge.at(1).start
        for end, is_start in ((edge.start, True), (edge.end, False)):
            scale = scale_of_contact(x, end, solve, along)
            # Along the edge: neither before its start nor beyond its end.
            inward = sympy.expand((x - end).dot(along) * (1 if is_start else -1))
            slope = sympy.diff(inward, S)
            if interval == "corrected" and slope == 0:
                if inward < 0:
                    return None
                continue
            if scale in (EVERY, NONE):
                continue
            from_below = is_start if interval == "printed" else slope > 0
            (lower if from_below else upper).append(scale)
    least = max((scale for scale in lower if scale > 0), default=None)
    most = min(upper, default=None)
    if most is not None and (most <= 0 or (least is not None and least > most)):
        return None
    return (least, most)


def _vector(point: tuple[object, object]) -> sympy.Matrix:
    return sympy.Matrix([sympy.Rational(str(number)) for number in point])


def _cross(u: sympy.Matrix, v: sympy.Matrix) -> object:
    return u[0] * v[1] - u[1] * v[0]
