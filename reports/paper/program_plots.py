"""Plots of how often the paper's own program has the right sum, as elements of SVG."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import AbstractContextManager

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from minkref.reports.paper.plots import svg_element
from minkref.reports.paper.program_runs import CORRECTED, Run, Runs, share

RATIONAL = "rational"
ROUNDING = ("double", "mpfr:53", "mpfr:100", "mpfr:200", "mpfr:1000")
BLAMED = (RATIONAL, "double", "mpfr:200")  # most pairs are tried in these
BY_PAIR = (CORRECTED, "solve as printed")


def style() -> AbstractContextManager[None]:
    return mpl.rc_context({"svg.hashsalt": "minkref", "svg.fonttype": "none", "font.size": 9})


def tried_in_all(runs: Runs, variant: str, arithmetics: Sequence[str]) -> set[str]:
    """The pairs tried in all the arithmetics."""
    tried = [{run.name for run in runs.of(variant, arithmetic)} for arithmetic in arithmetics]
    return set.intersection(*tried)


def of_pairs(found: Sequence[Run], names: set[str]) -> list[Run]:
    return [run for run in found if run.name in names]


def precision_plot(runs: Runs) -> str:
    """For each program, the share of right pairs after each number of re-scalings, among pairs
    tried in all arithmetics."""
    with style():
        figure = Figure(figsize=(10.5, 3.9), layout="constrained")
        panels = figure.subplots(1, len(runs.after), sharey=True)
        for k, (panel, count) in enumerate(zip(panels, runs.after, strict=True)):
            for number, variant in enumerate(runs.variants):
                names = tried_in_all(runs, variant, ROUNDING)
                if not names:
                    continue
                shares = [
                    share(of_pairs(runs.of(variant, arithmetic), names), k)
                    for arithmetic in ROUNDING
                ]
                panel.plot(
                    range(len(ROUNDING)), shares, "osv^D<>pP*X"[number % 11] + "-",
                    markersize=4, linewidth=1, label=f"{variant} ({len(names)} pairs)",
                )  # fmt: skip
            panel.set_title(f"after {count} re-scaling{'s' * (count > 1)}", fontsize=9)
            panel.set_xticks(range(len(ROUNDING)), ROUNDING, rotation=30)
            panel.set_ylim(-4, 104)
            panel.grid(alpha=0.3)
        panels[0].set_ylabel("right, % of the pairs")
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside lower center", ncols=3, fontsize=8)
        return svg_element(figure)


def pairs_plot(runs: Runs) -> str:
    """Plots by pair and arithmetic whether the sum was right after each number of re-scalings,
    for the program with all formulas corrected, and with the solve as printed."""
    arithmetics = (RATIONAL, *ROUNDING)
    names = runs.names()
    with style():
        figure = Figure(figsize=(10.5, 0.21 * len(names) + 1.4), layout="constrained")
        panels = figure.subplots(1, len(BY_PAIR), sharey=True)
        colours = mpl.colormaps["RdYlGn"].resampled(len(runs.after) + 1)
        for panel, variant in zip(panels, BY_PAIR, strict=True):
            by_place = {(r.name, r.arithmetic): r for r in runs.runs if r.variant == variant}
            for y, name in enumerate(names):
                for x, arithmetic in enumerate(arithmetics):
                    run = by_place.get((name, arithmetic))
                    if run is None:
                        panel.text(x, y, "-", ha="center", va="center", color="0.6")
                        continue
                    colour = colours(sum(run.right))
                    panel.add_patch(
                        Rectangle((x - 0.48, y - 0.46), 0.96, 0.92, color=colour, alpha=0.45)
                    )
                    told = "".join("+" if right else "\N{MINUS SIGN}" for right in run.right)
                    panel.text(x, y, told, ha="center", va="center", fontsize=7)
            panel.set_title(variant, fontsize=9)
            panel.set_xticks(range(len(arithmetics)), arithmetics, rotation=30)
            panel.set_yticks(range(len(names)), names)
            panel.set_xlim(-0.5, len(arithmetics) - 0.5)
            panel.set_ylim(len(names) - 0.5, -0.5)
        return svg_element(figure)


def blame_plot(runs: Runs) -> str:
    """For each formula used alone as printed, the share of pairs wrong at the end."""
    shown = [variant for variant in runs.variants if tried_in_all(runs, variant, BLAMED)]
    with style():
        figure = Figure(figsize=(7.2, 0.42 * len(shown) + 1.0), layout="constrained")
        axes = figure.add_subplot()
        height = 0.8 / len(BLAMED)
        for number, arithmetic in enumerate(BLAMED):
            wrong = []
            for variant in shown:
                names = tried_in_all(runs, variant, BLAMED)
                wrong.append(100 - share(of_pairs(runs.of(variant, arithmetic), names), -1))
            places = [y + (number - 1) * height for y in range(len(shown))]
            bars = axes.barh(places, wrong, height, label=arithmetic)
            axes.bar_label(bars, fmt="%.0f", padding=2, fontsize=7)
        _ticks(axes, shown)
        axes.set_xlabel(f"wrong after {runs.after[-1]} re-scalings, % of the pairs")
        axes.set_xlim(0, 108)
        axes.legend(fontsize=8)
        return svg_element(figure)


def _ticks(axes: Axes, names: Sequence[str]) -> None:
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.grid(alpha=0.3, axis="x")


def time_plot(runs: Runs) -> str:
    """Plots each operand pair's processor time for a pair of edges, all formulas corrected."""
    arithmetics = (RATIONAL, *ROUNDING)
    with style():
        figure = Figure(figsize=(5.4, 3.4), layout="constrained")
        axes = figure.add_subplot()
        for x, arithmetic in enumerate(arithmetics):
            found = runs.of(CORRECTED, arithmetic)
            axes.plot([x] * len(found), [microseconds([run]) for run in found], "o", markersize=3,
                      alpha=0.6)  # fmt: skip
        axes.set_xticks(range(len(arithmetics)), arithmetics, rotation=30)
        axes.set_yscale("log")
        axes.set_ylabel("µs for a pair of edges")
        axes.grid(alpha=0.3)
        return svg_element(figure)


def microseconds(found: Sequence[Run]) -> float:
    """Microseconds per edge pair, over all runs."""
    pairs = sum(run.pairs for run in found)
    return 1e6 * sum(run.seconds for run in found) / pairs if pairs else 0.0
