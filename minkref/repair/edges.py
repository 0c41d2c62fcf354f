"""Faces around edges, paired into sheets."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from minkref.errors import Refusal
from minkref.repair.change import Change
from minkref.repair.faces import Mesh, Note, cross, dot, edges_of, minus
from minkref.repair.groups import Groups

Sides = dict[frozenset[int], list[int]]
MOST_NAMED = 6  # vertices of an open boundary


def sides_of(mesh: Mesh) -> Sides:
    """The faces at each edge."""
    sides: Sides = {}
    for k, face in enumerate(mesh.faces):
        for edge in edges_of(face):
            sides.setdefault(frozenset(edge), []).append(k)
    return sides


def refuse_open(mesh: Mesh, sides: Sides, source: str) -> None:
    """Refuse a surface with an edge of an odd number of faces; name the boundary there."""
    ends: dict[int, list[int]] = {}
    count = 0
    for edge, faces in sides.items():
        if len(faces) % 2:
            count += 1
            a, b = sorted(edge)
            ends.setdefault(a, []).append(b)
            ends.setdefault(b, []).append(a)
    if not count:
        return
    first = min(ends)
    loop, at = [first], min(ends[first])
    while at != first and at not in loop[1:]:
        loop.append(at)
        at = next((v for v in sorted(ends[at]) if v != loop[-2]), first)
    named = ", ".join(f"{v} ({', '.join(map(str, mesh.points[v]))})" for v in loop[:MOST_NAMED])
    more = f" and {len(loop) - MOST_NAMED} more" if len(loop) > MOST_NAMED else ""
    raise Refusal(
        f"the surface is open: {count:,} edges have an odd number of faces; a part of its boundary "
        f"runs through vertices {named}{more}",
        source,
        "add the faces that are missing, or weld vertices nearer than a distance: --weld T",
        "open-mesh",
    )


def agree(mesh: Mesh, sides: Sides, note: Note) -> list[int]:
    """Turn faces until both faces at an edge run along opposite ways: the minority within each
    part connected over such edges. Return the part of each face."""
    part = [-1] * len(mesh.faces)
    parts = 0
    for start in range(len(mesh.faces)):
        if part[start] >= 0:
            continue
        part[start] = parts
        turned = {start: False}
        asked = [start]
        while asked:
            k = asked.pop()
            for edge in edges_of(mesh.faces[k]):
                for other in _other_of_two(sides[frozenset(edge)], k):
                    if other not in turned:
                        same = edge in edges_of(mesh.faces[other])
                        turned[other] = turned[k] != same
                        part[other] = parts
                        asked.append(other)
        wrong = sorted(k for k, is_turned in turned.items() if is_turned)
        if 2 * len(wrong) > len(turned):
            wrong = sorted(turned.keys() - wrong)
        for k in wrong:
            note(
                Change(
                    "turned-face", face=mesh.numbers[k],
                    squared_area=mesh.squared_area(mesh.faces[k]),
                )
            )  # fmt: skip
            mesh.faces[k] = mesh.faces[k][::-1]
        parts += 1
    return part


def _other_of_two(faces: list[int], k: int) -> list[int]:
    return [other for other in faces if other != k] if len(faces) == 2 else []


def separate(mesh: Mesh, note: Note) -> None:
    """Give each sheet its own vertices. At an edge of more than two faces, pair faces with material
    between them. Leaves faces unpaired that do not alternate."""
    sides = sides_of(mesh)
    corner: dict[tuple[int, int], int] = {}  # of a face and a vertex
    for k, face in enumerate(mesh.faces):
        for vertex in face:
            corner.setdefault((k, vertex), len(corner))
    groups = Groups(len(corner))
    for edge, faces in sides.items():
        u, v = sorted(edge)
        for one, other in _pairs(mesh, u, v, faces):
            groups.join(corner[one, u], corner[other, u])
            groups.join(corner[one, v], corner[other, v])
    name: dict[tuple[int, int], int] = {}  # of a vertex and a sheet
    taken: set[int] = set()
    for k, face in enumerate(mesh.faces):
        for at, vertex in enumerate(face):
            sheet = vertex, groups.root(corner[k, vertex])
            if sheet not in name:
                name[sheet] = vertex
                if vertex in taken:
                    name[sheet] = len(mesh.points)
                    note(
                        Change(
                            "split-vertex", vertex=vertex, other_vertex=len(mesh.points),
                            point=mesh.points[vertex],
                        )
                    )  # fmt: skip
                    mesh.points.append(mesh.points[vertex])
                    mesh.integers.append(mesh.integers[vertex])
                taken.add(vertex)
            face[at] = name[sheet]


def _pairs(mesh: Mesh, u: int, v: int, faces: list[int]) -> Iterable[tuple[int, int]]:
    """Pair the faces at an edge."""
    if len(faces) == 2:
        return [(faces[0], faces[1])]
    along = [(v, u) in edges_of(mesh.faces[k]) for k in faces]
    if 2 * sum(along) != len(faces):
        return []
    order = _around(mesh, u, v, faces)
    # About the edge from u to v, counter-clockwise: a face that runs from v to u has the outside
    # before it and the material behind, up to the next face, which runs from u to v.
    found = []
    for at, k in enumerate(order):
        after = order[(at + 1) % len(order)]
        runs_back = along[faces.index(k)]
        if runs_back == along[faces.index(after)]:
            return []
        if runs_back:
            found.append((k, after))
    return found


def _around(mesh: Mesh, u: int, v: int, faces: list[int]) -> list[int]:
    """Sort faces counter-clockwise about the edge from u to v, seen from the end of the edge."""
    axis = minus(mesh.integers[v], mesh.integers[u])
    arms = {}
    for k in faces:
        face = mesh.faces[k]
        sign = 1 if (u, v) in edges_of(face) else -1
        inward = cross(mesh.normal(face), axis)  # left of an edge from u to v, seen from outside
        arms[k] = (sign * inward[0], sign * inward[1], sign * inward[2])
    first = arms[faces[0]]
    side = cross(axis, first)

    def angle(k: int) -> tuple[int, Fraction]:
        x, y = dot(first, arms[k]), dot(side, arms[k])
        # The cotangent falls within each half turn; of equal units: side is as long as the axis.
        if y == 0:
            return (0, Fraction(0)) if x > 0 else (2, Fraction(0))
        return (1 if y > 0 else 3), Fraction(-x, y)

    return sorted(faces, key=angle)
