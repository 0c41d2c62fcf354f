"""The paper's tables and figures beside ours: the rule for reproducing them, the drawings, and the
timings."""

from __future__ import annotations

import csv
import io
import re

import pytest
from minkref.plane.operand import read_operand
from minkref.reports.bench.pairs import Pair
from minkref.reports.bench.rank_correlation import HOW
from minkref.reports.bench.space_pairs import PAIRS
from minkref.reports.paper import crossing_facets, drawings, moving_edges_drawn, space_drawn
from minkref.reports.paper.entry import Claim, Entry, Verdict, verdict_of
from minkref.reports.paper.page import _csv
from minkref.reports.paper.speedup_entries import figure, times
from minkref.reports.paper.speedups import REPETITIONS, Rescaling, speedups

SO, NOT_SO = (Claim("words", "Sec. 1", "tested", "found", holds) for holds in (True, False))
CHOSEN = Claim("words", "Sec. 1", "tested", "found", True, chosen=True)
OURS = ["the polygons are ours"]
SMALL = Pair(read_operand("g3"), read_operand("g1"), small=True)


@pytest.mark.parametrize(
    ("claims", "unlike", "verdict"),
    [
        ([], [], Verdict.NOT_ATTEMPTED),
        ([], OURS, Verdict.NOT_ATTEMPTED),
        ([SO], [], Verdict.REPRODUCED),
        ([SO], OURS, Verdict.IN_KIND),
        ([SO, CHOSEN], [], Verdict.CONSISTENT),
        ([SO, CHOSEN], OURS, Verdict.CONSISTENT),
        ([SO, NOT_SO], [], Verdict.NOT_REPRODUCED),
        ([CHOSEN, NOT_SO], OURS, Verdict.NOT_REPRODUCED),
    ],
)
def test_one_rule_tells_what_is_reproduced(
    claims: list[Claim], unlike: list[str], verdict: Verdict
) -> None:
    assert verdict_of(claims, unlike) == verdict
    assert Entry("p", "t", "w", "c", claims, unlike).verdict == verdict


@pytest.mark.parametrize(
    "draw",
    [drawings.figure_2, moving_edges_drawn.figure_3, space_drawn.figure_4, space_drawn.figure_5],
)
def test_what_the_paper_draws_is_so_in_our_drawings(draw: object) -> None:
    assert callable(draw)
    pictures, claims = draw()
    assert len(pictures) >= 1 and len(claims) >= 2
    assert all(one.svg.startswith("<svg") and one.svg.count("<path") >= 1 for one in pictures)
    assert [claim for claim in claims if not claim.holds] == []


def test_the_disc_of_a_figure_is_drawn_as_a_true_one() -> None:
    pair = Pair(read_operand("disc1"), read_operand("g1"), small=False)
    pictures, claims = drawings.with_true_disc(pair)
    assert all(claim.holds for claim in claims) and len(pictures) == 2
    assert " A" not in pictures[0].svg and len(re.findall("A[0-9]", pictures[1].svg)) > 10


@pytest.mark.parametrize("arithmetic", ["double", "mpfr:53"])
def test_both_sides_of_a_speed_up_are_of_one_arithmetic(arithmetic: str) -> None:
    """The same pairs and scales in each; each re-scaling has all its repetitions."""
    found = speedups(SMALL, arithmetic, 4, lambda text: None)
    exact = speedups(SMALL, "rational", 4, lambda text: None)
    assert (found.arithmetic, found.pairs) == (arithmetic, exact.pairs)
    assert len(found.rescalings) == 4 and found.preprocessing > 0
    for one, other in zip(found.rescalings, exact.rescalings, strict=True):
        assert (one.start, one.scale) == (other.start, other.scale)
        assert len(one.ours) == len(one.theirs) == REPETITIONS
        assert one.updated > 0 and other.updated > 0
        assert one.factor > 1 and one.speedup == one.ratios[REPETITIONS // 2]


def test_a_rescaling_tells_how_far_it_goes() -> None:
    assert Rescaling("2", "1/2", 1, 1, (1.0,), (3.0,)).factor == 4
    assert Rescaling("1/2", "2", 1, 1, (1.0,), (3.0,)).factor == 4


def test_a_figure_states_what_was_run() -> None:
    found = speedups(SMALL, "double", 12, lambda text: None)
    entry = figure(SMALL, [found], "")
    assert "in the same arithmetic" in entry.why and HOW in entry.why
    assert len(entry.claims) == 4 and len(entry.pictures) == 2 + 4
    assert any("MPFR" in text for text in entry.unlike) and entry.verdict != Verdict.REPRODUCED
    assert all("<svg" in one.svg for one in entry.pictures)
    rows = list(csv.DictReader(io.StringIO(_csv(entry.tables[0]))))
    assert [int(row["events"]) for row in rows] == [one.events for one in found.rescalings]
    for one in found.rescalings:
        assert all(part <= whole for part, whole in zip(one.stepping, one.ours, strict=True))
    table = times([found], [(SMALL, 0.5)]).tables[0]
    assert [row[1] for row in table.rows] == [
        "the paper, MPFR, its own machine", "the paper's program in double",
        "our exact events of pairs",
    ]  # fmt: skip


def test_what_another_program_does_decides_no_verdict_on_the_papers_times() -> None:
    """However fast our own search for events is: the paper's program takes longer than the
    nodes."""
    found = speedups(SMALL, "double", 4, lambda text: None)
    assert found.preprocessing > found.search
    for seconds in (0.0, 1e9):
        claims = times([found], [(SMALL, seconds)]).claims
        assert [claim.holds for claim in claims if "is a fraction of" in claim.words] == [False]


def test_a_step_in_space_has_an_event() -> None:
    """So no ratio is one of the clock's resolution alone."""
    found, counts, _ = crossing_facets._followed(PAIRS[1], 1, 3)
    assert len(found.rescalings) == 3 and counts["events"] > 0
    for one in found.rescalings:
        assert one.events > 0 and len(one.ours) == crossing_facets.REPETITIONS
        assert one.best == min(one.theirs) / min(one.ours)
