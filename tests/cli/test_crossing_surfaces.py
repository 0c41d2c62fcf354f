"""Files of polyhedra that cross or cover themselves, or nest wrongly: refused, with both faces."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.generators.convex import box

Minkref = Callable[..., Any]


def cube(low: int, side: int) -> Polyhedron:
    least, most = Fraction(low), Fraction(low + side)
    return box((least, least, least), (most, most, most))


def along_z(body: Polyhedron, shift: int) -> Polyhedron:
    return body.translated((Fraction(0), Fraction(0), Fraction(shift)))


CASES = {
    "self-intersection": cube(0, 4).with_faces_of(cube(2, 4)),
    "overlapping-faces": cube(0, 4).with_faces_of(along_z(cube(0, 4), 4)),
    "shell-nesting": cube(0, 4).with_faces_of(cube(1, 2)),
    # valid polyhedra that are not convex: two cubes with touching corners, and a cavity
    "not-convex": cube(0, 4).with_faces_of(cube(4, 2)),
    "not-convex ": cube(0, 4).with_faces_of(cube(1, 2).turned_inside_out()),
}


@pytest.mark.parametrize("ending", ("off", "obj"))
@pytest.mark.parametrize("case", CASES)
def test_it_is_refused_with_both_faces(
    minkref: Minkref, tmp_path: Path, case: str, ending: str
) -> None:
    surface, path = CASES[case], tmp_path / f"it.{ending}"
    head = ["OFF", f"{len(surface.vertices)} {len(surface.faces)} 0"] if ending == "off" else []
    letters = ("", "") if ending == "off" else ("v ", "f ")
    rows = [letters[0] + " ".join(map(str, vertex)) for vertex in surface.vertices]
    for face in surface.faces:
        numbers = (len(face), *face) if ending == "off" else tuple(k + 1 for k in face)
        rows.append(letters[1] + " ".join(map(str, numbers)))
    path.write_text("\n".join([*head, *rows]) + "\n", encoding="utf-8")
    command = "convolution" if case.startswith("not-convex") else "sum"  # which takes any shape
    ran = minkref(command, path, "gs3", "-o", tmp_path / "sum.off", "--json")
    assert ran.code == 2
    assert not (tmp_path / "sum.off").exists()
    assert ran.json["error"]["code"] == case.strip()
    if case.startswith("not-convex"):
        return
    named = re.search(r"line (\d+)\D+face (\d+)\D+face (\d+)", ran.err)
    assert named, ran.err
    line, *faces = map(int, named.groups())
    assert rows[line - 1 - len(head)] == rows[len(surface.vertices) + faces[0]]
    assert min(faces) < 6 <= max(faces) < 12
