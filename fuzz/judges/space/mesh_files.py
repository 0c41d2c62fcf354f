"""Meshes as another program reads them, from the definitions of OFF, OBJ and PLY alone, and their
faults as closed triangle surfaces. Shares no code with our readers and writers."""

from __future__ import annotations

from collections import Counter, defaultdict
from fractions import Fraction
from itertools import pairwise

Point = tuple[Fraction, Fraction, Fraction]
Mesh = tuple[list[Point], list[list[int]]]


def read_as_written(text: str, form: str) -> Mesh:
    """Returns the vertices, with the text's exact numbers, and faces as vertex numbers from 0."""
    rows = [line.split() for line in text.splitlines()]
    if form == "obj":
        points = [_point(row[1:4]) for row in rows if row and row[0] == "v"]
        faces = [[int(word) - 1 for word in row[1:]] for row in rows if row and row[0] == "f"]
        return points, faces
    if form == "off":
        assert rows[0] == ["OFF"]
        count, faces_count, _ = map(int, rows[1])
        body = rows[2:]
    else:
        assert rows[:2] == [["ply"], ["format", "ascii", "1.0"]]
        end = rows.index(["end_header"])
        counts = {row[1]: int(row[2]) for row in rows[:end] if row[0] == "element"}
        count, faces_count = counts["vertex"], counts["face"]
        body = rows[end + 1 :]
    assert len(body) == count + faces_count
    faces = [[int(word) for word in row[1:]] for row in body[count:]]
    assert all(int(row[0]) == len(row) - 1 for row in body[count:])
    return [_point(row) for row in body[:count]], faces


def faults_of(mesh: Mesh) -> list[str]:
    """Faults in words: none for a closed manifold triangle surface with area, tested edge by edge
    and fan by fan on vertex numbers alone."""
    points, faces = mesh
    found = []
    if any(len(face) != 3 for face in faces):
        found.append("a face is no triangle")
    if any(len(set(face)) < len(face) for face in faces):
        found.append("a face has a vertex twice")
    if {v for face in faces for v in face} != set(range(len(points))):
        found.append("a vertex belongs to no face, or a face names none")
        return found
    if any(not any(_area(*(points[v] for v in face[:3]))) for face in faces):
        found.append("a triangle has no area")
    runs = Counter(run for face in faces for run in pairwise((*face, face[0])))
    if any(count > 1 for count in runs.values()):
        found.append("two faces run along an edge the same way")
    if any((b, a) not in runs for a, b in runs):
        found.append("an edge has one face only")
    if not found and any(_fans(links) > 1 for links in _links(faces).values()):
        found.append("the faces at a vertex are more than one fan")
    return found


def sextuple_volume(mesh: Mesh) -> Fraction:
    """Returns six times the enclosed volume, from faces cut into fans."""
    points, faces = mesh
    total = Fraction(0)
    for face in faces:
        a = points[face[0]]
        for v, w in pairwise(face[1:]):
            n = _area((Fraction(0), Fraction(0), Fraction(0)), points[v], points[w])
            total += sum(x * y for x, y in zip(a, n, strict=True))
    return total


def vertices_on_edges(mesh: Mesh) -> int:
    """How many vertices lie strictly inside of an edge. O(n²)."""
    points, faces = mesh
    count = 0
    for a, b in {tuple(sorted(run)) for face in faces for run in pairwise((*face, face[0]))}:
        p, q = points[a], points[b]
        for x in set(points) - {p, q}:
            if any(_area(p, q, x)):
                continue
            along = sum((v - u) * (w - u) for u, v, w in zip(p, q, x, strict=True))
            count += 0 < along < sum((v - u) ** 2 for u, v in zip(p, q, strict=True))
    return count


def _point(words: list[str]) -> Point:
    x, y, z = (Fraction(word) for word in words)
    return x, y, z


def _area(a: Point, b: Point, c: Point) -> Point:
    u, v = ([y - x for x, y in zip(a, p, strict=True)] for p in (b, c))
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def _links(faces: list[list[int]]) -> dict[int, dict[int, int]]:
    """Maps, for each vertex, each neighbour to the next neighbour around the vertex."""
    links: dict[int, dict[int, int]] = defaultdict(dict)
    for face in faces:
        for k, v in enumerate(face):
            links[v][face[(k + 1) % len(face)]] = face[k - 1]
    return links


def _fans(links: dict[int, int]) -> int:
    left, count = dict(links), 0
    while left:
        count += 1
        at = next(iter(left))
        while at in left:
            at = left.pop(at)
    return count
