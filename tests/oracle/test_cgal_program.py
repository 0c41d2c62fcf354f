"""The stand-alone program shows CGAL's fault with CGAL alone."""

from __future__ import annotations

import re
import shutil
import subprocess

import pytest
from minkref.fuzz.cgal.oracle import METHOD_GROUPS
from minkref.fuzz.cgal.program import cgal_program

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def build(text, folder):
    """Builds with the command from the program's own comment, without the optimiser's minutes, and
    with two steps: ccache can keep a compilation without linking."""
    found = re.search(r"^// (g\+\+ .*) (\w+)\.cpp -o \2 (.*) && \./\2$", text, re.MULTILINE)
    assert found, "the program says how it is compiled and run"
    compiler, name, libraries = found.groups()
    (folder / f"{name}.cpp").write_text(text)
    cache = "ccache " if shutil.which("ccache") else ""
    for command in (
        f"{cache}{compiler.replace('-O2', '-O0')} -c {name}.cpp -o {name}.o",
        f"g++ {name}.o -o {name} {libraries}",
    ):
        subprocess.run(command, shell=True, cwd=folder, check=True, timeout=600)
    return folder / name


def test_the_program_shows_the_lost_hole(lost_hole, tmp_path):
    compiler = shutil.which("g++")
    probe = ["g++", "-fsyntax-only", "-include", "CGAL/version.h", "-x", "c++", "/dev/null"]
    if not compiler or subprocess.run(probe, capture_output=True, check=False).returncode:
        pytest.skip("g++ and CGAL's headers in the system's include path are needed")
    text = cgal_program(*lost_hole, "reduced", ("37/5", "14"), in_truth=False, name="lost_hole")
    program = build(text, tmp_path)
    run = subprocess.run([program], capture_output=True, text=True, timeout=60)
    assert "in truth: out" in run.stdout
    assert "by CGAL's Boolean operations: disjoint" in run.stdout
    if re.match(r"CGAL 5\.5", run.stdout):
        assert "0 holes" in run.stdout and "in this sum: in" in run.stdout
        assert run.returncode == 1
    else:
        assert "1 holes" in run.stdout and "in this sum: out" in run.stdout
        assert run.returncode == 0


@pytest.mark.parametrize("method", METHOD_GROUPS)
def test_every_method_has_a_program_of_cgal_only(polygon, method):
    text = cgal_program(polygon(SQUARE), polygon(SQUARE), method, ("1/3", "-2/7"), in_truth=True)
    included = re.findall(r"#include [<\"](.*)[>\"]", text)
    assert all(
        name.startswith("CGAL/") or name in ("iostream", "string", "vector") for name in included
    )
    assert 'number("1/3"), number("-2/7")' in text
    assert "const bool truth = true;" in text
    assert "$" not in text


def test_coordinates_are_written_as_they_were_read(polygon):
    corners = [(0, 0), ("123456789012345678901234567890/7", 0), (0, "1/3")]
    text = cgal_program(polygon(corners), polygon(SQUARE), "reduced")
    assert '{{"0", "0"}, {"123456789012345678901234567890/7", "0"}, {"0", "1/3"}}' in text
    assert "covers" not in text, "without a point there is the call alone"


def test_vanishing_holes_are_left_out_with_a_word_unless_raw(polygon):
    large, small = [(2, 2), (2, 6), (6, 6), (6, 2)], [(7, 7), (7, 8), (8, 8), (8, 7)]
    P = polygon([(0, 0), (9, 0), (9, 9), (0, 9)], large, small)
    text = cgal_program(P, polygon(SQUARE), "reduced")
    assert '{"2", "6"}' in text and '{"7", "8"}' not in text
    assert "// Left out: hole 2 of P, at (7, 7), 1 by 1." in text
    assert '{"7", "8"}' in cgal_program(P, polygon(SQUARE), "reduced", raw=True)


def test_operands_that_the_method_does_not_take_are_refused(polygon):
    P = polygon([(0, 0), (9, 0), (9, 9), (0, 9)], [(2, 2), (2, 6), (6, 6), (6, 2)])
    with pytest.raises(ValueError, match="without holes"):
        cgal_program(P, polygon(SQUARE), "full")
    with pytest.raises(ValueError, match="2 polygons"):
        cgal_program({"polygons": P["polygons"] * 2}, polygon(SQUARE), "reduced")
