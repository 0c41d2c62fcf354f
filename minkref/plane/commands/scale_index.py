"""The index of all scales as the commands use it: built with progress, or taken from its file."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref import _core
from minkref.cli.progress import Steps, progress
from minkref.errors import Refusal, choice, refusing
from minkref.exact import text_of_bounds
from minkref.output.documents import refuse_overwriting
from minkref.plane.operand import Operand

IndexFile = Annotated[
    Path | None,
    typer.Option(
        "--index",
        help="Read the sums off this index, which `minkref index` wrote (--route index).",
        metavar="FILE",
    ),
]

# How much of a build each stage is, roughly.
STAGES = {
    "cells": ("patches of edges", 0, 20),
    "pairs": ("pairs of edges", 20, 40),
    "patches": ("boundary", 60, 30),
    "rings": ("rings", 90, 10),
}
WHOLE = 100


def cores() -> int:
    """The number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else 1


def refuse_overwriting_index(output: Path | None, index: Path | None) -> None:
    """Refuses an output that is the index that is read."""
    if output is not None and index is not None:
        refuse_overwriting(output, [index])


def chosen_route(
    index: Path | None, route: str | None, routes: Sequence[str], default: str | None = None
) -> str:
    """The route that the options name together. `default`: the first of them, or another one."""
    if index is not None and route not in (None, "index"):
        raise Refusal(
            f"an index is given, but the route {route} does not use it",
            f"--index {index} --route {route}",
            "leave out one of the two options",
        )
    if route is None:
        return "index" if index is not None else default or routes[0]
    if route not in routes:
        raise Refusal(f"there is no route {route!r}", "--route", choice(route, routes))
    return route


def build_index(
    P: Operand,
    Q: Operand,
    first: Fraction | None,
    last: Fraction | None,
    threads: int | None = None,
) -> _core.ScaleIndex:
    """The index of a closed window, which is open towards 0 or infinity where a bound is None."""
    begin, end = text_of_bounds(first, last)
    with progress(WHOLE) as line:
        tell = _teller(line)
        return refusing(
            f"{P.name} and {Q.name}",
            lambda: _core.ScaleIndex(P.set, Q.set, begin, end, threads or cores(), 0, tell),
        )


def open_index(path: Path, P: Operand, Q: Operand) -> _core.ScaleIndex:
    """Opens a saved index, if it belongs to these operands."""
    index = refusing(str(path), lambda: _core.ScaleIndex.open(str(path)))
    if not index.is_of(P.set, Q.set):
        raise Refusal(
            f"the index does not belong to {P.name} and {Q.name}",
            str(path),
            "give the operands that it was built from, in the same order, or build another",
            "other-operands",
        )
    return index


def index_of(
    path: Path | None, P: Operand, Q: Operand, first: Fraction | None, last: Fraction | None
) -> _core.ScaleIndex:
    """The index of a file, which has to hold the bounds that are given; without a file one that is
    built of the window."""
    if path is None:
        return build_index(P, Q, first, last)
    index = open_index(path, P, Q)
    if first is not None and last is not None and first > last:
        raise Refusal(
            f"the window [{first}, {last}] is empty",
            "--from, --to",
            "give a --from that is not greater than --to",
            "bad-window",
        )
    begin, end = index.window
    given = [bound for bound in (first, last) if bound is not None]
    too_early = begin is not None and any(scale < begin for scale in given)
    too_late = end is not None and any(scale > end for scale in given)
    if too_early or too_late:
        asked = " to ".join(str(bound) for bound in dict.fromkeys(given))
        raise Refusal(
            f"the index holds the scales from {begin or '0'} to {end or 'infinity'}, not {asked}",
            str(path),
            "ask for scales in its window, or build an index of a larger window",
            "outside-window",
        )
    return index


def _teller(line: Steps) -> Callable[[str, int, int], None]:
    done = 0

    def tell(stage: str, count: int, total: int) -> None:
        nonlocal done
        name, before, part = STAGES[stage]
        now = before + (part * count // total if total else part)
        line.now(name)
        if now > done:
            line.done(now - done)
            done = now

    return tell
