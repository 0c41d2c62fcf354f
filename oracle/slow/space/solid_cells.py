"""Sums of polycubes under a matrix: `s MP + MQ = M(sP + Q)`, where sP + Q is a polycube again.

At scale n/d the grid has d lines per unit; a cell from P plus a cell from Q gives a cube of n + d
grid cells along each side. The matrix maps cell sides that no other cell covers.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import product

from ..exact import InputError
from .exposed import Exposed, of_faces
from .solid import Place, Whole, inner, outer

Matrix = tuple[Whole, Whole, Whole]
IDENTITY: Matrix = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


class CellSum:
    """The sum of two sets of cells, each a cube from (i, j, k) to (i + 1, j + 1, k + 1), under an
    integer matrix given by rows. InputError if the matrix is singular."""

    def __init__(
        self, P: Iterable[Whole], Q: Iterable[Whole], scale: Fraction, matrix: Matrix = IDENTITY
    ) -> None:
        self.matrix = matrix
        self.determinant = inner(matrix[0], outer(matrix[1], matrix[2]))
        if self.determinant == 0:
            raise InputError("the matrix is singular")
        n, self.unit = scale.numerator, scale.denominator
        d = self.unit
        corners = {(n * a + d * i, n * b + d * j, n * c + d * k) for a, b, c in P for i, j, k in Q}
        block = list(product(range(n + d), repeat=3))
        self.cells = {(x + i, y + j, z + k) for x, y, z in corners for i, j, k in block}

    def volume(self) -> Fraction:
        return Fraction(len(self.cells) * abs(self.determinant), self.unit**3)

    def exposed(self) -> Exposed:
        """Return the sum in canonical form. Exact. Linear in the cells, except for coplanar
        rings."""
        return of_faces(self._sides())

    def _sides(self) -> Iterable[list[Place]]:
        for cell in self.cells:
            for axis in range(3):
                for step in (0, 1):
                    beyond = list(cell)
                    beyond[axis] += 2 * step - 1
                    if (beyond[0], beyond[1], beyond[2]) in self.cells:
                        continue
                    ring = [self._image(corner) for corner in side(cell, axis, step)]
                    yield ring if self.determinant > 0 else ring[::-1]

    def _image(self, corner: Whole) -> Place:
        x, y, z = (Fraction(inner(row, corner), self.unit) for row in self.matrix)
        return x, y, z

    def holds(self, x: Place, interiors: bool = False) -> bool:
        """Tell whether the closed sum, or with `interiors` its interior, contains the point.
        Exact."""
        a, b, c = self.matrix
        columns = outer(b, c), outer(c, a), outer(a, b)  # of the inverse, over the determinant
        place = []
        for k in range(3):
            value = sum((columns[i][k] * x[i] for i in range(3)), Fraction(0))
            place.append(value * self.unit / self.determinant)
        around = product(*(
            {value.__floor__(), value.__ceil__() - 1} for value in place
        ))  # fmt: skip
        found = [cell in self.cells for cell in around]
        return all(found) if interiors else any(found)


def side(cell: Whole, axis: int, step: int) -> list[Whole]:
    """Return the cell's side towards one end of the axis, counter-clockwise seen from outside."""
    u, v = (axis + 1) % 3, (axis + 2) % 3
    ring = []
    for at_u, at_v in ((0, 0), (1, 0), (1, 1), (0, 1))[:: 1 if step else -1]:
        corner = list(cell)
        corner[axis] += step
        corner[u] += at_u
        corner[v] += at_v
        ring.append((corner[0], corner[1], corner[2]))
    return ring
