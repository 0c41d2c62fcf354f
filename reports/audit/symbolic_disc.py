"""A symbolic disc of radius s r, and corners with normals of rational length."""

from __future__ import annotations

import sympy as sp
from minkref.fuzz.judges.disc.paper_disc import Corner

s, r, z = sp.symbols("s r z", positive=True)
# Directions with length 5 and whole coordinates.
FIVES = [(5, 0), (4, 3), (3, 4), (0, 5), (-3, 4), (-4, 3), (-5, 0), (-4, -3), (-3, -4), (0, -5),
         (3, -4), (4, -3)]  # fmt: skip


def vector(name: str) -> sp.Matrix:
    return sp.Matrix(sp.symbols(f"{name}_x {name}_y", real=True))


def unit(name: str) -> sp.Matrix:
    angle = sp.Symbol(name, real=True)
    return sp.Matrix([sp.cos(angle), sp.sin(angle)])


def normal(d: sp.Matrix) -> sp.Matrix:
    """To the right of a direction, and as long."""
    return sp.Matrix([d[1], -d[0]])


def corner_of_normals(at: tuple[int, int], start: tuple[int, int], end: tuple[int, int]) -> Corner:
    """The arc about a vertex between two normals, given as vectors along them."""
    x, y = at
    return (x + start[1], y - start[0]), at, (x - end[1], y + end[0])
