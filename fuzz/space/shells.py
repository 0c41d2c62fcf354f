"""The closed pieces that a surface falls into."""

from __future__ import annotations

from minkref.fuzz.geometry.parts import Parts
from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Whole
from minkref.fuzz.space.closedness import open_stretch

Faces = tuple[Face, ...]


def shells_of(surface: Polyhedron) -> list[Faces]:
    """Groups of faces connected by their vertices' names, if the groups close; edges along the same
    points connect other faces, each edge with the last earlier face that runs along the edge the
    other way. All faces that still do not close form one piece."""
    groups: dict[int, list[Face]] = {}
    for face, name in zip(surface.faces, surface.shells, strict=True):
        groups.setdefault(name, []).append(face)
    closed, rest = _parted(surface, list(groups.values()))
    pieces, left = _parted(surface, _by_edges(surface, rest))
    return [*closed, *pieces, *((tuple(left),) if left else ())]


def _parted(surface: Polyhedron, groups: list[list[Face]]) -> tuple[list[Faces], list[Face]]:
    closed, rest = [], []
    for group in groups:
        if open_stretch(surface.wholes, group) is None:
            closed.append(tuple(group))
        else:
            rest += group
    return closed, rest


def _by_edges(surface: Polyhedron, faces: list[Face]) -> list[list[Face]]:
    points = surface.wholes
    parts = Parts(len(faces))
    waiting: dict[tuple[Whole, Whole], list[int]] = {}
    for number, face in enumerate(faces):
        for i, j in zip(face, face[1:] + face[:1], strict=True):
            a, b = points[i], points[j]
            if opposite := waiting.get((b, a)):
                parts.join(number, opposite.pop())
            else:
                waiting.setdefault((a, b), []).append(number)
    groups: dict[int, list[Face]] = {}
    for number, face in enumerate(faces):
        groups.setdefault(parts.of(number), []).append(face)
    return list(groups.values())
