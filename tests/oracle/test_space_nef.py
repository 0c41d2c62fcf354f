"""CGAL's sums of Nef polyhedra, as canonical text, against cells and the slow engine."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import pytest
from minkref.fuzz.judges.space.space_nef import NefJudge
from minkref.fuzz.space.pairs import space_pair
from minkref.oracle.slow import CellSum, SolidSum, solid_from_json, uniform, whole_sum

SEED = 71206


@pytest.fixture(scope="module")
def nef() -> Iterator[NefJudge]:
    with NefJudge(30) as judge:
        if judge.absence:
            pytest.skip(judge.absence)
        yield judge


@pytest.mark.parametrize("family", ["polycube", "hollow", "frame", "apart"])
@pytest.mark.parametrize("index", [3, 12])
def test_polycubes(nef: NefJudge, family: str, index: int) -> None:
    pair = space_pair(family, SEED, index)
    assert isinstance(pair.scale, Fraction)
    truth = CellSum(pair.P_cells, pair.Q_cells, pair.scale).exposed().text()
    assert nef.sum(pair.P.scaled(pair.scale), pair.Q) == truth


@pytest.mark.parametrize("family", ["torus", "prism"])
@pytest.mark.parametrize("index", range(2))
def test_whole_sums(nef: NefJudge, family: str, index: int) -> None:
    pair = space_pair(family, SEED, index)
    first, second = (solid_from_json(solid.document()) for solid in (pair.P, pair.Q))
    found = whole_sum(SolidSum(first, second, uniform(Fraction(1))))
    assert nef.sum(pair.P, pair.Q) == found.text()


def test_one_that_takes_too_long_has_no_answer() -> None:
    pair = space_pair("star", SEED, 40)
    with NefJudge(0.01) as judge:
        if judge.absence:
            pytest.skip(judge.absence)
        assert judge.sum(pair.P, pair.Q) is None
        assert judge.sum(pair.P, pair.Q) is None
