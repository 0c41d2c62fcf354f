"""Right adapters in space, each with one habit that the page allows."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any, ClassVar

from conversation import Answer, Rejected, Request
from minkref import BadInput, _core
from plane_adapter import Plane
from space_adapter import ALL, DoublesInSpace, Space, UpdatingInSpace, in_triangles, scaling_of
from space_sets import Shell, shell_of
from space_sums import sum_in_space


class PlainInSpace(Space):
    """Polygons, several shells that overlap or abut."""


class TrianglesInSpace(Space):
    """Every face cut into triangles."""

    def form(self, shells: list[Shell]) -> Answer:
        return super().form([in_triangles(shell) for shell in shells])


class UnusedVertices(Space):
    """Vertices that no face names, before and behind."""

    def form(self, shells: list[Shell]) -> Answer:
        found = super().form(shells)
        if found["faces"]:
            found["vertices"] = [["77", "1", "0"], *found["vertices"], ["-99", "0", "1/3"]]
            found["faces"] = [[k + 1 for k in face] for face in found["faces"]]
        return found


class NoVertexShared(Space):
    """Each face has separate vertices."""

    def form(self, shells: list[Shell]) -> Answer:
        found = super().form(shells)
        vertices = [found["vertices"][k] for face in found["faces"] for k in face]
        faces, first = [], 0
        for face in found["faces"]:
            faces.append(list(range(first, first + len(face))))
            first += len(face)
        return {"vertices": vertices, "faces": faces}


class FacesTurned(Space):
    """Faces with another order and another start; vertices reordered too."""

    def form(self, shells: list[Shell]) -> Answer:
        found = super().form(shells)
        order = list(range(len(found["vertices"])))
        random.shuffle(order)
        new = {old: k for k, old in enumerate(order)}
        faces = [[new[k] for k in face[1:] + face[:1]] for face in found["faces"]]
        random.shuffle(faces)
        return {"vertices": [found["vertices"][k] for k in order], "faces": faces}


class CollinearInSpace(Space):
    """Adds a vertex in the middle of each edge."""

    def form(self, shells: list[Shell]) -> Answer:
        return super().form([with_middles(shell) for shell in shells])


def with_middles(shell: Shell) -> Shell:
    points = list(shell[0])
    middle: dict[tuple[int, int], int] = {}
    faces = []
    for face in shell[1]:
        ring = []
        for a, b in zip(face, face[1:] + face[:1], strict=True):
            side = (min(a, b), max(a, b))
            if side not in middle:
                middle[side] = len(points)
                ends = zip(points[a], points[b], strict=True)
                points.append(tuple((x + y) / 2 for x, y in ends))
            ring += [a, middle[side]]
        faces.append(ring)
    return points, faces


class OddSpellingsInSpace(Space):
    """Unreduced fractions, JSON integers, a negative zero."""

    def number(self, value: Fraction) -> Any:
        if value == 0:
            return random.choice([0, "-0", "0/7"])
        return (
            value.numerator
            if value.denominator == 1
            else f"{value.numerator * 6}/{value.denominator * 6}"
        )


class RoundedInSpace(DoublesInSpace):
    """Triangles with nearest doubles as coordinates."""


class UpdatesInSpace(UpdatingInSpace):
    """Steps from scaling to scaling."""


class ConvexByPoints(Space):
    """Convex bodies only, with points and segments."""

    declares: ClassVar[dict[str, Any]] = {
        "capabilities": ["space", "point", "segment", "rational", "non-uniform"]
    }


class UniformOnly(Space):
    """Declares no scales of three numbers."""

    declares: ClassVar[dict[str, Any]] = {
        "capabilities": [one for one in ALL if one != "non-uniform"]
    }


class RejectsInSpace(Space):
    """Invalid meshes are rejected."""

    declares: ClassVar[dict[str, Any]] = {"capabilities": [*ALL, "rejects-invalid"]}

    def load(self, request: Request) -> Answer:
        for operand in (request["P"], request["Q"]):
            try:
                points, faces = shell_of(operand)
                if faces:
                    texts = [tuple(str(c) for c in point) for point in points]
                    _core.Polyhedron(texts, faces).validate()
            except (BadInput, ValueError, KeyError, TypeError, ZeroDivisionError) as refusal:
                raise Rejected(str(refusal)) from refusal
        return super().load(request)


class PlaneAndSpace(Space):
    """Both dimensions, by one adapter."""

    declares: ClassVar[dict[str, Any]] = {"capabilities": ["plane", *ALL]}

    def load(self, request: Request) -> Answer:
        self.dimension = request["dimension"]
        self.flat = Plane()
        self.flat.load(request)
        return super().load(request)

    def at(self, request: Request) -> Answer:
        return self.flat.at(request) if self.dimension == 2 else super().at(request)


class UnusedInside(Space):
    """Adds a vertex inside the sum that no face names, and repeats another vertex."""

    def form(self, shells: list[Shell]) -> Answer:
        found = super().form(shells)
        if found["faces"]:
            points = shells[0][0]
            middle = [str(sum(p[axis] for p in points) / len(points)) for axis in range(3)]
            found["vertices"] += [middle, found["vertices"][0]]
        return found


class ScalesItselfInSpace(Space):
    """Takes P and the scale, a text or a list of three, and leaves sP alone."""

    def shells(self, request: Request) -> list[Shell]:
        by = [Fraction(s) for s in scaling_of(request)]
        points, faces = shell_of(self.P)
        scaled = [tuple(c * s for c, s in zip(p, by, strict=True)) for p in points]
        return sum_in_space((scaled, faces), shell_of(self.Q))


class VerticesOnEdges(Space):
    """Every other face has a vertex in the middle of its edges, whatever its neighbours have."""

    def form(self, shells: list[Shell]) -> Answer:
        return super().form([half_subdivided(shell) for shell in shells])


def half_subdivided(shell: Shell) -> Shell:
    points, faces = with_middles(shell)
    pairs = zip(shell[1], faces, strict=True)
    return points, [pair[k % 2] for k, pair in enumerate(pairs)]
