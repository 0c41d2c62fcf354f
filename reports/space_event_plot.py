"""A plot of the speed of finding events between facets."""

from __future__ import annotations

from pathlib import Path
from typing import Any


def draw(rows: list[dict[str, Any]], theirs: float, target: Path) -> None:
    """Seconds against events of two facets, for these alone and with those of three and four; and
    events a second and core beside the paper's rate `theirs`. SVG."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "minkref"  # the same file from the same figures
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for of, style, label in (
        ("two", "o-", "events of two facets"), ("all", "s--", "and of three and four"),
    ):  # fmt: skip
        own = sorted((row for row in rows if row["of"] == of), key=lambda row: row["events"])
        left.plot([r["events"] for r in own], [r["seconds"] for r in own], style, label=label)
    left.set_xscale("log")
    left.set_yscale("log")
    left.set_xlabel("events of two facets")
    left.set_ylabel("seconds on two threads")
    left.grid(alpha=0.3)
    left.legend(fontsize=8)
    own = [row for row in rows if row["of"] == "two"]
    names = [row["name"].replace(" + ", "\n+ ") for row in own]
    right.barh(names, [row["events"] / row["processor"] for row in own])
    right.axvline(theirs, color="black", linestyle=":", label="the paper's, of its own models")
    right.set_xscale("log")
    right.set_xlabel("events of two facets a second and core")
    right.tick_params(axis="y", labelsize=8)
    right.legend(fontsize=8)
    figure.savefig(target, format="svg", metadata={"Date": None})
    pyplot.close(figure)
