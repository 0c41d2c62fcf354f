"""Entries for Fig. 7 and 8, for both pairs' edges and events, and for pre-processing times."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median
from typing import Any

from minkref import _core
from minkref.reports.audit.paper_numbers import EDGES, EVENTS
from minkref.reports.bench.pairs import Pair
from minkref.reports.paper import drawings
from minkref.reports.paper.entry import Claim, Entry, Picture, Table
from minkref.reports.paper.plots import speedup_plot, time_plot
from minkref.reports.paper.speedups import REPETITIONS, Rescaling, Speedups

COMMAND = "minkref report paper"
PAPER_TIMES = {("monkey", "bird"): (140.0, 28.7), ("neuron", "disc"): (5.3, 1.25)}
LEAST_FOR_RANKS = 12  # re-scalings: fewer give no rank correlation
FEW = 100  # re-scalings per average, as many as the paper's
MICRO = 1e6


def is_disc(pair: str) -> bool:
    return pair.startswith("disc")


def _names(pair: str) -> tuple[str, str]:
    """The paper's names for the pair."""
    return ("neuron", "disc") if is_disc(pair) else ("monkey", "bird")


def figure(pair: Pair, runs: Sequence[Speedups], absent: str) -> Entry:
    """The entry for one pair, in one or more arithmetics."""
    of_disc = is_disc(pair.name)
    about = ". ".join(_told(found) for found in runs)
    why = (
        f"The paper's own program, each formula in its right form, with events of pairs of edges "
        f"alone: stepping through them and placing all intersections, against finding the "
        f"intersections of all pairs of edges afresh in the same arithmetic, at random re-scalings "
        f"out of 0.1, 0.2, ..., 10, each timed {REPETITIONS} times (bars: least to greatest). "
        f"{about}.{_left_out(runs)} Counts of events and intersections are not the paper's (see "
        f"the audit), nor is the machine, so the points are not those of its figure, "
        f"whose speed-ups go up to some {250 if of_disc else 140}. {absent}"
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
                   "search (s)", "speedup", "least", "greatest"]  # fmt: skip
        tables.append(Table(name, columns, [_point(one) for one in found.rescalings]))
    claims = [*(claim for found in runs for claim in _claims(found)), *more]
    return Entry("Fig. 8" if of_disc else "Fig. 7", f"Speed-up of {pair.name}", why.strip(),
                 COMMAND, claims, not absent and not of_disc, pictures, tables)  # fmt: skip


def _told(found: Speedups) -> str:
    speed = [one.speedup for one in found.rescalings]
    return (
        f"In {found.arithmetic}, {len(speed)} re-scalings: {min(speed):,.0f} to {max(speed):,.0f} "
        f"times faster, median {median(speed):,.0f}"
    )


def _left_out(runs: Sequence[Speedups]) -> str:
    if any(found.arithmetic != "double" for found in runs):
        return ""
    pairs = runs[0].pairs
    return f" In MPFR, as the paper has it, {pairs:,} pairs of edges would take too long here."


def _claims(found: Speedups) -> list[Claim]:
    slowest = min(one.speedup for one in found.rescalings)
    claims = [
        Claim(f"{found.arithmetic}: the update is faster than finding the intersections afresh",
              f"at least {slowest:,.1f} times", slowest > 1)
    ]  # fmt: skip
    if len(found.rescalings) >= LEAST_FOR_RANKS:
        by_events = found.correlation_of(lambda one: one.speedup, lambda one: one.events)
        by_updated = found.correlation_of(lambda one: one.speedup, lambda one: one.updated)
        claims.append(
            Claim(f"{found.arithmetic}: events processed predict the speed-up better than "
                  "intersections updated do",
                  f"rank correlations {by_events:+.2f} and {by_updated:+.2f}",
                  abs(by_events) > abs(by_updated))
        )  # fmt: skip
        by_factor = found.correlation_of(lambda one: one.update_seconds, lambda one: one.factor)
        claims.append(
            Claim(f"{found.arithmetic}: for larger changes of the scale the update takes longer",
                  f"rank correlation of its time with the factor {by_factor:+.2f}", by_factor > 0)
        )  # fmt: skip
    return claims


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
            round(one.update_seconds, 7), round(median(one.theirs), 6), *speed]  # fmt: skip


def sizes(pair: Pair, absent: str) -> Entry:
    stated = EDGES[_names(pair.name)]
    found = len(_core.reduced_convolution(pair.P.set, pair.Q.set))
    of_disc = is_disc(pair.name)
    why = (
        "The number depends on the phase of the disc, which is not given (see the audit)."
        if of_disc
        else "Counted by the rule of ends that we use."
    )
    claim = Claim(f"{stated:,} edges", f"{found:,}", found == stated)
    return Entry("Section 7.1", f"Edges of the convolution of {pair.name}",
                 f"{why} {absent}".strip(), COMMAND, [claim],
                 not absent and not of_disc)  # fmt: skip


def events(pair: Pair, absent: str) -> Entry:
    stated = EVENTS[_names(pair.name)]
    counts = _core.pair_events(pair.P.set, pair.Q.set, kind="pair").counts()
    found = counts["count"]
    why = (
        "No rule of counting that we tried gives that of the paper (see the audit). Ours are the "
        "positive ends of the intervals in which two edges that are not parallel meet."
    )
    claim = Claim(f"{stated:,} events of pairs of edges", f"{found:,}", found == stated)
    return Entry("Section 7.1", f"Events of {pair.name}", f"{why} {absent}".strip(), COMMAND,
                 [claim], not absent and not is_disc(pair.name))  # fmt: skip


COLUMNS = ["pair", "where", "pairs of edges", "nodes (s)", "events (s)", "events over nodes",
           "nodes, microseconds a pair", "events, microseconds a pair",
           "re-scalings to break even"]  # fmt: skip


def times(runs: Sequence[Speedups], exact: Sequence[tuple[Pair, float]]) -> Entry:
    """`exact`: seconds for finding all pair events exactly, and nothing else."""
    rows: list[list[Any]] = []
    for pair, seconds in exact:
        ours = [found for found in runs if found.pair == pair.name]
        pairs = ours[0].pairs
        nodes, whole = PAPER_TIMES[_names(pair.name)]
        rows.append(_row(pair.name, "the paper, MPFR", pairs, nodes, whole, ""))
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
        "Both in the arithmetic of the row, on one core of this machine, and the paper's on its "
        "own. How the paper's program finds its events is not said in such detail that its ratio "
        "could be tried: here each formula of Section 4 is evaluated for each pair, which asks for "
        "two intersections and four conditions where a node asks for one intersection. The last "
        "column is the number of re-scalings from which on finding the events pays."
    )
    return Entry("Section 7.1", "Times of the pre-processing", why, COMMAND,
                 _time_claims(runs, exact), tables=[Table("times", COLUMNS, rows)])  # fmt: skip


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
        claims.append(
            Claim("a small number of queries makes up for the pre-processing",
                  f"{where}: {found.break_even:,.1f} re-scalings", 0 < found.break_even <= FEW)
        )  # fmt: skip
        if found.arithmetic.startswith("mpfr"):
            claims.append(
                Claim("finding the events takes a fraction of the time of finding the nodes in "
                      "MPFR",
                      f"{where}: each formula evaluated for each pair takes "
                      f"{found.preprocessing / found.search:,.1f} times as long as the nodes, our "
                      f"exact search for events {seconds[found.pair] / found.search:.3f} times",
                      seconds[found.pair] < found.search)
            )  # fmt: skip
    return claims
