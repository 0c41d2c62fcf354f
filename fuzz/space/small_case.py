"""Steps that make a space case smaller."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import product
from math import gcd, lcm

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Scale, factors, scale_of
from minkref.fuzz.space.case import scale_text
from minkref.fuzz.space.cells import Cell, cells_of, is_manifold, surface_of
from minkref.fuzz.space.hull import convex_hull, is_convex
from minkref.fuzz.space.laws import ONE
from minkref.fuzz.space.smaller_solids import convex_parts, drawn_together, fewer_shells, is_valid

MOST_CELLS = 400
ORIGIN = (Fraction(0), Fraction(0), Fraction(0))


@dataclass(frozen=True)
class SolidCase:
    P: Polyhedron
    Q: Polyhedron
    scale: Scale

    @cached_property
    def size(self) -> tuple[int, int, int, str]:
        """Vertices, faces, then the length of the numbers."""
        solids = (self.P, self.Q)
        text = self.literal
        length = len(text) + 2 * text.count("-") + 20 * text.count("/")
        length += 0 if factors(self.scale) == ONE else 40
        return (
            sum(len(solid.vertices) for solid in solids),
            sum(len(solid.faces) for solid in solids),
            length,
            text,
        )

    @cached_property
    def literal(self) -> str:
        value = {"P": self.P.document(), "Q": self.Q.document(), "scale": scale_text(self.scale)}
        return json.dumps(value, separators=(",", ":"))

    @staticmethod
    def read(P_json: str, Q_json: str, scale: str) -> SolidCase:
        P, Q = Polyhedron.from_json(P_json), Polyhedron.from_json(Q_json)
        return SolidCase(P, Q, scale_of(scale))

    def with_operand(self, which: int, solid: Polyhedron) -> SolidCase:
        P, Q = (self.P, solid) if which else (solid, self.Q)
        return SolidCase(P, Q, self.scale)

    @property
    def operands(self) -> tuple[Polyhedron, Polyhedron]:
        return (self.P, self.Q)


def smaller_in_space(case: SolidCase) -> Iterator[SolidCase]:
    """Valid candidates, the boldest first."""
    for candidate in _candidates(case):
        if candidate.size < case.size and all(
            new is old or is_valid(new)
            for new, old in zip(candidate.operands, case.operands, strict=True)
        ):
            yield candidate


def _candidates(case: SolidCase) -> Iterator[SolidCase]:
    if factors(case.scale) != ONE:
        yield SolidCase(case.P, case.Q, Fraction(1))
        yield SolidCase(case.P.scaled(case.scale), case.Q, Fraction(1))
    for which, solid in enumerate(case.operands):
        for steps in (_simpler_solids, _fewer_cells, _fewer_corners, _cut_down):
            for simpler in steps(solid):
                yield case.with_operand(which, simpler)
    yield from _simpler_numbers(case)


def _simpler_solids(solid: Polyhedron) -> Iterator[Polyhedron]:
    """Yields the solid's box, its hull, and single shells."""
    if solid.is_thin:
        if len(solid.vertices) == 2:
            yield from (Polyhedron((vertex,), ()) for vertex in solid.vertices)
        return
    low, high = solid.box
    (a, b, c), (x, y, z) = low, high
    yield convex_hull([low, (x, b, c), (a, y, c), (a, b, z)])
    yield convex_hull(product((a, x), (b, y), (c, z)))
    if not is_convex(solid):
        yield convex_hull(solid.vertices)


