"""Single faces: equal vertices, zero area, missing planes, copies."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from math import lcm

from minkref.repair.change import Change
from minkref.repair.ears import ears
from minkref.repair.weld import squared_distance, welded

Vector = tuple[Fraction, ...]
IntegerVector = tuple[int, int, int]
Note = Callable[[Change], None]


@dataclass
class Mesh:
    """Vertices and faces. `numbers`: numbers of faces in the file, None for faces made by the
    repair. `integers`: vertices over a common denominator, for signs."""

    points: list[Vector]
    faces: list[list[int]]
    numbers: list[int | None] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.numbers = self.numbers or list(range(len(self.faces)))
        self.denominator = lcm(*(x.denominator for point in self.points for x in point))
        self.integers: list[IntegerVector] = []
        for point in self.points:
            x, y, z = (
                number.numerator * (self.denominator // number.denominator) for number in point
            )
            self.integers.append((x, y, z))

    def normal(self, face: Sequence[int]) -> IntegerVector:
        """Twice the area vector of a face, of the integer vertices."""
        origin = self.integers[face[0]]
        total = (0, 0, 0)
        for a, b in pairwise(face[1:]):
            part = cross(minus(self.integers[a], origin), minus(self.integers[b], origin))
            total = (total[0] + part[0], total[1] + part[1], total[2] + part[2])
        return total

    def squared_area(self, face: Sequence[int]) -> Fraction:
        normal = self.normal(face)
        return Fraction(dot(normal, normal), 4 * self.denominator**4)

    def keep(self, stays: Sequence[bool]) -> None:
        """Keep the faces with True."""
        self.faces = [face for face, stay in zip(self.faces, stays, strict=True) if stay]
        self.numbers = [n for n, stay in zip(self.numbers, stays, strict=True) if stay]


def minus(a: IntegerVector, b: IntegerVector) -> IntegerVector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def cross(a: IntegerVector, b: IntegerVector) -> IntegerVector:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a: IntegerVector, b: IntegerVector) -> int:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def edges_of(face: Sequence[int]) -> list[tuple[int, int]]:
    return [(face[k - 1], face[k]) for k in range(len(face))]


def join_vertices(mesh: Mesh, moves: dict[Vector, Vector], note: Note) -> None:
    """Make vertices with equal coordinates one, the first, after the moves of welding."""
    first: dict[Vector, int] = {}
    name = list(range(len(mesh.points)))
    for vertex, point in enumerate(mesh.points):
        if point not in moves:
            first.setdefault(point, vertex)
    for vertex, point in enumerate(mesh.points):
        to = moves.get(point, point)
        name[vertex] = first[to]
        if name[vertex] != vertex:
            note(
                Change(
                    "joined", vertex=vertex, other_vertex=name[vertex], point=point, to=to,
                    squared_distance=squared_distance(point, to),
                )
            )  # fmt: skip
    mesh.faces = [[name[vertex] for vertex in face] for face in mesh.faces]


def moves_of(points: Sequence[Vector], weld: Fraction | None) -> dict[Vector, Vector]:
    return {} if weld is None else welded(points, weld)


def drop_repeated(mesh: Mesh, note: Note) -> None:
    """Drop vertices at which a face stands still or turns back along an edge; drop faces of fewer
    than three vertices."""
    stays = []
    for k, face in enumerate(mesh.faces):
        at = 0
        while len(face) >= 3 and at < len(face):
            if face[at] == face[at - 1]:
                gone = [at]
            elif face[at - 2] == face[at]:  # a b a: there and back
                gone = [at, at - 1]
            else:
                at += 1
                continue
            for each in gone:
                note(Change("repeated-vertex", face=mesh.numbers[k], vertex=face[each]))
            left = {each % len(face) for each in gone}
            face = [v for j, v in enumerate(face) if j not in left]
            at = 0
        mesh.faces[k] = face
        stays.append(len(face) >= 3)
        if not stays[-1]:
            note(Change("zero-area", face=mesh.numbers[k], squared_area=Fraction(0)))
    mesh.keep(stays)


def drop_without_area(mesh: Mesh, note: Note) -> None:
    """Drop faces whose vertices lie on a line; a neighbour along a longer edge of such a face gets
    the vertices between the ends of the edge."""
    beside: dict[frozenset[int], list[int]] = {}
    for k, face in enumerate(mesh.faces):
        for edge in edges_of(face):
            beside.setdefault(frozenset(edge), []).append(k)
    stays = [True] * len(mesh.faces)
    for k in range(len(mesh.faces)):
        if any(mesh.normal(mesh.faces[k])) or not _on_a_line(mesh, mesh.faces[k]):
            continue
        stays[k] = False
        note(Change("zero-area", face=mesh.numbers[k], squared_area=Fraction(0)))
        for a, b in edges_of(mesh.faces[k]):
            between = _between(mesh, a, b, mesh.faces[k])
            others = [j for j in beside.get(frozenset((a, b)), ()) if stays[j]]
            if between and others:
                _insert(mesh, others[0], (a, b), between, beside, note)
    mesh.keep(stays)


def _on_a_line(mesh: Mesh, face: Sequence[int]) -> bool:
    a = mesh.integers[face[0]]
    along = next((d for v in face if any(d := minus(mesh.integers[v], a))), (0, 0, 0))
    return all(not any(cross(along, minus(mesh.integers[v], a))) for v in face)


def _between(mesh: Mesh, a: int, b: int, vertices: Sequence[int]) -> list[int]:
    """The vertices strictly between two others on a line, from the first one on."""
    start, end = mesh.integers[a], mesh.integers[b]
    along = minus(end, start)
    length = dot(along, along)
    places = {v: dot(along, minus(mesh.integers[v], start)) for v in vertices}
    return sorted((v for v, at in places.items() if 0 < at < length), key=lambda v: places[v])


def _insert(
    mesh: Mesh, k: int, ends: tuple[int, int], between: list[int],
    beside: dict[frozenset[int], list[int]], note: Note,
) -> None:  # fmt: skip
    """Put vertices between the ends of a face's edge."""
    face = mesh.faces[k]
    at = next(j for j, edge in enumerate(edges_of(face)) if set(edge) == set(ends))
    run = between if face[at] == ends[1] else between[::-1]
    mesh.faces[k] = [*face[:at], *run, *face[at:]]
    beside[frozenset(ends)].remove(k)
    for edge in zip([ends[0], *between], [*between, ends[1]], strict=True):
        beside.setdefault(frozenset(edge), []).append(k)
    for vertex in between:
        note(Change("edge-split", face=mesh.numbers[k], vertex=vertex, point=mesh.points[vertex]))


