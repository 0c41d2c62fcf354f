"""Entries for Fig. 7 and 8, for both pairs' edges and events, and for pre-processing times."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from statistics import median
from typing import Any

from minkref import _core
from minkref.reports.audit.paper_numbers import EDGES, EVENTS
from minkref.reports.audit.plane import regular
from minkref.reports.bench.pairs import Pair
from minkref.reports.bench.rank_correlation import HOW, Interval
from minkref.reports.bench.spread import spread
from minkref.reports.paper import drawings
from minkref.reports.paper.entry import Claim, Entry, Picture, Table
from minkref.reports.paper.plots import speedup_plot, time_plot
from minkref.reports.paper.speedups import REPETITIONS, Rescaling, Speedups

COMMAND = "minkref report paper"
PAPER_TIMES = {("monkey", "bird"): (140.0, 28.7), ("neuron", "disc"): (5.3, 1.25)}
LEAST_FOR_RANKS = 12  # re-scalings: fewer give no rank correlation
FEW = 100  # re-scalings per average, as many as the paper's
MICRO = 1e6
ORDER = 10  # of magnitude
GOOD = 0.5  # a rank correlation of this size predicts well, a threshold of ours
PHASES = 400  # of the disc of 32 corners


def is_disc(pair: str) -> bool:
    return pair.startswith("disc")


def _names(pair: str) -> tuple[str, str]:
    """The paper's names for the pair."""
    return ("neuron", "disc") if is_disc(pair) else ("monkey", "bird")


def figure(pair: Pair, runs: Sequence[Speedups], absent: str) -> Entry:
    """The entry for a pair, with at least one arithmetic."""
    of_disc = is_disc(pair.name)
    about = ". ".join(_told(found) for found in runs)
    why = (
        f"The paper's own program, each formula in its right form, with events of pairs of edges "
        f"alone: stepping through them and placing all intersections, against finding the "
        f"intersections of all pairs of edges afresh in the same arithmetic, at random re-scalings "
        f"out of 0.1, 0.2, ..., 10, each timed {REPETITIONS} times (bars: least to greatest). "
        f"{about}. Correlations are of ranks (Spearman), with {HOW}."
    )
    more: list[Claim] = []
    if of_disc:
        pictures, more = drawings.with_true_disc(pair)
    else:
        pictures = drawings.figure_7_inputs(pair)
    tables = []
    for found in runs:
        pictures += _pictures(found)
        name = f"{'figure8' if of_disc else 'figure7'}_{found.arithmetic.replace(':', '')}"
        columns = ["from", "to", "events", "updated", "factor of the scale", "update (s)",
                   "of it stepping (s)", "search (s)", "speedup", "least", "greatest"]  # fmt: skip
        tables.append(Table(name, columns, [_point(one) for one in found.rescalings]))
    claims = [*(claim for found in runs for claim in _claims(found, of_disc)), *more]
    return Entry("Fig. 8" if of_disc else "Fig. 7", f"Speed-up of {pair.name}", why,
                 COMMAND, claims, _unlike(runs, of_disc, absent), pictures, tables)  # fmt: skip


def _unlike(runs: Sequence[Speedups], of_disc: bool, absent: str) -> list[str]:
    """Differences from the paper in Fig. 7 or 8."""
    stated = EVENTS["neuron" if of_disc else "monkey", "disc" if of_disc else "bird"]
    found = [absent] * bool(absent)
    if all(run.arithmetic == "double" for run in runs):
        found.append(f"doubles, where the paper has MPFR, in which {runs[0].pairs:,} pairs of "
                     "edges would take too long here")  # fmt: skip
    if of_disc:
        found.append("the phase and the radius of the disc are ours")
    crossed = max(one.events for run in runs for one in run.rescalings)
    axis, updated = (
        (1_200_000, "10,000 to 30,000") if of_disc else (45_000_000, "200,000 to 400,000")
    )
    placed = [one.updated for run in runs for one in run.rescalings]
    found.append(
        f"the counts: at most {crossed:,} events in one re-scaling, and {min(placed):,} to "
        f"{max(placed):,} intersections, where the paper's axes go to some {axis:,} events and "
        f"from {updated} intersections, of {stated:,} events in all by its text"
    )
    numbers = ", ".join(f"{len(run.rescalings)} in {run.arithmetic}" for run in runs)
    found.append(f"the re-scalings, {numbers}: the paper gives neither their number nor the scales")
    return found


