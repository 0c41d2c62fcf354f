"""A plot of the paper's method against the precision of its arithmetic."""

from __future__ import annotations

from pathlib import Path
from typing import Any

Table = dict[str, dict[str, Any]]


def draw(tables: dict[str, Table], target: Path) -> None:
    """Writes an SVG with one line for each group of operands and form, over mpfr's bits: the share
    of solves with a root but called inconsistent, and the share of missed events."""
    import matplotlib as mpl

    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "minkref"  # the same file from the same figures
    from matplotlib import pyplot

    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for title, table in tables.items():
        for form, style in (("printed", "o-"), ("corrected", "s--")):
            rows = {
                int(name.split(",")[0].removeprefix("mpfr:")): row
                for name, row in table.items()
                if name.startswith("mpfr:") and name.endswith(f", {form}")
            }
            bits = sorted(rows)
            label = f"{title}, {form}"
            if form == "printed":
                shares = [100 * rows[b]["share called inconsistent"] for b in bits]
                left.plot(bits, shares, style, label=label)
            missed = [100 * rows[b]["missed"] / max(rows[b]["events"], 1) for b in bits]
            right.plot(bits, missed, style, label=label)
    for axes, what in ((left, "solves with a root called inconsistent, %"),
                       (right, "events missed, %")):  # fmt: skip
        axes.set_xscale("log", base=2)
        axes.set_xlabel("bits of precision")
        axes.set_ylabel(what)
        axes.set_ylim(0, 100)
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    figure.savefig(target, metadata={"Date": None})
    pyplot.close(figure)
