"""Convolution edges with symbolic coordinates, and in exact numbers at one scale."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy as sp
from minkref.fuzz.geometry.plane import cross
from minkref.reports.audit.edges import Edge


@dataclass(frozen=True)
class SymbolicEdge:
    """From s p + q along d, which an S-edge takes s times."""

    kind: str
    p: Any
    q: Any
    d: Any

    def start(self, s: Any) -> Any:
        return s * self.p + self.q

    def span(self, s: Any) -> Any:
        return s * self.d if self.kind == "S" else self.d


def kinds_of(kinds: str) -> tuple[SymbolicEdge, SymbolicEdge]:
    """Two edges with symbols for all coordinates."""
    a, b = (
        SymbolicEdge(kind, *(sp.Matrix(sp.symbols(f"{x}_{edge}x {x}_{edge}y")) for x in "pqd"))
        for edge, kind in zip("ab", kinds, strict=True)
    )
    return a, b


def moving(a: SymbolicEdge, b: SymbolicEdge, s: Any) -> tuple[Any, Any]:
    """The lines' crossing at the scale s, and the crossing's parameter on a."""
    v, w, u = a.span(s), b.span(s), a.start(s) - b.start(s)
    r = sp.cancel(cross(w, u) / cross(v, w))
    return (a.start(s) + r * v).applyfunc(sp.cancel), r


def ends(edge: Edge, scale: Fraction) -> tuple[tuple[Fraction, Fraction], ...]:
    """Both ends of a numeric edge, exact."""
    start = tuple(scale * p + q for p, q in zip(edge.p, edge.q, strict=True))
    factor = scale if edge.kind == "S" else Fraction(1)
    end = tuple(x + factor * d for x, d in zip(start, edge.d, strict=True))
    return (start[0], start[1]), (end[0], end[1])