def _told(found: Speedups) -> str:
    speed = [one.speedup for one in found.rescalings]
    return (
        f"In {found.arithmetic}, {len(speed)} re-scalings: {min(speed):,.1f} to {max(speed):,.0f} "
        f"times faster, {found.speed.in_words()}"
    )


def _claims(found: Speedups, of_disc: bool) -> list[Claim]:
    where = found.arithmetic
    claims = [
        Claim("the update method outperforms recomputing the intersections by an order of "
              "magnitude in general", "Sec. 7.1",
              f"{where}: the median speed-up is at least {ORDER}",
              found.speed.in_words(), found.speed.median >= ORDER)
    ]  # fmt: skip
    if len(found.rescalings) >= LEAST_FOR_RANKS:
        claims += [*_predictors(found, of_disc), _bottleneck(found)]
    return claims


def _speedup(one: Rescaling) -> float:
    return one.speedup


def _events(one: Rescaling) -> float:
    return one.events


def _updated(one: Rescaling) -> float:
    return one.updated


def _predictors(found: Speedups, of_disc: bool) -> list[Claim]:
    """The captions' sentences on what predicts the speed-up."""
    where = found.arithmetic
    by_events = found.correlation_of(_speedup, _events)
    by_updated = found.correlation_of(_speedup, _updated)
    ranks = f"rank correlations with the speed-up: events {by_events}, intersections {by_updated}"
    if of_disc:
        return [
            Claim("number of events processed is a good predictor for speed-up, while number of "
                  "intersections processed is not", "Fig. 8",
                  f"{where}: the interval of the events' correlation is beyond {GOOD} in size, "
                  "that of the intersections is not", ranks,
                  _beyond(by_events) and not _beyond(by_updated))
        ]  # fmt: skip
    better = found.predicted_better(_speedup, _events, _updated)
    density = found.density
    shares = [
        sum(one.events >= least * one.updated for one in found.rescalings)
        for least in (ORDER, ORDER**2)
    ]
    return [
        Claim("The number of events processed is a much better predictor of the speed gain than "
              "the number of intersections updated", "Fig. 7",
              f"{where}: the events' correlation is the stronger one, by an interval above 0",
              f"{ranks}; stronger by {better}", better.low > 0),
        Claim("events generally outstrip intersectins in number by orders of magnitude", "Fig. 7",
              f"{where}: for at least half of the re-scalings {ORDER**2} times as many events are "
              "processed as intersections updated",
              f"times as many: {density.in_words()}; {shares[0]} of {len(found.rescalings)} "
              f"re-scalings have {ORDER} times as many, {shares[1]} have {ORDER**2}",
              density.median >= ORDER**2),
    ]  # fmt: skip


def _beyond(found: Interval) -> bool:
    return min(abs(found.low), abs(found.high)) > GOOD and found.low * found.high > 0


