"""The entry on Fig. 9 (c) and (d) by the paper's own program, from the times of the evidence."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median, quantiles

from matplotlib.figure import Figure
from minkref.reports.paper.entry import Claim, Entry, Picture, Table
from minkref.reports.paper.plots import svg_element
from minkref.reports.paper.program_plots import style
from minkref.reports.paper.space_times import Timed, Times

COMMAND = "make evidence ONLY=paper_program/space_times FULL=1"
TITLE = "Updates in space by the paper's own program, on smaller pairs"
DOUBLE, MPFR = "double", "mpfr:53"
SIMILAR = (
    "We see a similar asymptotic behavior in speed-up over recomputing the line intersections from "
    "scratch, as we do in 2D"
)
OVERALL = "the enumerative method does not provide a significant increase in speed"
SIGNIFICANT = 2  # times faster: where the axis of Fig. 9 (c) ends
LEAST_FOR_RANKS = 12
LARGER = ("knot 992 + clutch 352", 12_207)  # of the entry on exact events
MICRO = 1e6


def space_times_entry(times: Times | None) -> Entry:
    """Without times the entry only says so."""
    if times is None or not times.runs:
        return Entry("Fig. 9", TITLE, f"No times have been kept: {COMMAND} makes them.", COMMAND)
    why = (
        f"Section 5 with all formulas corrected, on {len(times.names())} pairs, in doubles and in "
        f"MPFR of 53 bits: the array of events is stepped through, and all crossings are placed by "
        f"x(s) = x0 + (s - 1) sigma. From scratch the same arithmetic finds them by the system of "
        f"Section 5.2, among facets whose boxes meet, or among all pairs. For (c) both sides have "
        f"arrangements and collision detection of the same program in addition. Random re-scalings "
        f"on the window {times.window}, those without event left out: the best of "
        f"{times.repetitions} updates by the clock, which take microseconds, and of "
        f"{times.searches} searches in processor time; all pairs and (c) one time a scale, on "
        f"some of the scales where they take long. These times are of {times.date}, and are not "
        f"made again with the page."
    )
    pictures = [Picture("Times faster by pair and arithmetic: median and quartiles",
                        speed_plot(times), True)]  # fmt: skip
    return Entry("Fig. 9", TITLE, why, COMMAND, _claims(times), _unlike(times), pictures,
                 [_runs(times), _steps(times)])  # fmt: skip


def _claims(times: Times) -> list[Claim]:
    claims = []
    for arithmetic in (MPFR, DOUBLE):
        runs = times.of(arithmetic)
        if runs:
            claims += [_faster(arithmetic, runs), _falls(arithmetic, runs)]
            claims.append(_overall(arithmetic, runs))
    return claims


def _faster(arithmetic: str, runs: Sequence[Timed]) -> Claim:
    least = min(run.intersections()[0] for run in runs)
    return Claim(
        SIMILAR, "Sec. 7.2.1", f"(d), {arithmetic}: each update with its placing is faster than "
        "finding the crossings among facets whose boxes meet",
        f"{least:,.1f} times at least; medians {_medians([run.intersections() for run in runs])}; "
        f"against all pairs {_medians([run.intersections(True) for run in runs])}", least > 1,
    )  # fmt: skip


def _falls(arithmetic: str, runs: Sequence[Timed]) -> Claim:
    found = [run.falls() for run in runs if len(run.steps) >= LEAST_FOR_RANKS]
    below = sum(one.high < 0 for one in found)
    return Claim(
        SIMILAR, "Sec. 7.2.1", f"(d), {arithmetic}: the speed-up falls with the number of events: "
        "the interval of their rank correlation is below 0 for each pair",
        f"below 0 for {below} of {len(found)} pairs: " + ", ".join(map(str, found)),
        bool(found) and below == len(found),
    )  # fmt: skip


def _overall(arithmetic: str, runs: Sequence[Timed]) -> Claim:
    totals, of_all = ([run.total(which) for run in runs] for which in (False, True))
    holds, holds_of_all = (
        all(median(total) < SIGNIFICANT for total in found) for found in (totals, of_all)
    )
    return Claim(
        OVERALL, "Sec. 7.2.1", f"(c), {arithmetic}: the median is below {SIGNIFICANT} for each "
        f"pair, where the axis of the figure ends, against facets whose boxes meet",
        f"medians {_medians(totals)}; against all pairs {_medians(of_all)}",
        holds, chosen=not holds_of_all,
    )  # fmt: skip


def _medians(found: Sequence[Sequence[float]]) -> str:
    values = sorted(median(one) for one in found)
    if len(values) == 1:
        return f"{values[0]:,.2f}"
    return f"{values[0]:,.2f} to {values[-1]:,.2f}"


def _unlike(times: Times) -> list[str]:
    largest = max(times.runs, key=lambda run: run.facets)
    found = [
        f"the solids are ours, with {min(run.facets for run in times.runs):,} to "
        f"{largest.facets:,} facets of the convolution and at most "
        f"{max(run.events for run in times.runs):,} events, where the paper's knot and clutch have "
        f"8,427,881 by a rule of counting that it does not give",
        "the pairs of facets from scratch, which the paper does not tell: those whose boxes meet, "
        "and all of them beside",
        "arrangements and collision detection are not timed apart from each other",
    ]
    in_mpfr = times.of(MPFR)
    if in_mpfr:
        finest = max(in_mpfr, key=lambda run: run.facets)
        each = finest.preparation / finest.pairs
        pairs = LARGER[1] * (LARGER[1] - 1) // 2
        found.append(
            f"{LARGER[0]} with its {LARGER[1]:,} facets was not tried: in MPFR of 53 bits the "
            f"events of {finest.name} take {MICRO * each:,.0f} µs of processor time for a pair of "
            f"facets, so that its {pairs:,} pairs would take {each * pairs / 3600:,.1f} hours"
        )
    return found


def _runs(times: Times) -> Table:
    columns = ["pair", "arithmetic", "bits", "facets", "events", "events (s)", "a search of all "
               "pairs (s)", "re-scalings", "crossings placed", "update with placing (µs)",
               "(d) least", "(d)", "(d) most", "(d) all pairs", "(c) least", "(c)", "(c) most",
               "(c) all pairs", "re-scalings to break even"]  # fmt: skip
    return Table("figure9_program", columns, [_run(run) for run in times.runs])


def _run(run: Timed) -> list[object]:
    saved = median(step.near - step.ours for step in run.steps)
    parts = (_told(run.intersections(), run.intersections(True), 1),
             _told(run.total(), run.total(True), 3))  # fmt: skip
    return [
        run.name, run.arithmetic, 53, run.facets, run.events, round(run.preparation, 2),
        round(run.search, 3), len(run.steps), round(median(step.crossings for step in run.steps)),
        round(MICRO * median(step.ours for step in run.steps), 1), *parts[0], *parts[1],
        round(run.preparation / saved) if saved > 0 else "never",
    ]  # fmt: skip


def _told(near: Sequence[float], of_all: Sequence[float], digits: int) -> list[float]:
    values = (near[0], median(near), near[-1], median(of_all))
    return [round(value, digits) for value in values]


def _steps(times: Times) -> Table:
    columns = ["pair", "arithmetic", "from", "to", "events", "crossings", "update (s)",
               "placing (s)", "from scratch (s)", "arrangements and collisions (s)",
               "(d)"]  # fmt: skip
    rows = [
        [run.name, run.arithmetic, step.start, step.scale, step.events, step.crossings,
         step.update, step.placing, step.near, "" if step.whole is None else step.whole,
         round(step.near / step.ours, 2)]
        for run in times.runs for step in run.steps
    ]  # fmt: skip
    return Table("figure9_steps", columns, rows)


def speed_plot(times: Times) -> str:
    """Both parts side by side: a point for each pair, arithmetic and search from scratch."""
    names = times.names()
    with style():
        figure = Figure(figsize=(10.5, 0.5 * len(names) + 1.7), layout="constrained")
        panels = figure.subplots(1, 2, sharey=True)
        for panel, part in zip(panels, ("(d) intersections alone", "(c) the whole"), strict=True):
            for number, (arithmetic, of_all) in enumerate(
                (a, b) for a in (MPFR, DOUBLE) for b in (False, True)
            ):
                runs = times.of(arithmetic)
                found = [_of_part(run, part[1], of_all) for run in runs]
                places = [names.index(run.name) + 0.17 * (number - 1.5) for run in runs]
                middle = [one[1] for one in found]
                low = [one[1] - one[0] for one in found]
                high = [one[2] - one[1] for one in found]
                against = "all pairs" if of_all else "boxes that meet"
                panel.errorbar(
                    middle, places, xerr=[low, high], fmt="os^D"[number], markersize=4,
                    linewidth=0.8, capsize=2, label=f"{arithmetic}, {against}",
                )  # fmt: skip
            panel.axvline(1, color="0.6", linewidth=0.8)
            panel.set_title(part, fontsize=9)
            panel.set_xscale("log")
            panel.set_xlabel("times faster")
            panel.grid(alpha=0.3)
        panels[0].set_yticks(range(len(names)), names)
        panels[0].invert_yaxis()
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=4, fontsize=8)
        return svg_element(figure)


def _of_part(run: Timed, part: str, of_all: bool) -> list[float]:
    """The quartiles of part (c) or (d)."""
    values = run.total(of_all) if part == "c" else run.intersections(of_all)
    return quantiles(values, n=4, method="inclusive") if len(values) > 1 else 3 * values
