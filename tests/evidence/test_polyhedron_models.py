"""The shipped polyhedra: exactly convex, with their stated sizes, on the surfaces and with the
symmetries that minkref/models/README.md claims. Checked with plain integers, from the files'
bytes."""

from __future__ import annotations

import itertools
import json
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.hull import convex_hull

MODELS = Path(__file__).resolve().parents[2] / "minkref" / "models"
INDEX = json.loads((MODELS / "index.json").read_text(encoding="ascii"))["polyhedra"]
STATED = {  # vertices, facets, triangles: the paper's Fig. 10 counts triangles
    "ellipsoid": (482, 960, 960),
    "gs3": (162, 320, 320),
    "gs4": (252, 500, 500),
    "ti": (120, 236, 236),
    "rod": (164, 84, 324),
}
Point = tuple[int, ...]
Face = tuple[int, ...]


def read_off(name: str) -> tuple[list[Point], list[Face]]:
    lines = (MODELS / f"{name}.off").read_text(encoding="ascii").splitlines()
    assert lines[0] == "OFF"
    lines = [line for line in lines[1:] if not line.startswith("#")]
    vertices, facets, edges = map(int, lines[0].split())
    assert len(lines) == 1 + vertices + facets
    points = [tuple(map(int, line.split())) for line in lines[1 : 1 + vertices]]
    faces = []
    for line in lines[1 + vertices :]:
        count, *face = map(int, line.split())
        assert count == len(face) >= 3
        faces.append(tuple(face))
    assert sum(map(len, faces)) == 2 * edges
    assert {len(point) for point in points} == {3}
    return points, faces


def steps(face: Face) -> Iterator[tuple[int, int]]:
    return zip(face, face[1:] + face[:1], strict=True)


def determinant(u: Point, v: Point, w: Point) -> int:
    return (
        u[0] * (v[1] * w[2] - v[2] * w[1])
        + u[1] * (v[2] * w[0] - v[0] * w[2])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
    )


def minus(a: Point, b: Point) -> Point:
    return tuple(x - y for x, y in zip(a, b, strict=True))


def test_index_lists_every_polyhedron_with_its_size() -> None:
    assert {e["name"]: (e["vertices"], e["facets"]) for e in INDEX} == {
        name: size[:2] for name, size in STATED.items()
    }


@pytest.mark.parametrize("name", STATED)
def test_counts_are_those_stated_and_the_surface_is_a_closed_sphere(name: str) -> None:
    points, faces = read_off(name)
    triangles = sum(len(face) - 2 for face in faces)
    assert (len(points), len(faces), triangles) == STATED[name]
    assert len(set(points)) == len(points)
    edges = [edge for face in faces for edge in steps(face)]
    assert len(set(edges)) == len(edges)
    assert {(j, i) for i, j in edges} == set(edges)
    assert {i for i, _ in edges} == set(range(len(points)))
    assert len(points) - len(edges) // 2 + len(faces) == 2
    assert Polyhedron(tuple(points), tuple(faces)).fault() is None  # type: ignore[arg-type]


@pytest.mark.parametrize("name", STATED)
def test_each_vertex_is_below_the_plane_of_each_facet_or_is_its_corner(name: str) -> None:
    """Every corner of a facet turns left seen from outside: strictly convex, no straight angle."""
    points, faces = read_off(name)
    for face in faces:
        a, b, c = (points[k] for k in face[:3])
        u, v = minus(b, a), minus(c, a)
        normal = tuple(u[k - 2] * v[k - 1] - u[k - 1] * v[k - 2] for k in range(3))
        offset = sum(n * x for n, x in zip(normal, a, strict=True))
        heights = [normal[0] * x + normal[1] * y + normal[2] * z - offset for x, y, z in points]
        assert max(heights) == 0
        assert {k for k, height in enumerate(heights) if height == 0} == set(face)
        for (i, j), (_, k) in zip(steps(face), steps(face[1:] + face[:1]), strict=True):
            edge, onward = minus(points[j], points[i]), minus(points[k], points[j])
            assert determinant(edge, onward, normal) > 0


@pytest.mark.parametrize("name", STATED)
def test_facets_are_those_of_the_hull_by_other_means(name: str) -> None:
    points, faces = read_off(name)
    hull = convex_hull(points)  # type: ignore[arg-type]
    assert list(hull.vertices) == points
    assert list(hull.faces) == faces


@pytest.mark.parametrize(
    ("name", "stretch"),
    [("gs3", (1, 1, 1)), ("gs4", (1, 1, 1)), ("ti", (1, 1, 1)), ("ellipsoid", (3, 2, 1))],
)
def test_vertices_are_on_the_sphere_or_the_stretched_one(name: str, stretch: Point) -> None:
    for point in read_off(name)[0]:
        assert all(value % factor == 0 for value, factor in zip(point, stretch, strict=True))
        assert sum((v // f) ** 2 for v, f in zip(point, stretch, strict=True)) == 96135**2


def test_rod_is_a_slender_prism_over_a_polygon_on_a_circle() -> None:
    points, faces = read_off("rod")
    assert {x * x + y * y for x, y, _ in points} == {32045**2}
    assert {z for _, _, z in points} == {-320450, 320450}
    assert sorted(map(len, faces)) == [4] * 82 + [82] * 2


@pytest.mark.parametrize(
    ("name", "signs", "exchange"),
    [
        ("ellipsoid", "all", False),
        ("gs3", "all", True),
        ("gs4", "all", True),
        ("rod", "all", False),
        ("ti", "even", True),
    ],
)
def test_symmetries_are_exact(name: str, signs: str, exchange: bool) -> None:
    points, faces = read_off(name)
    corners = {frozenset(points[k] for k in face) for face in faces}
    maps = [
        lambda p, s=s: tuple(a * b for a, b in zip(p, s, strict=True))
        for s in itertools.product((1, -1), repeat=3)
        if signs == "all" or s.count(-1) % 2 == 0
    ]
    if exchange:
        maps.append(lambda p: p[1:] + p[:1])
    for mapped in maps:
        assert {frozenset(mapped(p) for p in face) for face in corners} == corners


def test_solids_that_are_not_convex_are_refused_by_the_generator() -> None:
    """The generator's own check: a dent, a facet in two pieces, a hole, and four points of a
    sphere in a plane."""
    sys.path.insert(0, str(MODELS))
    try:
        from solids import flaws  # type: ignore[import-not-found]
        from sphere import facets  # type: ignore[import-not-found]
    finally:
        sys.path.remove(str(MODELS))
    corners = [(2, 0, 0), (0, 2, 0), (-2, 0, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2)]
    faces: list[Face] = []
    for k in range(4):
        faces += [(k, (k + 1) % 4, 4), ((k + 1) % 4, k, 5)]
    assert flaws((corners, faces)) == []
    assert {frozenset(face) for face in facets(corners)} == {frozenset(face) for face in faces}
    assert any("above" in flaw for flaw in flaws(([*corners[:5], (0, 0, 1)], faces)))
    assert any("close" in flaw for flaw in flaws((corners, faces[1:])))
    assert any("on no face" in flaw for flaw in flaws(([*corners, (0, 0, 0)], faces)))
    flat = [(2, 2, 0), (-2, 2, 0), (-2, -2, 0), (2, -2, 0), (0, 0, 2)]
    cut = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (2, 1, 0), (3, 2, 0)]
    assert any("other vertices" in flaw for flaw in flaws((flat, cut)))
    with pytest.raises(ValueError, match="fourth vertex"):
        facets([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