def _bottleneck(found: Speedups) -> Claim:
    """Large jumps: the share of stepping in the update's time."""
    largest = sorted(found.rescalings, key=lambda one: one.factor)[-len(found.rescalings) // 3 :]
    shares = spread([100 * median(one.stepping) / one.update_seconds for one in largest])
    longer = found.correlation_of(lambda one: one.update_seconds, lambda one: one.factor)
    return Claim(
        "for larger scale jumps, the bottleneck of this method is in updating the events as P "
        "scales", "Sec. 7.1",
        f"{found.arithmetic}: in the third of the re-scalings with the largest factors, the median "
        "share of stepping through events in the update's time is above 50 %",
        f"{shares.in_words()} %; rank correlation of the update's time with the factor {longer}",
        shares.median > 50,
    )  # fmt: skip


def _pictures(found: Speedups) -> list[Picture]:
    plots = (
        (speedup_plot, "speed-up", "events", "events processed"),
        (speedup_plot, "speed-up", "updated", "intersections updated"),
        (time_plot, "time of the update", "events", "events processed"),
        (time_plot, "time of the update", "factor", "factor by which the scale changes"),
    )
    return [
        Picture(f"{found.arithmetic}: {what} against {label}",
                plot(found.rescalings, against, label))
        for plot, what, against, label in plots
    ]  # fmt: skip


def _point(one: Rescaling) -> list[Any]:
    ratios = one.ratios
    speed = (round(x, 2) for x in (one.speedup, ratios[0], ratios[-1]))
    return [one.start, one.scale, one.events, one.updated, round(one.factor, 3),
            round(one.update_seconds, 7), round(median(one.stepping), 7),
            round(median(one.theirs), 6), *speed]  # fmt: skip


def sizes(pair: Pair, absent: str) -> Entry:
    stated = EDGES[_names(pair.name)]
    found = len(_core.reduced_convolution(pair.P.set, pair.Q.set))
    if not is_disc(pair.name):
        claim = Claim("Their reduced convolution contains 16,425 segments", "Sec. 7.1",
                      "the count, by the rule of ends that we use; other rules give 16,421 to "
                      "16,432 (see the audit)", f"{found:,}", found == stated)  # fmt: skip
        return Entry("Section 7.1", f"Edges of the convolution of {pair.name}", "", COMMAND,
                     [claim], [absent] * bool(absent))  # fmt: skip
    counts = disc_phases(pair.Q.set)
    hits = counts.count(stated)
    claim = Claim(
        "The reduced convolution of the neuron and the disc has 3196 segments", "Sec. 7.1",
        f"the count for regular 32-gons in {len(counts)} phases is {stated:,} for some of them",
        f"{min(counts):,} to {max(counts):,} edges, {stated:,} in {hits} of {len(counts)} phases; "
        f"{found:,} with our disc", hits > 0, chosen=True,
    )  # fmt: skip
    why = "The number depends on the phase of the disc, which the paper does not give."
    return Entry("Section 7.1", f"Edges of the convolution of {pair.name}", why, COMMAND, [claim],
                 [*[absent] * bool(absent), "the phase of the disc"])  # fmt: skip


def disc_phases(other: _core.PolygonSet) -> list[int]:
    """Edges of the convolution with regular 32-gons, by phase; the radius does not matter."""
    step = 2 * pi / 32 / PHASES
    return [len(_core.reduced_convolution(regular(32, step * k), other)) for k in range(PHASES)]


def events(pair: Pair, absent: str) -> Entry:
    stated = EVENTS[_names(pair.name)]
    of_disc = is_disc(pair.name)
    counts = _core.pair_events(pair.P.set, pair.Q.set, kind="pair").counts()
    found = counts["count"]
    why = (
        "No rule of counting that we tried gives that of the paper (see the audit). Ours are the "
        "positive ends of the intervals in which two edges that are not parallel meet."
    )
    words = (
        "There are 56238 critical events discovered when the disc is scaled"
        if of_disc
        else "there are 56,996,430 critical events"
    )
    claim = Claim(words, "Sec. 7.1", "the count is the same",
                  f"{found:,} events of pairs of edges, {found / stated:.3g} times as many",
                  found == stated)  # fmt: skip
    unlike = [*[absent] * bool(absent), *["the phase of the disc"] * of_disc]
    return Entry("Section 7.1", f"Events of {pair.name}", why, COMMAND, [claim],
                 [*unlike, "the rule of counting, which the paper does not give"])  # fmt: skip


COLUMNS = ["pair", "where", "pairs of edges", "nodes (s)", "events (s)", "events over nodes",
           "nodes, microseconds a pair", "events, microseconds a pair",
           "re-scalings to break even"]  # fmt: skip


def times(runs: Sequence[Speedups], exact: Sequence[tuple[Pair, float]]) -> Entry:
    """`exact`: processor seconds for finding all pair events exactly, and nothing else."""
    rows: list[list[Any]] = []
    for pair, seconds in exact:
        ours = [found for found in runs if found.pair == pair.name]
        pairs = ours[0].pairs
        nodes, whole = PAPER_TIMES[_names(pair.name)]
        rows.append(_row(pair.name, "the paper, MPFR, its own machine", pairs, nodes, whole, ""))
        rows += [
            _row(pair.name, f"the paper's program in {found.arithmetic}", pairs, found.search,
                 found.preprocessing, round(found.break_even, 1))
            for found in ours
        ]  # fmt: skip
        rows.append([pair.name, "our exact events of pairs", pairs, "", round(seconds, 3), "", "",
                     round(seconds / pairs * MICRO, 4), ""])  # fmt: skip
    why = (
        "Nodes: finding the intersections of all pairs of edges once. Events: finding those of all "
        "pairs, without events of three edges, that the paper does not look for, and sorting them. "
        "Both in the arithmetic of the row, in processor time of this machine, in one run. Each "
        "formula of Section 4 is evaluated for each pair, which asks for two intersections and "
        "four conditions where a node asks for one intersection. Our exact search, which floats "
        "filter, is another program than the paper's, and decides no verdict here. The last column "
        "is the number of re-scalings from which on finding the events pays."
    )
    unlike = [
        "how the paper's program finds its events is told by formulas alone: any filter of pairs "
        "that it may have is not in ours",
        *(
            f"doubles alone for {pair.name}, where the paper has MPFR"
            for pair, _ in exact
            if {run.arithmetic for run in runs if run.pair == pair.name} == {"double"}
        ),
    ]
    return Entry("Section 7.1", "Times of the pre-processing", why, COMMAND,
                 _time_claims(runs, exact), unlike,
                 tables=[Table("times", COLUMNS, rows)])  # fmt: skip


def _row(
    pair: str, where: str, pairs: int, nodes: float, whole: float, break_even: float | str
) -> list[Any]:
    return [pair, where, pairs, round(nodes, 4), round(whole, 3), round(whole / nodes, 3),
            round(nodes / pairs * MICRO, 4), round(whole / pairs * MICRO, 4),
            break_even]  # fmt: skip


def _time_claims(runs: Sequence[Speedups], exact: Sequence[tuple[Pair, float]]) -> list[Claim]:
    seconds = {pair.name: taken for pair, taken in exact}
    claims = []
    for found in runs:
        where = f"{found.pair} in {found.arithmetic}"
        ratio = found.preprocessing / found.search
        numbers = (
            f"events {found.preprocessing:,.3g} s, nodes {spread(found.nodes).in_words(3)} s in "
            f"{len(found.nodes)} searches: {ratio:,.1f} times as long"
        )
        claims += [
            Claim("on average the time taken to compute the events is a fraction of the time taken "
                  "to compute the intersections", "Sec. 7.1",
                  f"{where}: the program of Section 4 finds the events of all pairs in less time "
                  "than the nodes of all pairs",
                  f"{numbers}; our exact filtered search {seconds[found.pair]:,.3g} s, in other "
                  "arithmetic", ratio < 1),
            Claim("The time to compute the scale bounds in 2D is on the order of the time "
                  "necessary to compute the intersections using brute force", "Sec. 7.1",
                  f"{where}: at most {ORDER} times as long", numbers, ratio <= ORDER),
            Claim("only a small number of queries are needed to make up the difference in "
                  "pre-computation time", "Sec. 7.1", f"{where}: at most {FEW} re-scalings",
                  f"{found.break_even:,.1f} re-scalings", 0 < found.break_even <= FEW),
        ]  # fmt: skip
    return claims
