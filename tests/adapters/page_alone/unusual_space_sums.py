"""Right adapters in space with sums, tolerances, grids and verbs of their own."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, ClassVar

from conversation import Answer, Request
from plane_adapter import Events, Refusing, Updating
from space_adapter import ALL, SETS, Space, UpdatingInSpace, in_triangles
from space_sets import Shell, is_convex, shell_of
from space_sums import sum_in_space, sums
from unusual_space import RejectsInSpace

CONVEX = ["space", "empty", "point", "segment", "rational", "non-uniform"]


def cube(half: Fraction) -> Shell:
    ends = (-half, half)
    corners = [(x, y, z) for x in ends for y in ends for z in ends]
    sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return corners, sides


class AllOutInSpace(Space):
    """Convex sums grown by nine tenths of the absolute tolerance."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "directed",
        "tolerance": {"absolute": "0.001", "relative": "0"},
        "capabilities": CONVEX,
    }

    def shells(self, request: Request) -> list[Shell]:
        found = super().shells(request)
        return sum_in_space(found[0], cube(Fraction(9, 10000))) if found else []


class GridInSpace(Space):
    """Takes 20 bits, and answers triangles rounded to multiples of 2^-30."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "integer-grid",
        "grid": {"bits": 20},
        "tolerance": {"absolute": "1/1073741824", "relative": "0"},
        "capabilities": ["space", *SETS, "non-uniform"],
    }

    def form(self, shells: list[Shell]) -> Answer:
        return super().form([in_triangles(shell) for shell in shells])

    def number(self, value: Fraction) -> Any:
        return str(Fraction(round(value * 2**30), 2**30))


class ClosedInSpace(Space):
    """Keeps parts without volume: a point or a segment has vertices and no faces."""

    declares: ClassVar[dict[str, Any]] = {"sets": "closed", "capabilities": ALL}

    def shells(self, request: Request) -> list[Shell]:
        P, Q = shell_of(request["sP"]), shell_of(self.Q)
        found = sum_in_space(P, Q)
        if found or P[1] or Q[1]:
            return found
        points = [tuple(a + b for a, b in zip(p, q, strict=True)) for p in P[0] for q in Q[0]]
        return [(sorted(set(points)), [])]


class ExtremeVertices(Space):
    """Computes the sum of convex operands as the hull of all vertex sums."""

    def shells(self, request: Request) -> list[Shell]:
        P, Q = shell_of(request["sP"]), shell_of(self.Q)
        if not (P[1] and Q[1] and is_convex(P) and is_convex(Q)) or len(P[0]) * len(Q[0]) > 400:
            return sum_in_space(P, Q)
        found = sums(P[0], Q[0])
        return [found] if found else []


class FlatEverything(Updating, Events, Refusing):
    """All verbs, for the plane alone."""


class Everything(UpdatingInSpace, RejectsInSpace):
    """All verbs and capabilities, for the plane and for space."""

    declares: ClassVar[dict[str, Any]] = {
        "capabilities": ["plane", *ALL, "update", "events", "rejects-invalid"]
    }

    def load(self, request: Request) -> Answer:
        self.flat = FlatEverything() if request["dimension"] == 2 else None
        return self.flat.load(request) if self.flat else super().load(request)

    def at(self, request: Request) -> Answer:
        return self.flat.at(request) if self.flat else super().at(request)

    def update(self, request: Request) -> Answer:
        return self.flat.update(request) if self.flat else super().update(request)

    def events(self, request: Request) -> Answer:
        return self.flat.events(request) if self.flat else super().events(request)


class Tetrahedra(Space):
    """Each convex sum cut into tetrahedra, from a point inside to the triangles around it."""

    def form(self, shells: list[Shell]) -> Answer:
        return super().form([piece for shell in shells for piece in tetrahedra(shell)])


def tetrahedra(shell: Shell) -> list[Shell]:
    if not shell[1] or not is_convex(shell):
        return [shell]
    points, faces = in_triangles(shell)
    used = sorted({k for face in faces for k in face})
    middle = tuple(sum(points[k][axis] for k in used) / len(used) for axis in range(3))
    sides = [[0, 1, 2], [3, 1, 0], [3, 2, 1], [3, 0, 2]]
    return [([*(points[k] for k in face), middle], sides) for face in faces]


class CoveredTwice(Space):
    """Each convex sum, and once more its half beside the first vertex."""

    def shells(self, request: Request) -> list[Shell]:
        found = super().shells(request)
        return [*found, *(half for shell in found if (half := half_of(shell)))]


def half_of(shell: Shell) -> Shell | None:
    points, faces = shell
    if not faces or not is_convex(shell):
        return None
    first = points[faces[0][0]]
    shrunk = [tuple((a + b) / 2 for a, b in zip(first, point, strict=True)) for point in points]
    return shrunk, faces
