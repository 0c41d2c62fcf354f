"""The steps about the speed of sums in space, and about larger pairs, on small pairs."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.fuzz.judges.space.space_manifold import VolumeAnswer
from minkref.fuzz.judges.space.space_nef import NEF, NefJudge
from minkref.fuzz.space.generators.machined import plate
from minkref.fuzz.space.generators.round import triangulated_torus
from minkref.reports.bench.space_pairs import TimedPair
from minkref.reports.bench.space_tools import Timed, Tools
from minkref.reports.evidence.framework.part import Findings, Size, Status
from minkref.reports.evidence.space_costs.sums import difference, look, ratio_of
from minkref.reports.evidence.space_sums.large_pairs import judge
from minkref.reports.space_speed_plot import draw

TORUS = triangulated_torus(6, 3, 300, 100)
PAIR = TimedPair("torus 36 + block", lambda: (TORUS, plate(20, 30, 40)), seconds=30, ratio=1e-6)


def test_ratios_are_bounds_where_nef_runs_into_its_limit() -> None:
    over = Timed(why="no answer in 300 s", processor=90.0)
    assert ratio_of(Timed(2.0), Timed(5.0), 300, False) == (2.5, False)
    assert ratio_of(Timed(2.0), over, 300, False) == (150, True)
    assert ratio_of(Timed(2.0), Timed(why="it took more than 8 GiB"), 300, False) == (None, False)
    assert ratio_of(Timed(why="it ended"), Timed(5.0), 300, False) == (None, False)


def test_on_a_busy_machine_processor_time_counts() -> None:
    ours = Timed(2.0, processor=1.5)
    assert ratio_of(ours, Timed(40.0, processor=9.0), 300, True) == (12, False)
    assert ratio_of(ours, Timed(why="no answer in 300 s", processor=90.0), 300, True) == (120, True)
    assert ratio_of(ours, Timed(why="it ended", processor=9.0), 300, True) == (None, False)


def test_volumes_are_compared_relatively() -> None:
    assert difference(Timed(1.0, volume=Fraction(8)), Timed(1.0, volume=10.0)) == 0.25
    assert difference(Timed(1.0, volume=Fraction(8)), Timed(why="absent")) is None
    assert VolumeAnswer(10.0).difference(Fraction(8)) == 0.25
    assert VolumeAnswer(None).difference(Fraction(8)) is None


def test_tools_agree_on_a_small_pair() -> None:
    findings = Findings()
    with Tools(60) as tools:
        row = look(PAIR, tools, 60, findings)
        absent = tools.absent
    assert row["minkref"] > 0 and row["facets"] == [36, 12]
    assert row["equal"] == (None if NEF in absent else True)
    if row["volume_difference"] is not None:
        assert row["volume_difference"] < 1e-9
    if NEF not in absent:
        assert findings.status is Status.MET
        assert row["ratio"] > 0 and not row["ratio_is_a_bound"]
        assert row["processor"]["minkref"] > 0
        assert row["processor"][NEF] > 0.9 * row["processor"]["minkref"]


def test_a_call_beyond_the_limit_is_ended_and_the_next_one_answered() -> None:
    large = triangulated_torus(60, 20, 3000, 1000)
    with Tools(0.05) as tools:
        assert tools.exact(large, large).why == "no answer in 0.05 s"
    with Tools(60) as tools:
        assert tools.exact(TORUS, plate(1, 1, 1)).volume is not None


def test_the_seconds_of_nef_are_those_of_the_call() -> None:
    with NefJudge(60) as nef:
        if nef.absence:
            pytest.skip(nef.absence)
        answer = nef.timed_sum(TORUS, plate(20, 30, 40))
        assert answer.text is not None and answer.seconds is not None and answer.seconds > 0
    with NefJudge(0.01) as nef:
        answer = nef.timed_sum(TORUS, TORUS)
        assert answer.text is None and "no answer in 0.01 s" in answer.why


def test_a_large_pair_is_judged() -> None:
    row = judge((4, Size.QUICK))  # a plate with bores
    assert row["messages"] == []
    assert row["compared"][-1] == "points"
    assert row["difference"] is None or row["difference"] < 1e-9


def test_the_plot_has_a_curve_for_each_tool_that_answered(tmp_path: Path) -> None:
    rows = [
        {"family": "knots", "facets": 10**k, "minkref": 0.1 * k, NEF: 9.0 * k, "manifold3d": None}
        for k in (1, 2, 3)
    ]
    path = tmp_path / "plot.svg"
    draw(rows, path)
    text = path.read_text(encoding="utf-8")
    assert "knots" in text and "CGAL" in text and "Manifold" not in text
    draw(rows, path)
    assert path.read_text(encoding="utf-8") == text
