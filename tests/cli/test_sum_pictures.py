"""Pictures of a sum: in the terminal, and as SVG beside its operands."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.cli.terminal_picture import COLUMNS, ROWS, terminal_picture

Minkref = Callable[..., Any]
BITS = ((0, 3, 0x40), (1, 3, 0x80), *((x, y, 1 << (3 * x + y)) for x in (0, 1) for y in (0, 1, 2)))
FRAME = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"
SVG = "{http://www.w3.org/2000/svg}"


def dots(picture: str) -> set[tuple[int, int]]:
    """The dots of the letters, x to the right, y downwards."""
    return {
        (2 * column + x, 4 * row + y)
        for row, line in enumerate(picture.splitlines()[:-1])
        for column, letter in enumerate(line)
        for x, y, bit in BITS
        if ord(letter) - 0x2800 & bit
    }


def drawn(text: str, **more: int) -> str:
    return terminal_picture(_core.read_text(text, "wkt", "test"), **more)


def test_every_second_dot_inside_and_none_in_a_hole() -> None:
    found = dots(drawn(FRAME))
    last = 4 * ROWS - 1
    assert {x for x, _ in found} == {y for _, y in found} == set(range(last + 1))  # a square
    inner = range(last // 4 + 2, 3 * last // 4 - 1)
    assert not any((x, y) in found for x in inner for y in inner)
    for x in range(2, last // 4 - 1):
        assert {y for y in range(2, last - 1) if (x, y) in found} in (
            set(range(2, last - 1, 2)),
            set(range(3, last - 1, 2)),
        )


def test_a_crack_thinner_than_a_dot_is_a_line_through_the_inside() -> None:
    crack = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 2, 3 2, 3 2.000001, 1 2.000001, 1 2))"
    found = dots(drawn(crack))
    row = (4 * ROWS - 1) // 2
    lines = [{x for x in range(28, 68) if (x, y) in found} for y in range(row - 1, row + 2)]
    assert set(range(28, 68)) in lines


@pytest.mark.parametrize("size", ["1e400", "1e-900", "1", "1" + "0" * 300])
def test_a_triangle_of_any_size_is_drawn_alike(size: str) -> None:
    text = drawn(f"POLYGON ((0 0, {size} 0, 0 {size}, 0 0))")
    assert dots(text) == dots(drawn("POLYGON ((0 0, 7 0, 0 7, 0 0))"))


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("POINT (1 2)", 1),
        ("LINESTRING (0 0, 1 0)", 2 * COLUMNS),
        ("LINESTRING (0 0, 0 1e-400)", 4 * ROWS),
        ("POLYGON ((0 0, 1e300 0, 1e300 1, 0 0))", 2 * COLUMNS),
    ],
)
def test_points_segments_and_thin_sets_have_as_many_dots_as_they_are_long(
    text: str, count: int
) -> None:
    assert len(dots(drawn(text))) == count


def test_the_empty_set_is_named() -> None:
    assert drawn("POLYGON EMPTY") == "(the empty set)\n"


def test_a_narrow_terminal_gets_a_narrow_picture() -> None:
    assert max(map(len, drawn(FRAME, columns=9).splitlines()[:-1])) == 9


def run(*words: str, **variables: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "minkref", "sum", *words],
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=120,
        env={**os.environ, **variables},
    )


def test_in_a_pipe_the_picture_has_no_colours() -> None:
    plain, coloured = (
        run(FRAME, "POINT (0 0)", "--plot"),
        run(FRAME, "POINT (0 0)", "--plot", FORCE_COLOR="1"),
    )
    assert (plain.returncode, plain.stderr) == (0, "") and "\x1b" not in plain.stdout
    assert plain.stdout.splitlines()[-1] == "x 0 to 4, y 0 to 4"
    assert "\x1b[31m" in coloured.stdout  # of the hole
    table = plain.stdout.split("\n\n")[0]
    assert "components, holes  1, 1" in table


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("g1", "g2", "--plot", "--json"), "only one of them"),
        (("g1", "g2", "--plot", "-o", "-"), "only one of them"),
        (("g1", "g2", "--only-sum"), "add -o FILE.svg"),
        (("g1", "g2", "--only-sum", "-o", "sum.wkt"), "add -o FILE.svg"),
        (("gs3", "rod", "--plot"), "in space; no picture is drawn"),
        (("gs3", "rod", "--only-sum", "-o", "sum.off"), "in space; no picture is drawn"),
    ],
)
def test_what_is_refused(minkref: Minkref, words: tuple[str, ...], said: str) -> None:
    ran = minkref("sum", *words)
    assert (ran.code, ran.out[:1] in ("", "{")) == (2, True) and said in ran.err


def test_an_encoding_without_braille_is_refused() -> None:
    ran = run("g1", "g2", "--plot", PYTHONIOENCODING="latin-1", PYTHONUTF8="0")
    assert ran.returncode == 2 and "PYTHONIOENCODING=utf-8" in ran.stderr


def panes(path: Path) -> tuple[list[str], list[tuple[float, float]]]:
    """The captions, and each drawing's width and height."""
    root = ElementTree.parse(path).getroot()
    captions = [str(text.text) for text in root.findall(f"{SVG}text")]
    sizes = []
    for inner in root.iter(f"{SVG}svg"):
        if inner is root:
            continue
        numbers = [re.findall(r"-?[\d.]+", node.get("d", "")) for node in inner.iter(f"{SVG}path")]
        xs = [float(x) for path in numbers for x in path[::2]]
        ys = [float(y) for path in numbers for y in path[1::2]]
        sizes.append((max(xs) - min(xs), max(ys) - min(ys)) if xs else (0.0, 0.0))
    return captions, sizes


