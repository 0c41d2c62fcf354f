"""Plots of processor time against the size of the input, a panel for each verb."""

from __future__ import annotations

from pathlib import Path
from typing import Any


def draw(runs: list[dict[str, Any]], target: Path) -> None:
    """A curve for each family; dotted with slope 1. SVG."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "minkref"  # the same file from the same figures
    from matplotlib import pyplot

    verbs = list(dict.fromkeys(run["job"].split(", ")[0] for run in runs))
    figure, panels = pyplot.subplots(
        2, (len(verbs) + 1) // 2, figsize=(15, 8), layout="constrained", squeeze=False
    )
    for axes, verb in zip(panels.flat, verbs, strict=False):
        own = [run for run in runs if run["job"].startswith(f"{verb}, ")]
        for name in dict.fromkeys(run["job"] for run in own):
            rows = [run for run in own if run["job"] == name]
            sizes = [run["size"] for run in rows]
            axes.plot(sizes, [run["seconds"] for run in rows], "o-", label=name.split(", ")[1])
        sizes = sorted({run["size"] for run in own})
        least = min(run["seconds"] for run in own)
        axes.plot(sizes, [least * n / sizes[0] for n in sizes], ":", color="grey", label="slope 1")
        axes.set(title=verb, xscale="log", yscale="log", xlabel="vertices or triangles",
                 ylabel="processor seconds")  # fmt: skip
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    for axes in panels.flat[len(verbs) :]:
        axes.set_axis_off()
    figure.savefig(target, format="svg", metadata={"Date": None})
    pyplot.close(figure)
