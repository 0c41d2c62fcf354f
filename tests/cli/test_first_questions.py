"""Messages are true, and they recommend the requested thing."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref.certify.space.solid_certificate import SolidCertificate
from minkref.errors import Refusal
from minkref.motion.path_text import read_path
from minkref.space.operand import read_summand
from minkref.space.tight_passages import tight_passages

Minkref = Callable[..., Any]

SQUARE = "POLYGON((0 0,2 0,2 2,0 2,0 0))"
WALL = "POLYGON((5 0,6 0,6 1,5 1,5 0))"
BOW = "OFF\n4 1 0\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n4 0 1 2 3\n"
DEEP = '{"vertices":' + "[" * 5000 + "]" * 5000 + "}"


@pytest.mark.parametrize("output", ["p.png", "x.html", "p", "p.wkt"])
def test_a_path_is_written_in_the_format_of_its_ending_or_not(
    minkref: Minkref, tmp_path: Path, output: str
) -> None:
    ran = minkref("path", SQUARE, WALL, "POINT (0 0)", "-o", tmp_path / output)
    assert ran.code == 2 and "names no format" in ran.err
    assert "--format" not in ran.err, "an option that the command has not"
    assert not list(tmp_path.iterdir())


def test_a_path_on_standard_output_is_alone_there(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ran = minkref("path", SQUARE, WALL, "POINT (0 0)", "-o", "-")
    assert ran.code == 0 and ran.json["command"] == "path"
    assert not list(tmp_path.iterdir()), "no file of the name -"


@pytest.mark.parametrize(
    "text", ["0,0\n9/2,-1", "x,y\n0,0\n9/2,-1", "\ufeff0 , 0\n4.5,-1\n", "LINESTRING(0 0,9/2 -1)"]
)
def test_a_path_is_also_rows_of_numbers(text: str) -> None:
    assert read_path(text).points == [("0", "0"), ("9/2", "-1")]


def test_a_long_path_is_no_name_of_a_file(minkref: Minkref) -> None:
    corners = ", ".join(f"{x} 1/{x + 1}" for x in range(2000))
    assert len(read_path(f"LINESTRING ({corners})").points) == 2000


REFUSED = {
    "a point of two places": (("path", SQUARE, WALL, "POINT (0 0, 5 5)"), "a POINT has one"),
    "Z without a third": (("path", SQUARE, WALL, "LINESTRING Z (0 0, 1 1)"), "beyond x and y"),
    "a folder beside a polyhedron": (("sum", "folder", "gs3"), "this is a folder"),
    "deep JSON beside a polyhedron": (("sum", "deep.json", "gs3"), "nested deeper"),
    "an absent file beside one": (("sum", "absent.wkt", "gs3"), "there is no such file"),
    "a route of the plane": (("sum", "gs3", "rod", "--route", "paper"), "no route 'paper' in"),
    "an index of polyhedra": (("index", "bow.off", "bow.off", "-o", "x.idx"), "no index in space"),
    "a mesh for a set": (("view", "gs3", "g1", "--path", "POINT (0 0)"), "lies in the plane"),
    "a name of another format": (("index", SQUARE, WALL, "-o", "x.json"), "the ending of another"),
    "a case that is no picture": (
        ("shrink", "random:1:1", "--target", "minkref:paper", "-o", "x.png"), "names no format",
    ),
    "a face that crosses itself": (("sum", "bow.off", "gs3"), "edges of a face meet"),
    "a closed line": (("erode", "LINESTRING(0 0,4 0,4 4,0 0)", SQUARE), "sum` takes lines"),
    "decimals": (
        ("sum", "POLYGON((0 0,0.25 0.5,0.5 0,0 0.5,0 0))", SQUARE), "at (0, 0), (0.25, 0.5)",
    ),
    "no event": (
        ("certify", SQUARE, WALL, "--event", "3/2", "-o", "e.cert.json"),
        "no event at 3/2, nor between 3/4 and 3/2",
    ),
}  # fmt: skip


@pytest.mark.parametrize("kind", REFUSED)
def test_what_is_wrong_is_said(
    minkref: Minkref, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    (tmp_path / "deep.json").write_text(DEEP, encoding="utf-8")
    (tmp_path / "bow.off").write_text(BOW, encoding="utf-8")
    words, told = REFUSED[kind]
    ran = minkref(*words)
    assert (ran.code, told in ran.err) == (2, True), ran.err


def test_too_many_pieces_for_passages_or_a_proof_name_the_limit(tmp_path: Path) -> None:
    """The messages once said `take the route edges`, the route in use, and `scale them`, which
    changes nothing."""
    path = tmp_path / "comb.off"
    path.write_text(prism_over_comb(70), encoding="utf-8")
    comb = read_summand(str(path))
    with pytest.raises(Refusal) as refused:
        tight_passages(comb, comb, ("1", "1", "1"))
    assert refused.value.mend == "leave --passages out"
    with pytest.raises(Refusal, match="more than 1,024") as refused:
        SolidCertificate(comb.surface, comb.surface)
    assert "scale" not in refused.value.mend


def prism_over_comb(teeth: int) -> str:
    """OFF text of a comb with `teeth` teeth and height 1."""
    outline = [(0, 0), (2 * teeth, 0)]
    for k in range(teeth - 1, -1, -1):
        outline += [(2 * k + 2, 3), (2 * k + 1, 3), (2 * k + 1, 1)] if k else [(2, 3), (0, 3)]
        outline += [(2 * k, 1)] if k else []
    n = len(outline)
    vertices = [f"{x} {y} {z}" for z in (0, 1) for x, y in outline]
    faces = [list(range(n))[::-1], list(range(n, 2 * n))]
    faces += [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    lines = [f"{len(face)} {' '.join(map(str, face))}" for face in faces]
    return "\n".join(["OFF", f"{2 * n} {len(faces)} 0", *vertices, *lines]) + "\n"
