"""Plots of a convex update's costs: against errors mended, and against size."""

from __future__ import annotations

from pathlib import Path
from typing import Any

Row = dict[str, Any]


def draw(by_errors: list[Row], by_size: list[Row], target: Path) -> None:
    """Writes an SVG: microseconds for an update, for coordinates alone, and for a sum from
    scratch."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "minkref"  # the same file from the same figures
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for axes, rows, key, what in (
        (left, by_errors, "errors", "errors mended in an update"),
        (right, by_size, "facets", "facets of each operand; steps within 1 %"),
    ):
        at = [row[key] for row in rows]
        for name, style in (("update", "o-"), ("coordinates", "s--"), ("traversal", "^:")):
            axes.plot(at, [row[name] * 1e6 for row in rows], style, label=name)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(what)
        axes.set_ylabel("microseconds (median)")
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    figure.savefig(target, metadata={"Date": None})
    pyplot.close(figure)
