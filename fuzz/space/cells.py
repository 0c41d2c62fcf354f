"""Polycubes: sets of integer cells, their surface, and the sum of two polycubes as cells."""

from __future__ import annotations

from collections.abc import Iterable, Set
from dataclasses import dataclass
from fractions import Fraction
from itertools import product

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point, Scale, Whole, factors

Cell = tuple[int, int, int]  # the cube from here to here + (1, 1, 1)
Cells = Set[Cell]

# For each neighbour the side that faces it, counter-clockwise seen from the neighbour.
_SIDES: tuple[tuple[Cell, tuple[Cell, ...]], ...] = (
    ((-1, 0, 0), ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0))),
    ((1, 0, 0), ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1))),
    ((0, -1, 0), ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1))),
    ((0, 1, 0), ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0))),
    ((0, 0, -1), ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0))),
    ((0, 0, 1), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))),
)


@dataclass(frozen=True)
class CellSum:
    """The union of the cells, each `unit` large along the axes."""

    cells: frozenset[Cell]
    unit: Point

    @property
    def volume(self) -> Fraction:
        a, b, c = self.unit
        return len(self.cells) * a * b * c

    def polyhedron(self) -> Polyhedron:
        return surface_of(self.cells).scaled(self.unit)


def surface_of(cells: Cells) -> Polyhedron:
    """Returns the boundary in unit squares. If cells touch only along an edge or at a corner, the
    surface touches itself there."""
    names: dict[Whole, int] = {}
    faces = []
    for x, y, z in sorted(cells):
        for (dx, dy, dz), corners in _SIDES:
            if (x + dx, y + dy, z + dz) in cells:
                continue
            faces.append(
                tuple(names.setdefault((x + a, y + b, z + c), len(names)) for a, b, c in corners)
            )
    vertices = tuple((Fraction(x), Fraction(y), Fraction(z)) for x, y, z in names)
    return Polyhedron(vertices, tuple(faces))


def cells_of(polyhedron: Polyhedron) -> frozenset[Cell]:
    """Returns the cells bounded by this surface. ValueError if no set of cells has this surface."""
    from minkref.fuzz.space.membership import Surface

    for face in polyhedron.faces:
        ring = [polyhedron.vertices[index] for index in face]
        if any(number.denominator != 1 for point in ring for number in point):
            raise ValueError("a vertex is not integer")
        if all(len({point[axis] for point in ring}) > 1 for axis in range(3)):
            raise ValueError("a face is not parallel to two axes")
    surface = Surface(polyhedron)
    return frozenset(
        cell for cell in _grid(polyhedron, (Fraction(1),) * 3) if surface.contains(_centre(cell))
    )


def is_manifold(cells: Cells) -> bool:
    """Whether the surface is a 2-manifold: around every grid corner sides connect the full cells,
    and also the empty cells. False for an empty set."""
    corners = {(x + a, y + b, z + c) for x, y, z in cells for a, b, c in product((0, 1), repeat=3)}
    for x, y, z in corners:
        around = {(x - a, y - b, z - c) for a, b, c in product((0, 1), repeat=3)}
        full = around & cells
        if not (_connected(full) and _connected(around - full)):
            return False
    return bool(cells)


def sum_of_cells(P: Cells, Q: Cells, scale: Scale) -> CellSum:
    """sP + Q. At the scale n/d the grid has d lines to a unit, each cell of P is n^3 cells of it,
    each of Q d^3, and two cells add to a cube of side n + d."""
    s = factors(scale)
    n, d = [number.numerator for number in s], [number.denominator for number in s]
    i, j, k = (range(n[axis] + d[axis]) for axis in range(3))
    block = list(product(i, j, k))
    corners = {
        (n[0] * a[0] + d[0] * b[0], n[1] * a[1] + d[1] * b[1], n[2] * a[2] + d[2] * b[2])
        for a in P
        for b in Q
    }
    cells = frozenset((x + a, y + b, z + c) for x, y, z in corners for a, b, c in block)
    return CellSum(cells, (Fraction(1, d[0]), Fraction(1, d[1]), Fraction(1, d[2])))


def parts(cells: Cells) -> list[set[Cell]]:
    """Returns the sets of cells connected by sides, ascending by their least cells."""
    left = set(cells)
    found = []
    for cell in sorted(cells):
        if cell not in left:
            continue
        left.remove(cell)
        part, ahead = {cell}, [cell]
        while ahead:
            x, y, z = ahead.pop()
            for (dx, dy, dz), _ in _SIDES:
                other = (x + dx, y + dy, z + dz)
                if other in left:
                    left.remove(other)
                    part.add(other)
                    ahead.append(other)
        found.append(part)
    return found


def cavities(cells: Cells) -> list[set[Cell]]:
    """The bounded parts of the complement of the closed cells: where empty cells touch along an
    edge or at a corner only, closed cells lie between them."""
    if not cells:
        return []
    low = [min(cell[k] for cell in cells) - 1 for k in range(3)]
    high = [max(cell[k] for cell in cells) + 1 for k in range(3)]
    x, y, z = (range(low[k], high[k] + 1) for k in range(3))
    box = set(product(x, y, z))
    outside = (low[0], low[1], low[2])
    return [part for part in parts(box - set(cells)) if outside not in part]


def _connected(cells: set[Cell]) -> bool:
    return len(parts(cells)) <= 1


def _centre(cell: Cell) -> Point:
    half = Fraction(1, 2)
    return (cell[0] + half, cell[1] + half, cell[2] + half)


def grid_cells(low: Point, high: Point, unit: Point) -> Iterable[Cell]:
    """All cells, each `unit` large, that meet the inside of the box."""
    first = [low[k] // unit[k] for k in range(3)]
    last = [-(-high[k] // unit[k]) for k in range(3)]
    x, y, z = (range(first[k], last[k]) for k in range(3))
    return product(x, y, z)


def _grid(polyhedron: Polyhedron, unit: Point) -> Iterable[Cell]:
    return grid_cells(*polyhedron.box, unit)
