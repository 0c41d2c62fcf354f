"""Plots of the costs of an index of all scales as the convolution grows."""

from __future__ import annotations

from pathlib import Path
from typing import Any

Row = dict[str, Any]

PANELS = (
    ("build_seconds", "seconds to build", 1.0),
    ("bytes", "megabytes", 1e-6),
    ("query_seconds", "microseconds of a query in doubles", 1e6),
)


def draw(rows: list[Row], target: Path) -> None:
    """A curve for each family against the edges of the convolution. SVG."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "minkref"  # the same file from the same figures
    from matplotlib import pyplot

    figure, panels = pyplot.subplots(1, len(PANELS), figsize=(13, 4), layout="constrained")
    for axes, (key, what, unit) in zip(panels, PANELS, strict=True):
        for family, style in zip(dict.fromkeys(row["family"] for row in rows), "o^s", strict=False):
            own = sorted((row for row in rows if row["family"] == family), key=lambda r: r["edges"])
            at = [row["edges"] for row in own]
            axes.plot(at, [row[key] * unit for row in own], f"{style}-", label=family)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel("edges of the convolution")
        axes.set_ylabel(what)
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    figure.savefig(target, format="svg", metadata={"Date": None})
    pyplot.close(figure)
