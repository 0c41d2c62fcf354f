"""Drawings and tables of sums with a disc: sizes that doubles do not hold, units, digits."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import ezdxf
import pytest
from minkref.certain_digits import between, root

Minkref = Callable[..., Any]

SQUARE = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))"
# A rectangle with a vertex that rounding has made reflex by some 10^-16.
FLAT = (
    "POLYGON ((0 0, -1.3832180741301383 2.6620871059001265, "
    "-4.6107269137671274 8.8736236863337545, "
    "-9.0475387569340047 6.5682602294501908, -4.4368118431668773 -2.3053634568835637, 0 0))"
)
# A slot as wide as a cutter of the radius 1/2, turned in doubles.
SLOT = (
    "POLYGON ((0 0, 4.9840322853493539 0.39927706995932238, 4.6646106293818956 4.3865028982388052, "
    "2.6709977152421542 4.2267920702550761, 2.9105639572177475 1.2363726990454642, "
    "1.9137575001478768 1.1565172850535996, 1.6741912581722835 4.146936656263212, "
    "-0.31942165596745792 3.9872258282794828, 0 0))"
)


@pytest.mark.parametrize(
    ("shape", "corner", "area"),
    [(FLAT, (-0.9395368898134505, 2.892623451588483), "65.78539816"),
     (SLOT, (2.222065558584457, 3.569334737898703), "29.67809725")],
)  # fmt: skip
def test_corners_that_doubles_lose(
    minkref: Minkref, tmp_path: Path, shape: str, corner: tuple[float, float], area: str
) -> None:
    file = tmp_path / "sum.dxf"
    ran = minkref("sum", shape, "disc:1/2", "-o", file)
    assert re.search(rf"area +{re.escape(area)}\n", ran.out), ran.out
    drawing = ezdxf.readfile(file)
    assert drawing.header["$INSUNITS"] == 0
    points = [p[:2] for ring in drawing.modelspace().query("LWPOLYLINE") for p in ring]
    assert min(math.dist(p, corner) for p in points) < 1e-9
    rows = minkref("sweep", shape, "disc", "--from", "1/2", "--to", "1", "--steps", "2").out
    assert area[:-1] in rows or f"{float(area):.9g}" in rows
    assert minkref("view", shape, "disc", "-o", tmp_path / "page.html").code == 0


@pytest.mark.parametrize("power", [-300, -9, 0, 9, 200])
@pytest.mark.parametrize("far", [0, 1])
def test_a_picture_is_the_same_at_every_size(
    minkref: Minkref, tmp_path: Path, power: int, far: int
) -> None:
    """Also tests a set whose distance from the origin is a million times its size."""
    unit = Fraction(10) ** power

    def picture(unit: Fraction, at: Fraction) -> str:
        corners = [(0, 0), (4, 0), (3, 5), (0, 0)]
        text = ", ".join(f"{unit * x + at} {unit * y - at}" for x, y in corners)
        file = tmp_path / "sum.svg"
        ran = minkref("sum", f"POLYGON (({text}))", f"disc:{unit}", "-o", file)
        assert ran.code == 0, ran.err
        return file.read_text().split("<path")[1]

    assert picture(unit, 10**6 * unit * far) == picture(Fraction(1), Fraction(0))


def test_a_drawing_beyond_doubles_is_refused(minkref: Minkref, tmp_path: Path) -> None:
    ran = minkref("sum", SQUARE, "disc:1e400", "-o", tmp_path / "sum.dxf")
    assert ran.code == 2 and "beyond doubles" in ran.err and not list(tmp_path.iterdir())
    assert minkref("sum", SQUARE, "disc:1e400", "-o", tmp_path / "sum.svg").code == 0
    ran = minkref("sum", "POLYGON EMPTY", "disc:1", "-o", tmp_path / "empty.svg")
    assert ran.code == 0


@pytest.mark.parametrize(
    "arguments", [("decompose", "disc:1"), ("certify", "g1", "disc:1", "-o", "x.cert.json")]
)
def test_commands_without_discs_say_what_takes_one(
    minkref: Minkref, arguments: tuple[str, ...]
) -> None:
    ran = minkref(*arguments)
    assert ran.code == 2 and "did you mean" not in ran.err
    assert "a disc is no operand here" in ran.err and "sum takes disc:R" in ran.err


def test_only_certain_digits_are_shown() -> None:
    assert between(1.0, 1.0) == "1"
    assert between(math.nextafter(2.5, 0), math.nextafter(2.5, 3)) == "2.5"
    assert between(1.23456, 1.23457) == "1.2346" or between(1.23456, 1.23457) == "1.235"
    assert between(145.4 - 2000, 145.4 + 2000).startswith("between")
    assert between(1e308, None) == "beyond doubles"
    assert root(Fraction(2), 10) == "1.414213562"
    assert root(Fraction(10) ** 800, 6) == "1.00000e+400"
