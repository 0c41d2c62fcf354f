"""A sum with a disc as a polygon: read back exactly, the file's polygon lies inside the true sum or
around it, and within the tolerance."""

from __future__ import annotations

import json
import math
import random
import re
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from turned_shapes import shape_json, turned_shape

Minkref = Callable[..., Any]
Point = tuple[Fraction, Fraction]
Segment = tuple[Point, Point]

UNIT = "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))"
SLOT = "POLYGON ((0 0, 3 0, 3 4, 2.1 4, 2 1, 1 1, 0.9 4, 0 4, 0 0))"
FAR = "POLYGON ((500000 6500000, 500010 6500000, 500003.7 6500010, 500000 6500000))"


def rings_of_wkt(text: str) -> list[list[Point]]:
    return [
        [(Fraction(x), Fraction(y)) for x, y in re.findall(r"([^\s,]+) ([^\s,]+)", ring)][:-1]
        for ring in re.findall(r"\(([^()]+)\)", text)
    ]


def sides(rings: list[list[Point]]) -> list[Segment]:
    return [side for ring in rings for side in zip(ring, [*ring[1:], ring[0]], strict=True)]


def squared_distance(p: Point, edges: list[Segment]) -> Fraction:
    """From the edges of a set; exact."""

    def from_edge(edge: Segment) -> Fraction:
        (ax, ay), (bx, by) = edge
        dx, dy = bx - ax, by - ay
        t = ((p[0] - ax) * dx + (p[1] - ay) * dy) / (dx * dx + dy * dy)
        t = min(max(t, Fraction(0)), Fraction(1))
        return (p[0] - ax - t * dx) ** 2 + (p[1] - ay - t * dy) ** 2

    return min(map(from_edge, edges))


def is_within(p: Point, edges: list[Segment]) -> bool:
    """Whether the edges enclose a point, by crossings to its right."""
    odd = False
    for (ax, ay), (bx, by) in edges:
        if (ay > p[1]) != (by > p[1]):
            odd ^= p[0] < ax + (p[1] - ay) / (by - ay) * (bx - ax)
    return odd


def along(edges: list[Segment]) -> list[Point]:
    """Corners, and three points of each side."""
    quarters = [Fraction(k, 4) for k in range(4)]
    return [
        (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])) for a, b in edges for t in quarters
    ]


def look_at(
    text: str, P: list[list[Point]], squared_radius: Fraction, T: Fraction, out: bool
) -> None:
    own, file = sides(P), sides(rings_of_wkt(text))
    high = Fraction(math.isqrt(squared_radius.numerator << 400) + 1) / math.isqrt(
        squared_radius.denominator << 400
    )
    low = Fraction(math.isqrt(squared_radius.numerator << 400)) / (
        math.isqrt(squared_radius.denominator << 400) + 1
    )
    for p in along(file):
        square = Fraction(0) if is_within(p, own) else squared_distance(p, own)
        if out:
            assert square >= squared_radius and square <= (low + T) ** 2
        else:
            assert square <= squared_radius and square >= max(high - T, Fraction(0)) ** 2


def in_double(text: str) -> str:
    """The text as seen by a reader that rounds coordinates."""
    return re.sub(r"-?[0-9.]+", lambda found: str(Fraction(float(found[0]))), text)


@pytest.mark.parametrize("options", [(), ("--outside",)])
@pytest.mark.parametrize("tolerance", ["1/100", "3"])
@pytest.mark.parametrize("shape", [UNIT, SLOT, FAR, "POINT (1/3 2)", "LINESTRING (0 0, 3 1)"])
def test_the_file_is_inside_or_around(
    minkref: Minkref, tmp_path: Path, shape: str, tolerance: str, options: tuple[str, ...]
) -> None:
    file = tmp_path / "sum.wkt"
    ran = minkref("sum", shape, "disc:sqrt:1/4", "-o", file, "--tolerance", tolerance, *options)
    assert ran.code == 0, ran.err
    text = file.read_text()
    P = rings_of_wkt(shape)
    if shape.startswith("POINT"):
        P = [[(Fraction(1, 3), Fraction(2)), (Fraction(1, 3), Fraction(2) + Fraction(1, 10**99))]]
    elif shape.startswith("LINESTRING"):
        P = [[(Fraction(0), Fraction(0)), (Fraction(3), Fraction(1))]]
    for written in (text, in_double(text)):
        look_at(written, P, Fraction(1, 4), Fraction(tolerance), bool(options))


@pytest.mark.parametrize("form", ["geojson", "poly"])
def test_other_formats_hold_the_same_set(minkref: Minkref, tmp_path: Path, form: str) -> None:
    files = [tmp_path / f"sum.{name}" for name in ("wkt", form)]
    for file in files:
        assert minkref("sum", SLOT, "disc:1", "-o", file, "--tolerance", "1/100").code == 0
    one, other = (minkref("sum", file, "POINT (0 0)", "--json").json["digest"] for file in files)
    assert one == other
    if form == "geojson":
        corners = json.loads(files[1].read_text())["coordinates"][0]
        assert len(corners) > 20


@pytest.mark.parametrize("kind", ["slot", "walls", "street", "comb", "flat", "board"])
def test_turned_shapes_in_files(minkref: Minkref, tmp_path: Path, kind: str) -> None:
    shape, square = turned_shape(kind, random.Random(f"7 {kind}"))
    file, P = tmp_path / "sum.wkt", tmp_path / "P.json"
    P.write_text(shape_json(shape))
    T = Fraction(10) ** (-12 if kind == "board" else -3)
    for options in ((), ("--outside",)):
        ran = minkref("sum", P, f"disc:sqrt:{square}", "-o", file, "--tolerance", str(T), *options)
        assert ran.code == 0, ran.err
        look_at(file.read_text(), shape, square, T, bool(options))
