"""Faulty adapters in space: sums."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from conversation import Answer, Request
from face_pieces import convex_faces
from space_adapter import Space, in_triangles, scaling_of
from space_blocks import prism
from space_sets import Shell, dot, hull, is_convex, normal_of, parts_of, shell_of
from space_sums import sum_in_space


class FaultyInSpace(Space):
    """Has the operands of a request and the exact sum at hand."""

    def shells(self, request: Request) -> list[Shell]:
        P, Q = shell_of(request["sP"]), shell_of(self.Q)
        return self.spoilt(P, Q)

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        raise NotImplementedError


class ThirdFactorIgnored(FaultyInSpace):
    """Takes the second factor twice in a scale of three numbers."""

    def shells(self, request: Request) -> list[Shell]:
        _, y, z = (Fraction(s) for s in scaling_of(request))
        points, faces = shell_of(request["sP"])
        return self.spoilt(([(a, b, c / z * y) for a, b, c in points], faces), shell_of(self.Q))

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        return sum_in_space(P, Q)


class FaceMissing(FaultyInSpace):
    """Drops the last face of a sum of more than forty."""

    def form(self, shells: list[Shell]) -> Answer:
        found = super().form(shells)
        if len(found["faces"]) > 40:
            found["faces"].pop()
        return found

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        return sum_in_space(P, Q)


class NormalsInwards(Space):
    """All faces run clockwise seen from outside."""

    def form(self, shells: list[Shell]) -> Answer:
        return super().form([(points, [f[::-1] for f in faces]) for points, faces in shells])


class OneFaceTurned(Space):
    """Turns a triangle if the sum has more than thirty."""

    def form(self, shells: list[Shell]) -> Answer:
        found = super().form([in_triangles(shell) for shell in shells])
        if len(found["faces"]) > 30:
            found["faces"][7].reverse()
        return found


class CavitiesFilled(FaultyInSpace):
    """Fills the operands' cavities."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        return sum_in_space(outer_shells(P), outer_shells(Q))


def outer_shells(shell: Shell) -> Shell:
    points, faces = shell
    kept = list(faces)
    for part in parts_of(shell):
        own = [face for face in faces if face[0] in part]
        volume = sum(dot(normal_of([points[k] for k in face]), points[face[0]]) for face in own)
        if volume < 0:
            kept = [face for face in kept if face not in own]
    return points, kept


class SecondShellLost(FaultyInSpace):
    """Takes only the first shell of an operand."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        return sum_in_space(first_shell(P), first_shell(Q))


def first_shell(shell: Shell) -> Shell:
    parts = parts_of(shell)
    return shell if len(parts) < 2 else (shell[0], [f for f in shell[1] if f[0] in parts[0]])


class SecondBodyLost(FaultyInSpace):
    """Loses the last body of an operand with several bodies, none inside another."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        return sum_in_space(without_last_body(P), without_last_body(Q))


def without_last_body(shell: Shell) -> Shell:
    parts = parts_of(shell)
    if len(parts) < 2 or outer_shells(shell) != shell:
        return shell
    return shell[0], [face for face in shell[1] if face[0] not in parts[-1]]


class HullInSpace(FaultyInSpace):
    """Answers the hull instead of the sum if an operand is not convex."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        found = sum_in_space(P, Q)
        if not found or not (P[1] and Q[1]) or (is_convex(P) and is_convex(Q)):
            return found
        whole = hull(p for points, _ in found for p in points)
        return [whole] if whole else []


class TunnelsClosed(FaultyInSpace):
    """Takes a frame for the box around it."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        return sum_in_space(closed(P), closed(Q))


def closed(shell: Shell) -> Shell:
    points, faces = shell
    sides = sum(len(face) for face in faces) / 2
    used = {k for face in faces for k in face}
    if not faces or len(parts_of(shell)) > 1 or len(used) - sides + len(faces) >= 2:
        return shell
    low, high = ([f(points[k][axis] for k in used) for axis in range(3)] for f in (min, max))
    ring = [
        (x, y)
        for x, y in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))
    ]
    return prism(ring, low[2], high[2], 2)


class VertexOffInSpace(Space):
    """Moves a sum's vertex by 2^-40."""

    def form(self, shells: list[Shell]) -> Answer:
        shells = [in_triangles(shell) for shell in shells]
        if shells:
            points = list(shells[0][0])
            points[0] = (points[0][0] - Fraction(1, 2**40), *points[0][1:])
            shells[0] = (points, shells[0][1])
        return super().form(shells)


class ParallelFacetsLost(FaultyInSpace):
    """Cuts a corner of the sum of convex bodies with parallel facets."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        found = sum_in_space(P, Q)
        if not (P[1] and Q[1] and is_convex(P) and is_convex(Q)):
            return found
        ways = [{unit(normal_of(face)) for face in convex_faces(one)} for one in (P, Q)]
        return corner_cut(found) if ways[0] & ways[1] else found


def unit(n: Any) -> Any:
    size = sum(abs(c) for c in n)
    return tuple(c / size for c in n)


def corner_cut(found: list[Shell]) -> list[Shell]:
    if not found:
        return found
    used = sorted({found[0][0][k] for face in found[0][1] for k in face})
    cut = hull(used[1:])
    return [cut] if cut else found


class WrongAbove60InSpace(FaultyInSpace):
    """Cuts a corner of convex sums with more than sixty vertices."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        found = sum_in_space(P, Q)
        convex = P[1] and Q[1] and is_convex(P) and is_convex(Q)
        return corner_cut(found) if convex and len(found[0][0]) > 60 else found


class DoublesUnsaid(Space):
    """Says exact and rounds to doubles."""

    def form(self, shells: list[Shell]) -> Answer:
        return super().form([in_triangles(shell) for shell in shells])

    def number(self, value: Fraction) -> Any:
        return str(Fraction(float(value)))


class PointInSpaceForgotten(FaultyInSpace):
    """A point as an operand is not added."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        for one, other in ((P, Q), (Q, P)):
            if len(one[0]) == 1 and other[1]:
                return [other]
        return sum_in_space(P, Q)


class SegmentInSpaceAsItsEnd(FaultyInSpace):
    """Takes a segment for its first end."""

    def spoilt(self, P: Shell, Q: Shell) -> list[Shell]:
        return sum_in_space(*((one[0][:1], []) if not one[1] else one for one in (P, Q)))
