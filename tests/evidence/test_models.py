"""The shipped models: generated again they have the same bytes, and their stated sizes."""

from __future__ import annotations

import json
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from model_sizes import SHIPPED

MODELS = Path(__file__).resolve().parents[2] / "minkref" / "models"
LISTS = json.loads((MODELS / "index.json").read_text(encoding="ascii"))
INDEX, POLYHEDRA = LISTS["models"], LISTS["polyhedra"]
Ring = list[tuple[Fraction, Fraction]]


def read_rings(path: Path) -> list[Ring]:
    """A reader of its own for .poly files without run-together numbers."""
    lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    rings, at = [], 1
    for number in range(int(lines[0])):
        count, role = lines[at].split()
        assert role == ("in" if number else "out")
        points = [line.split() for line in lines[at + 1 : at + 1 + int(count)]]
        rings.append([(Fraction(x), Fraction(y)) for x, y in points])
        at += 1 + int(count)
    assert at == len(lines)
    return rings


@pytest.mark.thorough  # the sizes are looked at always
def test_regenerating_gives_identical_bytes(tmp_path: Path) -> None:
    script = [sys.executable, "-I", str(MODELS / "generate.py"), str(tmp_path)]
    subprocess.run(script, check=True, timeout=300)
    written = sorted(path.name for path in tmp_path.iterdir())
    files = [entry["file"] for entry in [*INDEX, *POLYHEDRA]]
    assert written == sorted(["index.json", *files])
    for name in written:
        assert (tmp_path / name).read_bytes() == (MODELS / name).read_bytes(), name


def test_index_lists_every_model_with_its_size() -> None:
    assert {e["name"]: (e["vertices"], e["holes"]) for e in INDEX} == SHIPPED


@pytest.mark.parametrize("entry", INDEX, ids=lambda entry: str(entry["name"]))
def test_model_has_the_stated_vertices_and_holes(entry: dict) -> None:
    rings = read_rings(MODELS / entry["file"])
    assert sum(map(len, rings)) == entry["vertices"]
    assert len(rings) == 1 + entry["holes"]
    for number, ring in enumerate(rings):
        assert len(set(ring)) == len(ring)
        area = sum(
            a[0] * b[1] - a[1] * b[0] for a, b in zip(ring, ring[1:] + ring[:1], strict=True)
        )
        assert (area > 0) == (number == 0)


@pytest.mark.parametrize(("name", "radius"), [("disc1", "0.3669092445"), ("disc5", "1.834546223")])
def test_disc_vertices_are_the_rounded_points_of_the_circle(name: str, radius: str) -> None:
    """Each vertex is within half a unit of 10^-7 from a point at a 32nd of the turn: the
    double-angle formula with exactly enclosed square roots gives cos and sin of pi / 16."""
    (ring,) = read_rings(MODELS / f"{name}.poly")
    assert ring[0] == (Fraction(round(Fraction(radius) * 10**7), 10**7), 0)

    def root(value: Fraction) -> Fraction:  # to 40 digits
        from math import isqrt

        return Fraction(isqrt(int(value * 10**80)), 10**40)

    cosine = Fraction(0)  # of a quarter turn
    for _ in range(3):
        cosine = root((1 + cosine) / 2)
    sine = root(1 - cosine**2)
    x, y = Fraction(radius), Fraction(0)
    for point in ring:
        assert abs(point[0] - x) <= Fraction(1, 2 * 10**7) + Fraction(1, 10**30)
        assert abs(point[1] - y) <= Fraction(1, 2 * 10**7) + Fraction(1, 10**30)
        assert all((value * 10**7).denominator == 1 for value in point)
        x, y = x * cosine - y * sine, x * sine + y * cosine


def test_edges_that_meet_are_refused_by_the_generator() -> None:
    """The generator's own check of simplicity: a bow tie, a spike, a hole outside are found."""
    sys.path.insert(0, str(MODELS))
    try:
        from simplify import faults  # type: ignore[import-not-found]
    finally:
        sys.path.remove(str(MODELS))
    square = [(0, 0), (10, 0), (10, 10), (0, 10)]
    assert faults([square]) == []
    assert faults([square, [(2, 2), (2, 4), (4, 4)]]) == []
    assert any("meet" in fault for fault in faults([[(0, 0), (10, 10), (10, 0), (0, 12)]]))
    assert any("straight" in fault for fault in faults([[(0, 0), (5, 0), (10, 0), (0, 10)]]))
    assert any("outside" in f for f in faults([square, [(22, 2), (22, 4), (24, 4)]]))
    assert any("wrong way" in fault for fault in faults([square[::-1]]))
