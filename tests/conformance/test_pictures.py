"""The pictures of a finding: axes with exact numbers, and a close look at what is too thin to be
seen."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.verdicts.verdict import Reason
from minkref.plane.exact_frame import ExactPolygons
from minkref.reports.axes import axis
from minkref.reports.conformance.close_up import clipped, close_up
from minkref.reports.conformance.plane_pictures import comparison_pictures, operand_pictures
from minkref.reports.conformance.solid_axes import axes_around
from minkref.reports.conformance.space_pictures import space_operand_pictures

SQUARE = '{"polygons":[{"outer":[["0","0"],["4","0"],["4","4"],["0","4"]],"holes":[%s]}]}'
UNIT = '{"polygons":[{"outer":[["0","0"],["1","0"],["0","1"]],"holes":[]}]}'
WHOLE = (Fraction(0), Fraction(0), Fraction(4), Fraction(4))


def numbers(svg: str) -> list[str]:
    return re.findall(r"<text[^>]*>([^<]*)</text>", svg)


@pytest.mark.parametrize(
    ("low", "high", "texts", "base"),
    [
        ("0", "1", ["0", "0.2", "0.4", "0.6", "0.8", "1"], ""),
        ("-3/2", "7/2", ["-1", "0", "1", "2", "3"], ""),
        ("0", "1e-30", ["0", "2e-31", "4e-31", "6e-31", "8e-31", "1e-30"], ""),
        ("0", "5e200", ["0", "1e200", "2e200", "3e200", "4e200", "5e200"], ""),
        (
            "1.0000000001",
            "1.0000000006",
            ["1e-10", "2e-10", "3e-10", "4e-10", "5e-10", "6e-10"],
            "1",
        ),
        ("300000000001", "300000000003", ["1", "1.5", "2", "2.5", "3"], "3e11"),
    ],
)
def test_numbers_at_an_axis_are_round_short_and_exact(
    low: str, high: str, texts: list[str], base: str
) -> None:
    found = axis(Fraction(low), Fraction(high), 6)
    assert ([text for _, text in found.ticks], found.base) == (texts, base)
    for value, text in found.ticks:
        assert Fraction(text) + Fraction(base or 0) == value


def test_operands_have_axes_in_the_plane_and_in_space() -> None:
    for picture in operand_pictures(UNIT, SQUARE % "", "1"):
        assert {"0", "1"} <= set(numbers(picture.svg))
        assert numbers(picture.small) == []
    cube = Polyhedron.from_json(
        '{"vertices":[["0","0","0"],["0","0","7"],["0","7","0"],["7","0","0"]],'
        '"faces":[[0,1,2],[0,2,3],[0,3,1],[1,3,2]]}'
    )
    for picture in space_operand_pictures(cube, cube, "1"):
        assert {"x 6", "y 6", "z 6", "2", "4"} <= set(numbers(picture.svg))
    assert axes_around([]) == []


def test_sets_of_any_size_are_drawn() -> None:
    huge = UNIT.replace('"1"', f'"{10**400}"')
    for picture in operand_pictures(huge, UNIT.replace('"1"', f'"1/{10**400}"'), "1"):
        assert "nan" not in picture.svg and "inf" not in picture.svg
        assert any("e400" in text or "e-401" in text for text in numbers(picture.svg))


@pytest.mark.parametrize("thickness", ["1/1000", "1/10000000", f"1/{10**60}"])
@pytest.mark.parametrize("slanted", [False, True])
def test_a_thin_crack_is_magnified_until_both_its_sides_are_seen(
    finding: Any, thickness: str, slanted: bool
) -> None:
    end, t = Fraction(3), Fraction(thickness)
    rise = Fraction(1) if slanted else Fraction(0)
    corners = [(1, 1), (1, 1 + t), (end, 1 + rise + t), (end, 1 + rise)]
    crack = "[" + ",".join(f'["{x}","{y}"]' for x, y in corners) + "]"
    case = f'{{"P":{SQUARE % ""},"Q":{{"polygons":[{{"outer":[["0","0"]]}}]}},"scale":"1"}}'
    place = ("2", str(1 + rise / 2 + t / 2))
    found = finding(case, "py:a:b", place, reasons=(Reason.HOLE_INVENTED,), got=SQUARE % crack)
    pictures = comparison_pictures(SQUARE % "", found.outcome)
    caption, last = pictures[-1].caption, pictures[-1].svg
    assert caption.startswith("the difference, ") and caption.endswith(" times larger")
    (outline,) = re.findall(r'<path class="missing"[^>]* d="([^"]*)"', last)
    heights = sorted(float(y) for _, y in re.findall(r"[ML]([-\d.]+) ([-\d.]+)", outline))
    view = float(re.findall(r'height="(\d+)"', last)[0])
    assert view / 20 < heights[-1] - heights[0] < 4 * view
    assert 'class="witness"' in last


def square(x: Fraction, y: Fraction, side: Fraction) -> ExactPolygons:
    return [[[(x, y), (x + side, y), (x + side, y + side), (x, y + side)]]]


def test_what_is_large_enough_is_not_looked_at_again() -> None:
    assert close_up([], WHOLE, None) is None
    assert close_up(square(Fraction(1), Fraction(1), Fraction(2)), WHOLE, None) is None
    small = square(Fraction(1), Fraction(1), Fraction(1, 100))
    window = close_up([*square(Fraction(2), Fraction(2), Fraction(1)), *small], WHOLE, (
        Fraction(201, 200), Fraction(201, 200)))  # fmt: skip
    assert window is not None and window[2] - window[0] < Fraction(1, 10)
    assert window[0] < 1 < Fraction(101, 100) < window[2]


def test_clipping_keeps_the_window_whole() -> None:
    window = (Fraction(1), Fraction(1), Fraction(2), Fraction(2))
    ((ring,),) = clipped(square(Fraction(0), Fraction(0), Fraction(10**9)), window)
    assert {(float(x), float(y)) for x, y in ring} == {
        (0.5, 0.5),
        (2.5, 0.5),
        (2.5, 2.5),
        (0.5, 2.5),
    }
    assert clipped(square(Fraction(5), Fraction(5), Fraction(1)), window) == []
