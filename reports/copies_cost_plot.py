"""Plots of the costs of scenes against their numbers of copies."""

from __future__ import annotations

from pathlib import Path
from typing import Any

Row = dict[str, Any]
CURVES = (
    ("union", "union, with indices and canonical form"),
    ("cgal", "CGAL: its sums and their join"),
    ("change", "one change"),
    ("change_with_form", "one change, with the canonical form of all"),
)


def draw(rows: list[Row], target: Path) -> None:
    """A curve for each thing that was timed. SVG."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "minkref"  # the same file from the same figures
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(6.4, 4.2), layout="constrained")
    for (key, what), style in zip(CURVES, "os^v", strict=True):
        own = sorted((row["copies"], row[key]) for row in rows if row.get(key) is not None)
        if own:
            axes.plot([n for n, _ in own], [s for _, s in own], f"{style}-", label=what)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("copies")
    axes.set_ylabel("seconds")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    figure.savefig(target, format="svg", metadata={"Date": None})
    pyplot.close(figure)
