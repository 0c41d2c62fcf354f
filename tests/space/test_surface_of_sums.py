"""The boundary of a sum in space, through Python: shells, meshes, areas, parents."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from itertools import pairwise

import pytest
from minkref import BadInput, _core
from minkref.fuzz.space.cells import surface_of

ONE = ("1", "1", "1")
Cell = tuple[int, int, int]


def solid(cells: set[Cell]) -> _core.Polyhedron:
    surface = surface_of(frozenset(cells))
    return _core.Polyhedron(
        [tuple(str(c) for c in vertex) for vertex in surface.vertices],
        [list(face) for face in surface.faces],
    )


def block(x: int, y: int, z: int) -> set[Cell]:
    return {(i, j, k) for i in range(x) for j in range(y) for k in range(z)}


FRAME = block(5, 5, 1) - {(i, j, 0) for i in (1, 2, 3) for j in (1, 2, 3)}
CUBE = solid(block(1, 1, 1))


def sums(P: _core.Polyhedron, Q: _core.Polyhedron, scale: str) -> _core.PolyhedralSet:
    edges = _core.edge_sum_in_space(P, Q, (scale,) * 3)
    assert edges == _core.definition_sum_in_space(P, Q, (scale,) * 3)
    return edges


def assert_closed(mesh: _core.Polyhedron) -> None:
    runs: Counter[tuple[int, int]] = Counter()
    for ring in mesh.rings():
        for a, b in pairwise([*ring, ring[0]]):
            runs[min(a, b), max(a, b)] += 1 if a < b else -1
    assert runs
    assert not any(runs.values())


@pytest.mark.parametrize(
    ("scale", "tunnels"), [("1/4", 0), ("1/3", 0), ("1/2", 1), ("1", 1), ("7/3", 1)]
)
def test_the_hole_of_a_frame_closes(scale: str, tunnels: int) -> None:
    found = sums(solid(FRAME), CUBE, scale)
    assert found.topology() == {"components": 1, "cavities": 0, "tunnels": tunnels}
    ((volume, characteristic, *_),) = found.shells()
    assert volume == found.volume
    assert characteristic == 2 - 2 * tunnels
    s = Fraction(scale)
    assert found.projected_areas()[2] == 2 * ((5 * s + 1) ** 2 - max(3 * s - 1, Fraction(0)) ** 2)


def test_the_cavity_of_a_shell() -> None:
    found = sums(solid(block(3, 3, 3) - {(1, 1, 1)}), CUBE, "2")
    assert found.topology() == {"components": 1, "cavities": 1, "tunnels": 0}
    assert sorted(Fraction(row[0]) for row in found.shells("outside")) == [-1, 343]
    with pytest.raises(BadInput, match="give interior or outside"):
        found.shells("inside")


def test_meshes_give_the_set_back() -> None:
    found = sums(solid(FRAME), solid({(0, 0, 0), (1, 0, 0), (1, 1, 0)}), "3/7")
    for kind in ("polygons", "triangles"):
        mesh = found.mesh(kind)
        assert_closed(mesh)
        mesh.validate()
        assert _core.polyhedral_set(mesh) == found
    assert all(len(ring) == 3 for ring in found.mesh("triangles").rings())
    with pytest.raises(BadInput, match="give polygons or triangles"):
        found.mesh("quads")


def test_what_rounding_does_is_told() -> None:
    exact = sums(CUBE, CUBE, "1/3").mesh("triangles")
    rounded, report = _core.rounded_mesh(exact, "float32")
    assert rounded.rings() == exact.rings()
    error = Fraction(4, 3) - Fraction(
        float(_core.rounded_mesh(exact)[0].approximate_points()[-1][0])
    )
    assert report["moved_vertices"] == 7
    assert report["merged_vertices"] == report["degenerate_faces"] == report["turned_faces"] == 0
    assert abs(error) < Fraction(report["largest_displacement"]) < Fraction(1, 2**23)
    assert _core.rounded_mesh(exact)[1]["largest_displacement"] == str(abs(error))
    with pytest.raises(BadInput, match="give float64 or float32"):
        _core.rounded_mesh(exact, "float16")


def test_parents_of_a_sum_of_cubes() -> None:
    boundary = _core.edge_sum_in_space(CUBE, CUBE, ONE).surface()
    parents = boundary.parents(CUBE, CUBE, ONE)
    assert len(parents) == boundary.facets == 6
    # A face of each cube at the other's corners, and edge parallelograms beside them.
    faces = {tuple(ring) for ring in CUBE.rings()}
    for pairs in parents:
        assert {(min(len(p), 3), min(len(q), 3)) for p, q in pairs} >= {(3, 1), (1, 3)}
        assert {min(len(p), 3) + min(len(q), 3) for p, q in pairs} == {4}
        for k in (0, 1):
            (face,) = {tuple(pair[k]) for pair in pairs if len(pair[k]) > 2}
            assert face in faces
            assert {v for pair in pairs for v in pair[k]} == set(face)
