"""Solids under integer matrices."""

from __future__ import annotations

import random
from itertools import permutations, product

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Whole, cross, dot

Matrix = tuple[Whole, Whole, Whole]  # rows
IDENTITY: Matrix = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def determinant(matrix: Matrix) -> int:
    return dot(matrix[0], cross(matrix[1], matrix[2]))


def mapped(matrix: Matrix, solid: Polyhedron) -> Polyhedron:
    """Maps a solid, keeping normals outward if the matrix mirrors; not for a singular matrix."""
    vertices = []
    for v in solid.vertices:
        x, y, z = (row[0] * v[0] + row[1] * v[1] + row[2] * v[2] for row in matrix)
        vertices.append((x, y, z))
    image = Polyhedron(tuple(vertices), solid.faces)
    return image if determinant(matrix) > 0 or solid.is_thin else image.turned_inside_out()


def random_matrix(dice: random.Random, most: int) -> Matrix:
    """Not singular, entries of at most this size."""
    while True:
        a, b, c = ((_entry(dice, most), _entry(dice, most), _entry(dice, most)) for _ in range(3))
        if determinant((a, b, c)) != 0:
            return a, b, c


def _entry(dice: random.Random, most: int) -> int:
    return dice.randint(-most, most)


def unimodular(dice: random.Random, steps: int) -> Matrix:
    """A matrix of GL(3, Z): a signed permutation, then `steps` shears."""
    rows = [list(row) for row in dice.choice(signed_permutations())]
    for _ in range(steps):
        i, j = dice.sample(range(3), 2)
        t = dice.choice((-1, 1))
        rows[i] = [a + t * b for a, b in zip(rows[i], rows[j], strict=True)]
    a, b, c = ((row[0], row[1], row[2]) for row in rows)
    return a, b, c


def signed_permutations() -> list[Matrix]:
    """All 48."""
    found: list[Matrix] = []
    for axes in permutations(range(3)):
        for signs in product((1, -1), repeat=3):
            rows = [[0, 0, 0] for _ in range(3)]
            for k in range(3):
                rows[k][axes[k]] = signs[k]
            a, b, c = ((row[0], row[1], row[2]) for row in rows)
            found.append((a, b, c))
    return found
