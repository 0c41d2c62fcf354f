"""Plots as SVG, by matplotlib; the same data go to CSV and JSON beside the page."""

from __future__ import annotations

import io
import re
from collections.abc import Sequence
from statistics import median

import matplotlib as mpl
from matplotlib.figure import Figure
from minkref.reports.paper.speedups import Rescaling

SPEEDUP = "speed-up of the intersections"
SECONDS = "seconds of the update"


def speedup_plot(rescalings: Sequence[Rescaling], against: str, label: str) -> str:
    return _plot(rescalings, against, label, "ratios", SPEEDUP)


def time_plot(rescalings: Sequence[Rescaling], against: str, label: str) -> str:
    return _plot(rescalings, against, label, "seconds", SECONDS)


def _plot(rescalings: Sequence[Rescaling], against: str, label: str, what: str, name: str) -> str:
    """A point for each re-scaling, the median of its repetitions; the bar goes from the least to
    the greatest."""
    xs = [float(getattr(one, against)) for one in rescalings]
    spreads = [getattr(one, what) for one in rescalings]
    ys = [median(values) for values in spreads]
    low = [y - values[0] for y, values in zip(ys, spreads, strict=True)]
    high = [values[-1] - y for y, values in zip(ys, spreads, strict=True)]
    with mpl.rc_context({"svg.hashsalt": "minkref", "svg.fonttype": "none", "font.size": 9}):
        figure = Figure(figsize=(4.6, 3.2), layout="constrained")
        axes = figure.add_subplot()
        axes.errorbar(xs, ys, yerr=[low, high], fmt="o", markersize=3, linewidth=0.8, capsize=1.5)
        axes.set_xlabel(label)
        axes.set_ylabel(name)
        axes.set_yscale("log")
        axes.grid(alpha=0.3)
        return svg_element(figure)


def svg_element(figure: Figure) -> str:
    """An element to be put into a page, the same bytes for the same data."""
    buffer = io.StringIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None})
    without_head = re.sub(r"^.*?(?=<svg)", "", buffer.getvalue(), count=1, flags=re.DOTALL)
    return re.sub(r"<metadata>.*?</metadata>", "", without_head, flags=re.DOTALL)
