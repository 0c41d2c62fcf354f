"""Facets and edges in space with symbols for all coordinates."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

s = sp.Symbol("s", positive=True)
# Powers of s for the vectors along an edge, and for both vectors that span a facet.
EDGES: dict[str, tuple[int, ...]] = {"S": (1,), "T": (0,)}
FACETS: dict[str, tuple[int, ...]] = {"fv": (1, 1), "vf": (0, 0), "ee": (1, 0)}


def place(name: str) -> Any:
    return sp.Matrix(sp.symbols(f"{name}_x {name}_y {name}_z"))


@dataclass(frozen=True)
class Flat:
    """Part of a line or plane: the point s p + q and vectors, each times a power of s."""

    kind: str
    p: Any
    q: Any
    along: tuple[Any, ...]
    powers: tuple[int, ...]

    @property
    def start(self) -> Any:
        return s * self.p + self.q

    @property
    def spans(self) -> list[Any]:
        return [s**power * each for power, each in zip(self.powers, self.along, strict=True)]

    @property
    def power(self) -> int:
        return sum(self.powers)


def edge(kind: str, name: str) -> Flat:
    return Flat(kind, place(f"p_{name}"), place(f"q_{name}"), (place(f"d_{name}"),), EDGES[kind])


def diagonal(name: str) -> Any:
    """A point and the direction s d + g of a diagonal of an ee-facet."""
    return s * place(f"p_{name}") + place(f"q_{name}"), s * place(f"d_{name}") + place(f"g_{name}")


def facet(kind: str, name: str) -> Flat:
    vectors = (place(f"u_{name}"), place(f"v_{name}"))
    return Flat(kind, place(f"p_{name}"), place(f"q_{name}"), vectors, FACETS[kind])


def determinant(a: Any, b: Any, c: Any) -> Any:
    return sp.expand(sp.Matrix.hstack(a, b, c).det(method="berkowitz"))


def degree(expression: Any) -> int:
    """In s."""
    return int(sp.Poly(sp.expand(expression), s).degree())
