"""`minkref sum` and `minkref erode` with a ball."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref as library
import pytest

Minkref = Callable[..., Any]
CUBE = """OFF
8 6 0
0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1
4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5
"""


@pytest.fixture
def cube(tmp_path: Path) -> Path:
    path = tmp_path / "cube.off"
    path.write_text(CUBE, encoding="utf-8")
    return path


def test_the_sets_around_a_sum_and_what_is_written(minkref: Minkref, cube: Path) -> None:
    files = {name: cube.parent / f"{name}.json" for name in ("inner", "outer")}
    told = {}
    for name, file in files.items():
        way = ["--outside"] if name == "outer" else []
        ran = minkref("sum", cube, "ball:1/2", "--tolerance", "1/20", "-o", file, *way, "--json")
        assert ran.code == 0 and ran.json["output_is"] == name
        told = ran.json
        written = library.read_mesh(file)
        assert library.ConvexPolyhedron(written).volume == Fraction(told[name]["volume"])
    low, high = (Fraction(told[name]["volume"]) for name in ("inner", "outer"))
    true = 1 + 6 / 2 + 12 * 3.14159265 / 4 / 4 + 4 / 3 * 3.14159265 / 8
    assert low < true < high
    assert (told["components"], told["squared_radius"], told["tolerance"]) == (1, "1/4", "1/20")
    found = library.ball_sum(library.read_mesh(cube), library.Ball("1/2"), "1/20")
    assert found.volume == (low, high)


def test_either_operand_may_be_the_ball(minkref: Minkref, cube: Path) -> None:
    far = ("--tolerance", "1/4", "--json")
    first = minkref("sum", "ball:1/2", cube, "--scale", "2", *far).json
    second = minkref("sum", cube, "ball:1", *far).json
    assert first["inner"] == second["inner"] and first["radius"] == second["radius"] == "1"
    assert minkref("sum", "ball:1", cube, "--scale", "1,2,3", *far).code == 2


def test_an_erosion_lies_between_its_sets(minkref: Minkref, cube: Path) -> None:
    told = minkref("erode", cube, "ball:1/4", "--tolerance", "1/40", "--json").json
    low, high = (Fraction(told[name]["volume"]) for name in ("inner", "outer"))
    assert Fraction(45, 100) ** 3 <= low <= Fraction(1, 8) <= high <= Fraction(55, 100) ** 3
    assert told["components"] is None
    gone = minkref("erode", cube, "ball:1", "--tolerance", "1/10", "--json").json
    assert gone["inner"]["volume"] == gone["outer"]["volume"] == "0"


@pytest.mark.parametrize(
    ("words", "part"),
    [
        (["sum", "CUBE", "ball:1"], "--tolerance 1/100"),
        (["sum", "ball:1", "ball:2", "--tolerance", "1"], "add their radii"),
        (["sum", "disc:1", "ball:2", "--tolerance", "1"], "lies in the plane"),
        (["sum", "CUBE", "ball:0", "--tolerance", "1"], "zero"),
        (["sum", "CUBE", "ball:1", "--tolerance", "0"], "not above 0"),
        (["sum", "CUBE", "ball:1", "--tolerance", "1/99999"], "give a larger one"),
        (["sum", "CUBE", "ball:1", "--tolerance", "1", "--outside"], "add -o"),
        (["sum", "CUBE", "ball:1", "--tolerance", "1", "--route", "edges"], "with a ball"),
        (["erode", "ball:1", "CUBE", "--tolerance", "1"], "a ball is what erodes"),
        (["events", "CUBE", "ball:1", "--from", "1", "--to", "2"], "takes no ball"),
    ],
)
def test_refusals_say_what_to_do(minkref: Minkref, cube: Path, words: list[str], part: str) -> None:
    ran = minkref(*(str(cube) if word == "CUBE" else word for word in words))
    assert ran.code == 2 and part in ran.err