@pytest.mark.parametrize("unit", ["1", "1e400", "1e-400"])
def test_operands_are_drawn_to_the_scale_of_the_sum(
    minkref: Minkref, tmp_path: Path, unit: str
) -> None:
    """The sum's box is as wide as both operands' boxes together."""
    e = unit.removeprefix("1")
    P = f"POLYGON ((0 0, 2{e} 0, 2{e} 1{e}, 0 0))"
    Q = f"POLYGON ((0 0, 1{e} 0, 1{e} 3{e}, 0 0))"
    path = tmp_path / "sum.svg"
    assert minkref("sum", P, Q, "--scale", "7/5", "-o", path).code == 0
    captions, (first, second, both) = panes(path)
    assert captions[0].startswith("P: POLYGON") and captions[0].endswith(", scaled by 7/5")
    assert captions[2].startswith("Q: POLYGON") and captions[4] == "sum: 1 component, 0 holes"
    for axis in (0, 1):
        assert first[axis] + second[axis] == pytest.approx(both[axis], abs=0.05)
    assert first[0] / second[0] == pytest.approx(2.8, abs=0.01)


def test_names_are_no_markup(minkref: Minkref, tmp_path: Path) -> None:
    name = "<b>&.wkt"
    (tmp_path / name).write_text(FRAME)
    path = tmp_path / "sum.svg"
    assert minkref("sum", tmp_path / name, "g1", "-o", path).code == 0
    captions, _ = panes(path)
    assert len(captions) == 6 and captions[0].startswith("P: ")


def test_the_sum_alone_where_asked(minkref: Minkref, tmp_path: Path) -> None:
    alone, read = tmp_path / "sum.svg", tmp_path / "sum.json"
    for path, more in ((alone, ["--only-sum"]), (read, [])):
        assert minkref("sum", FRAME, "POINT (0 0)", "-o", path, *more).code == 0
    assert alone.read_text() == _core.write(_core.read_file(str(read)), "svg")


def test_points_segments_and_the_empty_set_beside_a_sum(minkref: Minkref, tmp_path: Path) -> None:
    path = tmp_path / "sum.svg"
    for P, Q, marks, said in (
        ("POINT (1 2)", FRAME, 1, "x 1 to 1, y 2 to 2"),
        ("LINESTRING (0 0, 1 1)", "POLYGON EMPTY", 0, "x 0 to 1, y 0 to 1"),
        ("POLYGON EMPTY", "POLYGON EMPTY", 0, "the empty set"),
    ):
        assert minkref("sum", P, Q, "-o", path).code == 0
        assert panes(path)[0][1] == said
        assert path.read_text().count("<circle") == marks