def drop_copies(mesh: Mesh, note: Note) -> None:
    """Drop second copies of faces. Drop both copies if they run opposite ways and every edge around
    has an even number of further faces: two bodies abut."""
    stays = [True] * len(mesh.faces)
    first: dict[tuple[int, ...], int] = {}
    for k, face in enumerate(mesh.faces):
        same = first.setdefault(_cycle(face), k)
        if same != k:
            stays[k] = False
            note(_copy("duplicate-face", mesh, k, same))
    counts: dict[frozenset[int], int] = {}
    for k in first.values():
        for edge in edges_of(mesh.faces[k]):
            counts[frozenset(edge)] = counts.get(frozenset(edge), 0) + 1
    for cycle, k in first.items():
        other = first.get(_cycle(cycle[::-1]), k)
        if other >= k:
            continue
        is_wall = all(counts[frozenset(edge)] % 2 == 0 for edge in edges_of(cycle))
        stays[k] = False
        stays[other] = not is_wall
        note(_copy("opposite-face" if is_wall else "duplicate-face", mesh, k, other))
    mesh.keep(stays)


def _copy(kind: str, mesh: Mesh, k: int, other: int) -> Change:
    return Change(
        kind, face=mesh.numbers[k], other_face=mesh.numbers[other],
        squared_area=mesh.squared_area(mesh.faces[k]),
    )  # fmt: skip


def _cycle(face: Sequence[int]) -> tuple[int, ...]:
    first = face.index(min(face))
    return (*face[first:], *face[:first])


def cut_faces_in_no_plane(mesh: Mesh, note: Note) -> None:
    """Cut faces whose vertices lie in no plane into triangles, ears first that come first; a face
    that cannot be cut stays."""
    faces: list[list[int]] = []
    numbers: list[int | None] = []
    for face, number in zip(mesh.faces, mesh.numbers, strict=True):
        apart = _distance_from_plane(mesh, face)
        cut = ears(mesh.integers, face, mesh.normal(face)) if apart else None
        if cut is None:
            faces.append(face)
            numbers.append(number)
            continue
        note(Change("triangulated", face=number, squared_distance=apart))
        faces += cut
        numbers += [number] * len(cut)
    mesh.faces, mesh.numbers = faces, numbers


def _distance_from_plane(mesh: Mesh, face: Sequence[int]) -> Fraction:
    """The largest squared distance of a vertex from the plane through the first vertex across the
    face's area vector; 0 for a face in a plane."""
    if len(face) == 3:
        return Fraction(0)
    normal = mesh.normal(face)
    first = mesh.integers[face[0]]
    most = max(abs(dot(normal, minus(mesh.integers[v], first))) for v in face)
    return Fraction(most**2, dot(normal, normal) * mesh.denominator**2) if most else Fraction(0)
