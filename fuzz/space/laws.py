"""How the sum of a pair in space changes with the pair."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import permutations, product

from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point, factors
from minkref.fuzz.space.pair import SpacePair, Truth

ONE: Point = (Fraction(1), Fraction(1), Fraction(1))
SHIFT: Point = (Fraction(7, 3), Fraction(-5), Fraction(11, 2))
FACTOR = Fraction(5, 3)


@dataclass(frozen=True)
class TransformedPair:
    """`back` takes the sum of `pair` to the sum of the original pair, so that known facts about one
    can test a result for the other."""

    name: str
    pair: SpacePair
    back: Callable[[Polyhedron], Polyhedron]


def transformed_pairs(pair: SpacePair) -> list[TransformedPair]:
    """Returns all laws that apply: translations, homogeneity, refinement, the rotation that takes x
    to y to z, a quarter turn about z; and for the scale 1 the swap of operands. For new pairs only
    single points are known."""
    s = factors(pair.scale)
    moved = (s[0] * SHIFT[0], s[1] * SHIFT[1], s[2] * SHIFT[2])
    plain = replace(
        pair,
        truth=Truth.POINTS,
        P_cells=frozenset(),
        Q_cells=frozenset(),
        P_prism=None,
        Q_prism=None,
    )
    laws = [
        TransformedPair(
            "translate-P",
            replace(plain, P=pair.P.translated(SHIFT)),
            lambda sum: sum.translated(_opposite(moved)),
        ),
        TransformedPair(
            "translate-Q",
            replace(plain, Q=pair.Q.translated(SHIFT)),
            lambda sum: sum.translated(_opposite(SHIFT)),
        ),
        TransformedPair(
            "homogeneity",
            replace(plain, P=pair.P.scaled(FACTOR), Q=pair.Q.scaled(FACTOR)),
            lambda sum: sum.scaled(1 / FACTOR),
        ),
        TransformedPair(
            "refinement", replace(plain, P=refined(pair.P), Q=refined(pair.Q)), lambda sum: sum
        ),
    ]
    for name, rotation in (("rotate-axes", Rotation((2, 0, 1))), ("quarter-turn", QUARTER)):
        laws.append(
            TransformedPair(
                name,
                replace(
                    plain,
                    P=rotation.apply(pair.P),
                    Q=rotation.apply(pair.Q),
                    scale=pair.scale
                    if not isinstance(pair.scale, tuple)
                    else rotation.permuted(pair.scale),
                ),
                rotation.inverse().apply,
            )
        )
    if s == ONE:
        swapped = replace(plain, P=pair.Q, Q=pair.P)
        laws.append(TransformedPair("swap", swapped, lambda sum: sum))
    return laws


@dataclass(frozen=True)
class Rotation:
    """The image's coordinate k equals the point's coordinate `axes[k]`, times `signs[k]`."""

    axes: tuple[int, int, int]
    signs: tuple[int, int, int] = (1, 1, 1)

    def apply(self, polyhedron: Polyhedron) -> Polyhedron:
        """Keeps the orientation of faces, so it has to be a rotation: no mirror image."""
        a, b, c = self.axes
        i, j, k = self.signs
        vertices = tuple((i * v[a], j * v[b], k * v[c]) for v in polyhedron.vertices)
        return Polyhedron(vertices, polyhedron.faces)

    def permuted(self, scale: Point) -> Point:
        a, b, c = self.axes
        return (scale[a], scale[b], scale[c])

    def inverse(self) -> Rotation:
        axes, signs = [0, 0, 0], [1, 1, 1]
        for k, axis in enumerate(self.axes):
            axes[axis], signs[axis] = k, self.signs[k]
        return Rotation((axes[0], axes[1], axes[2]), (signs[0], signs[1], signs[2]))

    @property
    def determinant(self) -> int:
        odd = self.axes in ((0, 2, 1), (1, 0, 2), (2, 1, 0))
        return self.signs[0] * self.signs[1] * self.signs[2] * (-1 if odd else 1)


QUARTER = Rotation((1, 0, 2), (-1, 1, 1))  # about the z axis, x to y


def rotations() -> list[Rotation]:
    """All 24 that take the axes to the axes."""
    return [
        rotation
        for axes in permutations((0, 1, 2))
        for signs in product((1, -1), repeat=3)
        if (
            rotation := Rotation((axes[0], axes[1], axes[2]), (signs[0], signs[1], signs[2]))
        ).determinant
        == 1
    ]


def refined(polyhedron: Polyhedron) -> Polyhedron:
    """Refines the same set: every edge gets a vertex in its middle, and every triangle in a face
    becomes four. A face with straight corners, which triangles pass by, stays whole."""
    vertices = list(polyhedron.vertices)
    names: dict[tuple[int, int], int] = {}

    def half(i: int, j: int) -> int:
        key = (min(i, j), max(i, j))
        if key not in names:
            a, b = polyhedron.vertices[i], polyhedron.vertices[j]
            names[key] = len(vertices)
            vertices.append(((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2))
        return names[key]

    faces: list[Face] = []
    for face in polyhedron.faces:
        triangles = polyhedron.triangles_of(face)
        if len(triangles) < len(face) - 2:
            around = zip(face, (*face[1:], face[0]), strict=True)
            faces.append(tuple(k for i, j in around for k in (i, half(i, j))))
            continue
        for i, j, k in triangles:
            ij, jk, ki = half(i, j), half(j, k), half(k, i)
            faces += [(i, ij, ki), (ij, j, jk), (ki, jk, k), (ij, jk, ki)]
    return Polyhedron(tuple(vertices), tuple(faces))


def _opposite(shift: Point) -> Point:
    return (-shift[0], -shift[1], -shift[2])
