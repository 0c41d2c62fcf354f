"""A right adapter in space; unusual and faulty adapters override parts."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, ClassVar

from conversation import Adapter, Answer, Request
from face_pieces import fan
from minkref import _core
from space_sets import Shell, body_of, corners_of, is_convex, shell_of
from space_sums import sum_in_space

SETS = ["non-convex", "holes", "components", "touching", "empty", "point", "segment"]
ALL = ["space", *SETS, "rational", "non-uniform"]


class Space(Adapter):
    """Exact sums for all declared capabilities."""

    declares: ClassVar[dict[str, Any]] = {"capabilities": ALL}

    def at(self, request: Request) -> Answer:
        return self.form(self.shells(request))

    def shells(self, request: Request) -> list[Shell]:
        return sum_in_space(shell_of(request["sP"]), shell_of(self.Q))

    def form(self, shells: list[Shell]) -> Answer:
        """Answers with one list of vertices for all shells."""
        vertices: list[Any] = []
        faces: list[Any] = []
        for points, rings in shells:
            faces += [[k + len(vertices) for k in ring] for ring in rings]
            vertices += [[self.number(c) for c in point] for point in points]
        return {"vertices": vertices, "faces": faces}

    def number(self, value: Fraction) -> Any:
        return str(value)


class DoublesInSpace(Space):
    """Triangles, each coordinate of the exact sum rounded to the nearest double."""

    declares: ClassVar[dict[str, Any]] = {
        "arithmetic": "float64",
        "numbers": "double",
        "tolerance": {"absolute": "0", "relative": "1/4503599627370496"},
        "capabilities": ["space", *SETS, "non-uniform"],
    }

    def form(self, shells: list[Shell]) -> Answer:
        return super().form([in_triangles(shell) for shell in shells])

    def number(self, value: Fraction) -> Any:
        return float(value)


class UpdatingInSpace(Space):
    """`update` steps from the scaling of the last answer by the reference's dynamic sum."""

    declares: ClassVar[dict[str, Any]] = {"capabilities": [*ALL, "update"]}

    def at(self, request: Request) -> Answer:
        self.scaling = scaling_of(request)
        return super().at(request)

    def update(self, request: Request) -> Answer:
        before, self.scaling = self.scaling, scaling_of(request)
        P, Q = shell_of(self.P), shell_of(self.Q)
        if not (P[1] and Q[1] and is_convex(P) and is_convex(Q)):
            return super().at(request)
        walk = _core.DynamicConvexSum(body_of(P), body_of(Q), before)
        walk.update(self.scaling)
        found = walk.sum().surface
        points = [tuple(Fraction(c) for c in point) for point in found.points()]
        return self.form([(points, found.rings())])


def scaling_of(request: Request) -> Any:
    scale = request["scale"]
    return tuple(scale) if isinstance(scale, list) else (scale,) * 3


def in_triangles(shell: Shell) -> Shell:

    points, faces = shell
    found = []
    for face in faces:
        names = {points[k]: k for k in face}
        for piece in fan(corners_of(shell, face)):
            ring = [names[p] for p in piece]
            found += [[ring[0], ring[k], ring[k + 1]] for k in range(1, len(ring) - 1)]
    return points, found
