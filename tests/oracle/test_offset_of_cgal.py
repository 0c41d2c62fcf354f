"""Sums with a disc against CGAL's exact offset, and who is right if they differ."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest
from minkref import _core
from minkref.fuzz.judges.disc.offset_cgal import OffsetJudge, absence
from minkref.fuzz.judges.disc.offset_comparison import Table, compare, compare_one
from thoroughness import draws


@pytest.fixture
def judge() -> OffsetJudge:
    missing = absence()
    if missing:
        pytest.skip(missing)
    return OffsetJudge(60)


def polygons(*rings: list[list[str]]) -> _core.PolygonSet:
    found = [{"holes": [], "outer": ring} for ring in rings]
    return _core.PolygonSet.from_json(json.dumps({"polygons": found}))


def square(x: int, y: int) -> list[list[str]]:
    return [[str(a), str(b)] for a, b in ((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1))]


def test_sets_of_cells_have_the_curves_of_cgal(judge: OffsetJudge) -> None:
    judge.close()
    table = Table()
    compare(7, range(count := draws(18, 60)), table)
    assert table.differences == []
    assert table.counts["compared"] > 5 * count / 6


def test_components_that_touch_and_the_hole_between_them(judge: OffsetJudge) -> None:
    """Two pairs of corners, twice the radius apart."""
    table = Table()
    with judge:
        P = polygons(square(0, 0), [["2", "1"], ["3", "1"], ["3", "3"], ["1", "3"], ["1", "2"]])
        compare_one(judge, "touching", P, Fraction(1, 2), table)
    assert table.differences == [] and table.refuted == [] and table.counts["compared"] == 1


def test_a_wrong_union_of_cgal_is_refuted_by_a_point(judge: OffsetJudge) -> None:
    """CGAL 5.5 loses two of three offsets during their union."""
    table = Table()
    with judge:
        P = polygons([["0", "0"], ["1", "0"], ["0", "1"]], square(0, 2), square(1, 1))
        compare_one(judge, "lost", P, Fraction(1061, 500), table)
    assert table.differences == []
    assert all("is in the sum" in told for told in table.refuted)


def test_a_fault_of_ours_is_no_fault_of_cgal(
    judge: OffsetJudge, monkeypatch: pytest.MonkeyPatch
) -> None:
    right = _core.offset
    monkeypatch.setattr(_core, "offset", lambda P, square: right(P, str(Fraction(square) * 2)))
    table = Table()
    with judge:
        compare_one(judge, "wrong", polygons(square(0, 0)), Fraction(1), table)
    assert len(table.differences) == 1 and table.refuted == []
