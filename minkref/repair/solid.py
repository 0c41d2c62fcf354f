"""Repair of a polyhedron: vertices, faces, edges, shells."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from minkref import _core
from minkref.errors import Refusal, refusal_of
from minkref.repair.change import Change, Vector
from minkref.repair.edges import agree, refuse_open, separate, sides_of
from minkref.repair.faces import (
    Mesh,
    Note,
    cut_faces_in_no_plane,
    drop_copies,
    drop_repeated,
    drop_without_area,
    join_vertices,
    moves_of,
)
from minkref.repair.shells import face_outwards, shells_of


def repaired_solid(
    read: _core.Polyhedron, rule: str, weld: Fraction | None, source: str
) -> tuple[_core.Polyhedron, list[Change]]:
    """Repair a polyhedron as read, and list the changes in order. A polyhedron without faults, or
    with fewer than two faces, stays unchanged. Exact. Refuses open surfaces, naming the boundary,
    and surfaces with remaining faults, like self-crossings."""
    points: list[Vector] = [*read.points()]
    moves = moves_of(points, weld)
    if read.faces < 2 or (not moves and _is_valid(read)):
        return read, []
    changes: list[Change] = []
    note = changes.append
    mesh = Mesh(points, [list(face) for face in read.rings()])
    unused = set(range(len(points))).difference(*read.rings())
    join_vertices(mesh, moves, note)
    drop_repeated(mesh, note)
    drop_without_area(mesh, note)
    drop_copies(mesh, note)
    cut_faces_in_no_plane(mesh, note)
    sides = sides_of(mesh)
    refuse_open(mesh, sides, source)
    part = agree(mesh, sides, note)
    face_outwards(mesh, shells_of(mesh, part), rule, note)
    separate(mesh, note)
    found = _without_unused(mesh, sorted(unused), note)
    _refuse_others(found, source)
    return found, changes


def _is_valid(surface: _core.Polyhedron) -> bool:
    try:
        surface.validate()
    except _core.BadInput:
        return False
    return True


def _without_unused(mesh: Mesh, unused: Sequence[int], note: Note) -> _core.Polyhedron:
    for vertex in unused:
        note(Change("unused-vertex", vertex=vertex, point=mesh.points[vertex]))
    used = sorted({vertex for face in mesh.faces for vertex in face})
    number = {vertex: k for k, vertex in enumerate(used)}
    points = [tuple(map(str, mesh.points[vertex])) for vertex in used]
    return _core.Polyhedron(points, [[number[vertex] for vertex in face] for face in mesh.faces])


def _refuse_others(found: _core.Polyhedron, source: str) -> None:
    if found.faces == 0:
        mend = "give a surface that encloses a volume"
        raise Refusal("nothing is left that has a volume", source, mend, "nothing-left")
    try:
        found.validate()
    except _core.BadInput as error:
        fault = refusal_of(error, source)
        raise Refusal(
            f"repaired as far as possible, it is refused still: {fault.what}",
            fault.where or source,
            f"faces and vertices are those after the repair; {fault.mend}",
            fault.code,
        ) from error
