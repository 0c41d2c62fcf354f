"""Smaller solids from any solid: fewer shells, a convex piece, a contracted edge."""

from __future__ import annotations

from collections.abc import Iterator

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import area_vector, dot
from minkref.fuzz.space.convex_sum import polyhedron_of
from minkref.fuzz.space.exact_sum import core_polyhedron
from minkref.fuzz.space.hull import convex_hull, is_convex
from minkref.fuzz.space.self_crossing import self_crossing

MOST_PIECES = 16


def is_valid(solid: Polyhedron) -> bool:
    """An operand as any target may expect it: it does not cross, cover or touch itself either."""
    if solid.fault() is not None:
        return False
    if solid.is_thin:
        return True
    if self_crossing(solid) is not None:
        return False
    try:
        core_polyhedron(solid).validate()
    except _core.BadInput:
        return False
    return True


def fewer_shells(solid: Polyhedron) -> Iterator[Polyhedron]:
    """Each shell alone, and all but one."""
    shells = solid.shells
    names = sorted(set(shells))
    if len(names) < 2:
        return
    for keep in (True, False):
        for name in names:
            faces = [f for f, s in zip(solid.faces, shells, strict=True) if (s == name) == keep]
            yield Polyhedron(solid.vertices, tuple(faces)).without_unused_vertices()


def convex_parts(solid: Polyhedron) -> Iterator[Polyhedron]:
    """Yields some convex pieces of the solid."""
    if solid.is_thin or is_convex(solid):
        return
    try:
        pieces = _core.convex_pieces(core_polyhedron(solid))
    except (_core.BadInput, RuntimeError):
        return
    for piece in pieces[:MOST_PIECES]:
        yield convex_hull(polyhedron_of(piece).vertices)


def drawn_together(solid: Polyhedron) -> Iterator[Polyhedron]:
    """Contracts each edge, one end to the other. Faces that stop being planar become their
    triangles. The result may cross itself, or no longer close."""
    if solid.is_thin:
        return
    edges = {
        (a, b) for face in solid.faces for a, b in zip(face, (*face[1:], face[0]), strict=True)
    }
    for gone, kept in sorted(edges):
        faces: list[Face] = []
        for face in solid.faces:
            if gone not in face:
                faces.append(face)
                continue
            moved = _moved(face, gone, kept)
            if len(moved) < 3 or _is_planar(solid, moved):
                faces.append(moved)
            else:
                faces += [_moved(triple, gone, kept) for triple in solid.triangles_of(face)]
        left = tuple(face for face in faces if len(face) >= 3)
        yield Polyhedron(solid.vertices, left).without_unused_vertices()


def _moved(face: Face, gone: int, kept: int) -> Face:
    ring = [kept if vertex == gone else vertex for vertex in face]
    return tuple(vertex for k, vertex in enumerate(ring) if vertex != ring[k - 1])


def _is_planar(solid: Polyhedron, face: Face) -> bool:
    ring = [solid.wholes[k] for k in face]
    n = area_vector(ring)
    level = dot(n, ring[0])
    return n != (0, 0, 0) and all(dot(n, point) == level for point in ring)
