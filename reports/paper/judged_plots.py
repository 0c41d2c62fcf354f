"""Plots of the paper's programs beside other programs, as SVG elements."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from minkref.fuzz.judges.beside import AGREE, COMPARED
from minkref.fuzz.judges.plane.paper_algebra import INVENTED, MISPLACED, MISSED, RIGHT, UNDECIDED
from minkref.reports.paper.judged_runs import Judged, Row, share
from minkref.reports.paper.plots import svg_element
from minkref.reports.paper.program_plots import style

TRUE_EVENTS = (RIGHT, MISPLACED, MISSED, UNDECIDED)
MARKERS = "osv^D<>pP*X"


def sums_plot(judged: Judged) -> str:
    """Plots agreement with each other program against the bits, one panel each."""
    others = list(dict.fromkeys(row.against for row in judged.rows))
    with style():
        figure = Figure(figsize=(10.5, 3.9), layout="constrained")
        panels = figure.subplots(1, len(others), sharey=True, squeeze=False)[0]
        for panel, other in zip(panels, others, strict=True):
            for number, program in enumerate(judged.programs()):
                rows = judged.of(program, other)
                _line(
                    panel, rows, [share(row, (AGREE,), COMPARED) for row in rows], number, program
                )
            panel.set_title(other, fontsize=9)
            _bits(panel, judged)
            panel.set_ylim(-4, 104)
        panels[0].set_ylabel("agree, % of the sums")
        _legend(figure, panels)
        return svg_element(figure)


def events_plot(judged: Judged) -> str:
    """Plots missed, invented and misplaced events, relative to true events, against the bits: one
    line for each printed formula."""
    with style():
        figure = Figure(figsize=(10.5, 3.9), layout="constrained")
        panels = figure.subplots(1, 3)
        for panel, kind in zip(panels, (MISSED, INVENTED, MISPLACED), strict=True):
            for number, program in enumerate(judged.programs()):
                for other in judged.others(program):
                    rows = judged.of(program, other)
                    shares = [share(row, (kind,), TRUE_EVENTS) for row in rows]
                    _line(panel, rows, shares, number, program)
            panel.set_title(kind, fontsize=9)
            _bits(panel, judged)
            panel.set_ylim(bottom=0)
        panels[0].set_ylabel("% of the true events")
        _legend(figure, panels)
        return svg_element(figure)


def _line(
    panel: Axes, rows: Sequence[Row], shares: Sequence[float], number: int, label: str
) -> None:
    if rows:
        panel.plot(
            [row.bits or 0 for row in rows], list(shares),
            f"C{number % 10}{MARKERS[number % len(MARKERS)]}-",
            markersize=4, linewidth=1, label=label,
        )  # fmt: skip


def _bits(panel: Axes, judged: Judged) -> None:
    bits = sorted({row.bits for row in judged.rows if row.bits})
    panel.set_xscale("log")
    panel.set_xticks(bits, [str(each) for each in bits])
    panel.minorticks_off()
    panel.set_xlabel("bits of MPFR")
    panel.grid(alpha=0.3)


def _legend(figure: Figure, panels: Sequence[Axes]) -> None:
    named = {
        label: handle
        for panel in panels
        for handle, label in zip(*panel.get_legend_handles_labels(), strict=True)
    }
    figure.legend(list(named.values()), list(named), loc="outside lower center", ncols=3,
                  fontsize=8)  # fmt: skip
