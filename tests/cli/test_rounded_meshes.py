"""Answers of `minkref sum` about meshes in space that need rounding."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref import BadInput, _core
from minkref.schemas import schema
from minkref.space.commands.rounding import is_closed, rounding_of
from written_solids import SQUARE, L, cube, frame, moved, off, prism, together

Minkref = Callable[..., Any]
NOTHING = {"merged_vertices": 0, "degenerate_faces": 0, "turned_faces": 0, "bent_faces": 0}
TETRAHEDRON = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]


def written(minkref: Minkref, folder: Path, P: str, Q: str, *words: str, to: str = "off") -> Any:
    """Writes `sum.TO` into the folder and returns the document."""
    (folder / "p.off").write_text(P)
    (folder / "q.off").write_text(Q)
    output = folder / f"sum.{to}"
    ran = minkref("sum", folder / "p.off", folder / "q.off", *words, "-o", output, "--json")
    assert ran.code == 0, ran.out
    jsonschema.validate(ran.json, schema("sum"))
    return ran.json


def as_doubles(path: Path) -> tuple[list[list[float]], list[list[int]]]:
    """An OFF file as read by a program without exact numbers."""
    _, counts, *rows = path.read_text().splitlines()
    vertices, faces = map(int, counts.split()[:2])
    points = [[float(number) for number in row.split()] for row in rows[:vertices]]
    return points, [[int(n) for n in row.split()[1:]] for row in rows[vertices:][:faces]]


def test_the_report_is_of_the_doubles_in_the_file(minkref: Minkref, tmp_path: Path) -> None:
    """Compares the file with the exact mesh: how far vertices moved, and which faces are bent."""
    for P, Q in ((cube(), cube()), (prism(L), cube()), (frame(), prism(L, "1/7"))):
        exact = written(minkref, tmp_path, P, Q, "--scale", "1/3,2/7,1/11", to="json")
        assert (exact["output_exact"], exact["rounding"]) == (True, None)
        told = written(minkref, tmp_path, P, Q, "--scale", "1/3,2/7,1/11")
        assert not told["output_exact"]
        points, faces = as_doubles(tmp_path / "sum.off")
        mesh = _core.read_mesh_file(str(tmp_path / "sum.json"))[0]
        steps = [
            [abs(Fraction(a) - Fraction(b)) for a, b in zip(point, place, strict=True)]
            for point, place in zip(points, mesh.points(), strict=True)
        ]
        assert mesh.rings() == faces
        assert told["rounding"]["moved_vertices"] == sum(any(step) for step in steps) > 0
        largest = max(max(step) for step in steps)
        assert told["rounding"]["largest_displacement"] == str(largest)
        assert 0 < largest < Fraction(1, 2**50)
        assert {**told["rounding"], **NOTHING, "closed": True, "fault": None} == told["rounding"]
        _core.Polyhedron(points, faces).validate()


def test_what_is_exact_has_no_report(minkref: Minkref, tmp_path: Path) -> None:
    for ending in ("off", "obj", "ply", "json"):
        told = written(minkref, tmp_path, prism(L), cube("1/8"), to=ending)
        assert (told["output_exact"], told["rounding"]) == (True, None)
    # STL has triangles only: the file is another mesh, and no vertex moved.
    told = written(minkref, tmp_path, prism(L), cube("1/8"), to="stl")
    assert not told["output_exact"]
    assert (told["rounding"]["moved_vertices"], told["rounding"]["fault"]) == (0, None)
    assert told["rounding"]["largest_displacement"] == "0"


def test_slanted_polygons_bend(minkref: Minkref, tmp_path: Path) -> None:
    """A slab between two slanted squares: each face read from the file as Fractions."""
    ring = [(x, y, Fraction(x, 3) + Fraction(y, 7)) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    above = [(x, y, z + 1) for x, y, z in ring]
    walls = [[k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k] for k in range(4)]
    slab = off([*ring, *above], [[3, 2, 1, 0], [4, 5, 6, 7], *walls])
    told = written(minkref, tmp_path, slab, off([("1/9", "2/9", 0)], []))
    points, faces = as_doubles(tmp_path / "sum.off")
    bent = 0
    for face in faces:
        a, b, c, d = ([Fraction(x) for x in points[k]] for k in face)
        u, v, w = ([x - y for x, y in zip(p, a, strict=True)] for p in (b, c, d))
        bent += bool(
            u[0] * (v[1] * w[2] - v[2] * w[1])
            - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0])
        )
    assert told["rounding"]["bent_faces"] == bent > 0
    # Bent faces are no faces of a polyhedron, but their triangles are.
    assert told["rounding"]["fault"] is None
    with pytest.raises(BadInput) as refused:
        _core.Polyhedron(points, faces).validate()
    assert refused.value.code == "non-planar-face"


def test_faces_collapse(minkref: Minkref, tmp_path: Path) -> None:
    """A slab that is thinner than doubles can tell, far from the origin."""
    thin = moved(prism(SQUARE, f"1/{3 * 2**80}"), 2**20)
    told = written(minkref, tmp_path, thin, off([(0, 0, 1)], []))["rounding"]
    assert (told["merged_vertices"], told["degenerate_faces"]) == (4, 4)
    assert (told["closed"], told["fault"]) == (True, "zero-length-edge")
    assert told["largest_displacement"] == f"1/{3 * 2**80}"


def plate_and_spike(a: Fraction, b: Fraction, c: Fraction) -> _core.Polyhedron:
    """A spike whose tip ends 2^-80 below the slanted bottom of a plate."""
    tip = (7 * a + b + c) / 9 - Fraction(1, 2**80)
    points = [(0, 0, a), (9, 0, b), (0, 9, c), (0, 0, 1), (1, 1, 0), (2, 1, 0), (1, 2, 0)]
    return _core.Polyhedron(
        [*points, (1, 1, tip)], [*TETRAHEDRON, *([4 + k for k in face] for face in TETRAHEDRON)]
    )


def test_faces_that_cross_once_they_are_rounded() -> None:
    crossing = plate_and_spike(Fraction(1, 4), Fraction(1, 5), Fraction(1, 6))
    crossing.validate()
    found = rounding_of(crossing)
    assert found is not None
    a, b, c, *_, tip = (Fraction(z) for _, _, z in _core.rounded_mesh(crossing)[0].points())
    assert tip > (7 * a + b + c) / 9
    assert (found["closed"], found["fault"]) == (True, "self-intersection")
    assert found["merged_vertices"] == found["degenerate_faces"] == found["turned_faces"] == 0
    touching = plate_and_spike(*[Fraction(1, 3)] * 3)
    found = rounding_of(touching)
    assert found is not None and found["fault"] is None


def test_a_mesh_without_a_face_is_not_closed() -> None:
    assert is_closed(TETRAHEDRON) and is_closed([])
    assert not is_closed(TETRAHEDRON[1:])
    assert not is_closed([TETRAHEDRON[0][::-1], *TETRAHEDRON[1:]])


def test_a_sum_that_touches_itself_is_told_apart(minkref: Minkref, tmp_path: Path) -> None:
    two = together(cube(), moved(cube(), 2))
    told = written(minkref, tmp_path, two, cube("1/3"), "--scale", "1/3")
    assert told["rounding"]["closed"]
    assert told["rounding"]["fault"] == "non-manifold-vertex"


def test_beyond_doubles_a_warning_is_said(minkref: Minkref, tmp_path: Path) -> None:
    """A length of ten to the 400 is written exactly, but a third is not."""
    bar = prism([(0, 0), (10**400, 0), (10**400, "1/3"), (0, "1/3")])
    told = written(minkref, tmp_path, bar, off([(0, 0, 0)], []))
    assert (told["output_exact"], told["rounding"]) == (False, None)
    assert "beyond the range of doubles" in told["warnings"][0]


def test_people_read_it(minkref: Minkref, tmp_path: Path) -> None:
    (tmp_path / "p.off").write_text(cube("1/3"))
    (tmp_path / "q.off").write_text(cube())
    ran = minkref("sum", tmp_path / "p.off", tmp_path / "q.off", "-o", tmp_path / "sum.off")
    assert ran.code == 0
    (line,) = (line for line in ran.out.splitlines() if line.startswith("as doubles"))
    assert "7 vertices moved by at most " in line
    assert line.endswith("; closed; no face crosses another")
    exact = minkref("sum", tmp_path / "p.off", tmp_path / "q.off", "-o", tmp_path / "sum.json")
    assert "as doubles" not in exact.out
