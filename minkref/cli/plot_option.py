"""The option --plot: a picture of a set below the table."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from minkref import _core
from minkref.errors import Refusal
from minkref.output.output_target import Target
from minkref.output.terminal import console


def check_plot(plot: bool, json: bool, target: Target | None) -> None:
    """Refuse a picture beside other output on standard output, or without characters to draw
    with."""
    if not plot:
        return
    if json or (target is not None and target.is_standard_output):
        other = "--json" if json else "-o -"
        what = "standard output takes only one of them"
        raise Refusal(what, f"--plot {other}", "leave out one of the two")
    from minkref.cli.terminal_picture import check_drawable

    check_drawable()


def print_plot(
    plot: bool, region: _core.PolygonSet | None, passages: Sequence[Sequence[Sequence[str]]] = ()
) -> None:
    """Draw the set, with tight passages in it, where a picture is wanted."""
    if plot and region is not None:
        from minkref.cli.terminal_picture import terminal_picture

        sys.stdout.write("\n" + terminal_picture(region, console().width, passages))
