"""Plot of processor time against size: sums by the program extracted from proofs, and ours."""

from __future__ import annotations

from pathlib import Path
from typing import Any


def draw(rows: list[dict[str, Any]], target: Path) -> None:
    """Two curves for each family, the program's solid, the reference's dashed; SVG."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "minkref"  # the same file from the same figures
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7, 4.5), layout="constrained")
    families = dict.fromkeys(row["family"] for row in rows)
    for family, style, color in zip(families, "os^D", ("C0", "C1", "C2", "C3"), strict=False):
        own = [row for row in rows if row["family"] == family]
        sizes = [row["corners"] for row in own]
        for who, line, name in (("program", "-", "proved"), ("reference", "--", "reference")):
            axes.plot(
                sizes, [row[who] for row in own], style + line, color=color,
                label=f"{family}, {name}",
            )  # fmt: skip
    axes.set(xscale="log", yscale="log", xlabel="corners of P, and of Q",
             ylabel="seconds of processor")  # fmt: skip
    ticks = sorted({row["corners"] for row in rows})
    axes.set_xticks(ticks, [str(tick) for tick in ticks])
    axes.minorticks_off()
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    figure.savefig(target, format="svg", metadata={"Date": None})
    pyplot.close(figure)
