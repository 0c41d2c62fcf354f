"""Triangle meshes: every reader accepts them, judged by the file's numbers alone."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref
import pytest
from minkref import _core
from minkref.fuzz.judges.space.mesh_files import (
    faults_of,
    read_as_written,
    sextuple_volume,
    vertices_on_edges,
)
from written_solids import SQUARE, L, cube, frame, hollow_cube, moved, off, prism, together

Minkref = Callable[..., Any]
FORMS = ("off", "obj", "ply")
POINT = off([(0, 0, 0)], [])


def block(x: int, y: int, z: int, side: int = 1) -> str:
    points = [(x + a * side, y + b * side, z + c * side)
              for a in (0, 1) for b in (0, 1) for c in (0, 1)]  # fmt: skip
    rings = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return off(points, rings)


def spaced(cells: set[tuple[int, int, int]]) -> str:
    """Unit cubes at even places: with a unit cube their sum is a polycube, which may touch itself
    along edges and in vertices."""
    return together(*(block(2 * x, 2 * y, 2 * z) for x, y, z in sorted(cells)))


#: Two towers that touch along an edge between two plates: around both of its ends there is one fan.
TOWERS = {(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 2)} | {(0, 0, 1), (1, 1, 1)}
STAR = [(3 * x, 3 * y) for x, y in ((0, 0), (4, 1), (8, 0), (5, 4), (4, 9), (3, 4))]
CASES = {
    "a frame, whose facets have holes": (frame(), cube("1/3")),
    "a facet that is not convex": (prism(STAR), cube("1/7")),
    "a body with a cavity": (hollow_cube(), cube("1/4")),
    "an L, with vertices on edges": (together(prism(L), moved(prism(L), 5)), prism(SQUARE, 2)),
    "along an edge": (spaced({(0, 0, 0), (1, 1, 0)}), cube()),
    "in a vertex": (spaced({(0, 0, 0), (1, 1, 1)}), cube()),
    "a towers' edge": (spaced(TOWERS), cube()),
    "convex": (cube(), prism([(0, 0), (5, 1), (4, 6), (1, 5)], "3/8")),
    "a point": (prism(L), POINT),
}


def same_set(P: str, Q: str, text: str, form: str) -> bool:
    bodies = [_core.read_mesh_text(body.encode(), "off")[0] for body in (P, Q)]
    mesh = _core.read_mesh_text(text.encode(), form)[0]
    mesh.validate()
    if bodies[1].vertices == 1:
        return bool(_core.polyhedral_set(mesh) == _core.polyhedral_set(bodies[0]))
    return bool(_core.polyhedral_set(mesh) == _core.edge_sum_in_space(*bodies, ("1", "1", "1")))


@pytest.mark.parametrize("name", CASES)
def test_each_edge_has_two_triangles(minkref: Minkref, tmp_path: Path, name: str) -> None:
    P, Q = CASES[name]
    (tmp_path / "p.off").write_text(P)
    (tmp_path / "q.off").write_text(Q)
    for form in FORMS:
        out = tmp_path / f"sum.{form}"
        ran = minkref(
            "sum", tmp_path / "p.off", tmp_path / "q.off", "-o", out, "--triangles", "--json"
        )
        assert ran.code == 0, ran.out
        mesh = read_as_written(out.read_text(), form)
        assert faults_of(mesh) == []
        if ran.json["output_exact"]:
            assert sextuple_volume(mesh) == 6 * Fraction(ran.json["volume"])
            assert vertices_on_edges(mesh) == 0 or "tower" in name
            assert same_set(P, Q, out.read_text(), form)
        told = ran.json["rounding"]
        assert told is None or (told["closed"] and told["fault"] is None)


def test_the_edge_of_the_towers_is_cut() -> None:
    """Neither pairing of its faces separates its ends: each pair has a different midpoint."""
    bodies = [_core.read_mesh_text(text.encode(), "off")[0] for text in (spaced(TOWERS), cube())]
    found = _core.edge_sum_in_space(*bodies, ("1", "1", "1"))
    mesh = found.mesh("triangles")
    assert mesh.points().count((2, 2, 3)) == 2
    assert faults_of(read_as_written(minkref.write_mesh(mesh, "off"), "off")) == []
    assert _core.polyhedral_set(mesh) == found


def test_random_polycubes_that_touch_themselves() -> None:
    seed = random.randrange(2**32)
    dice = random.Random(seed)
    unit = _core.read_mesh_text(cube().encode(), "off")[0]
    for _ in range(25):
        cells = {(x, y, z) for x in range(3) for y in range(3) for z in range(2)
                 if dice.random() < 0.5} or {(0, 0, 0)}  # fmt: skip
        solid = _core.read_mesh_text(spaced(cells).encode(), "off")[0]
        found = _core.edge_sum_in_space(solid, unit, ("1", "1", "1"))
        mesh = found.mesh("triangles")
        mesh.validate()
        read = read_as_written(minkref.write_mesh(mesh, "ply"), "ply")
        assert faults_of(read) == [], (seed, sorted(cells))
        assert sextuple_volume(read) == 6 * 8 * len(cells), seed
        assert _core.polyhedral_set(mesh) == found, seed


def test_polyhedra_of_python_are_cut() -> None:
    """The ridge of the dent runs between two corners of the top: no diagonal may run there."""
    box = _core.read_mesh_text(cube(4).encode(), "off")[0]
    assert box.cut_into_triangles().faces == 12
    text = minkref.write_mesh(box, "off", triangles=True)
    assert faults_of(read_as_written(text, "off")) == []
    # The bottom is a square whose corners 0 and 2 also end an edge of a thin wedge.
    points = [(0, 0, 0), (4, 0, 0), (4, 4, 0), (0, 4, 0), (2, 2, 9), (1, 3, 1), (3, 1, 1)]
    faces = [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [0, 2, 5], [2, 0, 6],
             [0, 5, 6], [2, 6, 5]]  # fmt: skip
    dented = _core.Polyhedron(points, faces)
    cut = dented.cut_into_triangles()
    assert all(len(ring) == 3 for ring in cut.rings())
    runs = [(a, b) for ring in cut.rings() for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
    assert len(runs) == len(set(runs))


def test_what_writes_no_mesh_refuses_the_option(minkref: Minkref, tmp_path: Path) -> None:
    (tmp_path / "p.off").write_text(cube())
    square = "POLYGON ((0 0, 1 0, 1 1, 0 0))"
    for words in (
        ("sum", tmp_path / "p.off", tmp_path / "p.off", "--triangles"),
        ("sum", square, square, "--triangles"),
        ("sum", square, "disc:1", "--triangles"),
        ("convolution", tmp_path / "p.off", tmp_path / "p.off", "--triangles"),
    ):
        ran = minkref(*words)
        assert ran.code == 2 and "--triangles" in ran.err


def test_sweeps_and_convolutions_write_them_too(minkref: Minkref, tmp_path: Path) -> None:
    (tmp_path / "p.off").write_text(cube())
    (tmp_path / "s.txt").write_text("1\n2,3,1/2\n")
    P = tmp_path / "p.off"
    words = ("sweep", P, P, "--scales", tmp_path / "s.txt", "-o", tmp_path / "d")
    assert minkref(*words, "--format", "obj", "--triangles").code == 0
    for number in (1, 2):
        text = (tmp_path / "d" / f"sum-000{number}.obj").read_text()
        assert faults_of(read_as_written(text, "obj")) == []
    assert minkref("convolution", P, P, "-o", tmp_path / "c.off", "--triangles").code == 0
    rows = (tmp_path / "c.off").read_text().splitlines()
    assert sum(row.startswith("3 ") for row in rows) == 12


FAR = 10**15
SMALL = [(0, 0), ("1/100", 0), ("1/100", "1/100"), (0, "1/100")]


@pytest.mark.parametrize("form", FORMS)
def test_exact_decimals_that_are_no_doubles_are_told(
    minkref: Minkref, tmp_path: Path, form: str
) -> None:
    """Cubes of a hundredth far from the origin: a reader of doubles sees four corners of eight."""
    far = [(Fraction(x) + FAR + Fraction(1, 100), y) for x, y in SMALL]
    (tmp_path / "p.off").write_text(prism(far, "1/100"))
    (tmp_path / "q.off").write_text(prism(SMALL, "1/100"))
    out = tmp_path / f"s.{form}"
    ran = minkref("sum", tmp_path / "p.off", tmp_path / "q.off", "-o", out, "--json")
    points, _ = read_as_written(out.read_text(), form)
    doubles = {tuple(float(c) for c in point) for point in points}
    told = ran.json["rounding"]
    assert ran.json["output_exact"] and (len(points), len(doubles)) == (8, 4)
    assert (told["moved_vertices"], told["merged_vertices"]) == (8, 4)
    moved_by = max(abs(Fraction(float(c)) - c) for point in points for c in point)
    assert told["largest_displacement"] == str(moved_by)
    shown = minkref("sum", tmp_path / "p.off", tmp_path / "q.off", "-o", out).out
    (line,) = (line for line in shown.splitlines() if line.startswith("as doubles"))
    assert "8 vertices moved by at most 3.0" in line and "4 of them become equal" in line
