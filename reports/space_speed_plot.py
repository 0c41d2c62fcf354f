"""Plots of the seconds for sums of growing polyhedra, by tool."""

from __future__ import annotations

from pathlib import Path
from typing import Any

Row = dict[str, Any]

TOOLS = (
    ("minkref", "minkref, exact, two threads"),
    ("cgal-nef", "CGAL, Nef polyhedra, exact"),
    ("manifold3d", "Manifold, doubles"),
)


def draw(rows: list[Row], target: Path) -> None:
    """A panel for each family, a curve for each tool against the triangles of both. SVG."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "minkref"  # the same file from the same figures
    from matplotlib import pyplot

    families = list(dict.fromkeys(row["family"] for row in rows))
    figure, panels = pyplot.subplots(
        1, len(families), figsize=(10, 4), layout="constrained", squeeze=False
    )
    for axes, family in zip(panels[0], families, strict=True):
        for (tool, what), style in zip(TOOLS, "o^s", strict=True):
            own = [row for row in rows if row["family"] == family and row[tool] is not None]
            if own:
                at = [row["facets"] for row in own]
                axes.plot(at, [row[tool] for row in own], f"{style}-", label=what)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(family, fontsize=10)
        axes.set_xlabel("triangles of both operands")
        axes.set_ylabel("seconds")
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    figure.savefig(target, format="svg", metadata={"Date": None})
    pyplot.close(figure)