def _fewer_cells(solid: Polyhedron) -> Iterator[Polyhedron]:
    """Yields a polycube with half the cells, or one cell less."""
    if solid.is_thin:
        return
    try:
        cells = cells_of(solid)
    except ValueError:
        return
    if not 1 < len(cells) <= MOST_CELLS:
        return
    ordered = sorted(cells)
    for axis in range(3):
        values = sorted({cell[axis] for cell in cells})
        for cut in values[1:]:
            for part in (
                frozenset(cell for cell in cells if cell[axis] < cut),
                frozenset(cell for cell in cells if cell[axis] >= cut),
            ):
                if is_manifold(part):
                    yield surface_of(part)
        for gone in values[1:-1]:
            closed = frozenset(_closed(cell, axis, gone) for cell in cells if cell[axis] != gone)
            if is_manifold(closed):
                yield surface_of(closed)
    for cell in ordered:
        rest = cells - {cell}
        if is_manifold(rest):
            yield surface_of(rest)


def _closed(cell: Cell, axis: int, gone: int) -> Cell:
    """Moves a cell after a layer is taken out."""
    moved = list(cell)
    if cell[axis] > gone:
        moved[axis] -= 1
    return (moved[0], moved[1], moved[2])


def _fewer_corners(solid: Polyhedron) -> Iterator[Polyhedron]:
    """Yields hulls of a convex solid's vertices, without one or without half."""
    if solid.is_thin or not is_convex(solid) or len(solid.vertices) <= 4:
        return
    vertices = solid.vertices
    half = len(vertices) // 2
    groups = [vertices[half:], vertices[:half]] if half >= 4 else []
    groups += [vertices[:k] + vertices[k + 1 :] for k in range(len(vertices))]
    for group in groups:
        try:
            yield convex_hull(group)
        except ValueError:
            continue


def _cut_down(solid: Polyhedron) -> Iterator[Polyhedron]:
    """Smaller forms of a solid of any shape, the boldest steps first."""
    yield from fewer_shells(solid)
    yield from convex_parts(solid)
    yield from drawn_together(solid)


def _simpler_numbers(case: SolidCase) -> Iterator[SolidCase]:
    for which, solid in enumerate(case.operands):
        low = solid.box[0]
        if low != ORIGIN:
            moved = solid.translated((-low[0], -low[1], -low[2]))
            yield case.with_operand(which, moved)
            for axis in range(3):
                by = [Fraction(0)] * 3
                by[axis] = -low[axis]
                yield case.with_operand(which, solid.translated((by[0], by[1], by[2])))
    numbers = [n for solid in case.operands for vertex in solid.vertices for n in vertex]
    denominator = lcm(*(number.denominator for number in numbers))
    divisor = gcd(*(int(number * denominator) for number in numbers))
    if divisor:
        factor = Fraction(denominator, divisor)
        yield SolidCase(case.P.scaled(factor), case.Q.scaled(factor), case.scale)
    for which, solid in enumerate(case.operands):
        yield case.with_operand(which, _ranked(solid))
        for most in (1, 2, 4):
            yield case.with_operand(which, _with_denominators(solid, most))
        for step in (Fraction(10), Fraction(1)):
            for axis in range(3):
                for sign in (1, -1):
                    by = [Fraction(0)] * 3
                    by[axis] = sign * step
                    yield case.with_operand(which, solid.translated((by[0], by[1], by[2])))


def _ranked(solid: Polyhedron) -> Polyhedron:
    """Replaces each coordinate by its rank, counted from zero's rank."""
    places = []
    for axis in range(3):
        values = sorted({vertex[axis] for vertex in solid.vertices})
        below = sum(1 for value in values if value < 0)
        places.append({value: Fraction(k - below) for k, value in enumerate(values)})
    vertices: tuple[Point, ...] = tuple(
        (places[0][x], places[1][y], places[2][z]) for x, y, z in solid.vertices
    )
    return Polyhedron(vertices, solid.faces)


def _with_denominators(solid: Polyhedron, most: int) -> Polyhedron:
    """Each number by the nearest with a denominator of at most `most`."""
    vertices: tuple[Point, ...] = tuple(
        (x.limit_denominator(most), y.limit_denominator(most), z.limit_denominator(most))
        for x, y, z in solid.vertices
    )
    return Polyhedron(vertices, solid.faces)
