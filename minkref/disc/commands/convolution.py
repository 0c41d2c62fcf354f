"""`minkref convolution P disc:R`: the segments and arcs that the sum is made of, with their
parents."""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Iterator, Sequence
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import plain_table
from minkref.disc.disc import is_disc, read_disc
from minkref.errors import Refusal, refusing
from minkref.output.documents import (
    Stopwatch,
    as_text,
    document,
    lasting,
    listing,
    refuse_overwriting,
)
from minkref.output.output_target import target_of
from minkref.output.terminal import console, escaped, lines
from minkref.plane.operand import read_operand
from minkref.verbs.convolution import ConvolutionWithDisc
from minkref.verbs.events import check_limit

SHOWN = 10  # curves that people see


def run(request: ConvolutionWithDisc) -> None:
    watch = Stopwatch()
    P, Q, output = request.P, request.Q, request.output
    check_limit(request.limit)
    target = target_of(output, request.form, ("json",), "json", request.json)
    if is_disc(P) and is_disc(Q):
        raise Refusal("the sum of two discs is one", f"{P} and {Q}", "add their radii")
    disc = read_disc(P).scaled(request.scale) if is_disc(P) else read_disc(Q)
    with memory_wall(request.memory, "the convolution", f"{P} and {Q}", SIMPLER):
        operand = read_operand(Q if is_disc(P) else P)
        if output is not None:
            refuse_overwriting(output, [operand.file])
        other = operand.set if is_disc(P) else operand.set.scaled(str(request.scale))
        start = time.perf_counter()
        rows = refusing(
            operand.name, lambda: _core.disc_convolution(other, str(disc.squared_radius))
        )
        seconds = time.perf_counter() - start
    arcs = sum(parent[0] == "vertex" for parent, *_ in rows)
    head = document(
        "convolution",
        watch,
        P=P if is_disc(P) else operand.name,
        Q=Q if is_disc(Q) else operand.name,
        scale=str(request.scale),
        radius=disc.radius,
        squared_radius=str(disc.squared_radius),
        warnings=operand.warnings,
        output=str(output) if output else None,
        compute_seconds=seconds,
        count=len(rows),
        segments=len(rows) - arcs,
        arcs=arcs,
    )
    chosen = rows if request.limit is None else rows[: request.limit]
    if target is not None:
        target.write_pieces(listing(lasting(head), "curves", map(_curve, chosen)))
    if request.json and target is None:
        sys.stdout.writelines(listing(head, "curves", map(_curve, chosen)))
    elif request.json:
        sys.stdout.write(as_text({**head, "curves": None}))
    elif target is None or not target.is_standard_output:
        _print(head, chosen if request.limit is not None else rows[:SHOWN])


Row = tuple[
    tuple[str, str, str],
    tuple[tuple[str, str], tuple[str, str]],
    tuple[tuple[str, str], tuple[str, str]],
    tuple[tuple[float, float], tuple[float, float]],
]


def _curve(row: Row) -> dict[str, Any]:
    (kind, first, second), points, normals, near = row
    is_arc = kind == "vertex"
    return {
        "kind": "arc" if is_arc else "segment",
        "parent": {"vertex": [first, second]} if is_arc else {"edge": [int(first), int(second)]},
        "from": {"point": list(points[0]), "normal": list(normals[0]), "near": _near(near[0])},
        "to": {"point": list(points[1]), "normal": list(normals[1]), "near": _near(near[1])},
    }


def _near(point: tuple[float, float]) -> list[float | None]:
    return [x if math.isfinite(x) else None for x in point]


def _print(head: dict[str, Any], rows: Sequence[Row]) -> None:
    named = [
        ("convolution", f"{head['P']} and {head['Q']}"),
        ("radius of the disc", head["radius"]),
        ("curves", f"{head['segments']:,} segments, {head['arcs']:,} arcs"),
        ("seconds", f"{head['seconds']:.3f}"),
    ]
    if head["output"]:
        named.append(("written", head["output"]))
    sys.stdout.write(lines(named))
    if head["output"] is None and rows:
        table = plain_table("kind", "parent", "from, about", "to, about")
        for cells in _cells(rows):
            table.add_row(*cells)
        sys.stdout.write("\n")
        console().print(table)
        if head["count"] > len(rows):
            more = head["count"] - len(rows)
            sys.stdout.write(f"{more:,} more: --json or -o FILE gives all\n")
    for warning in head["warnings"]:
        sys.stderr.write(f"warning: {escaped(warning)}\n")


def _cells(rows: Sequence[Row]) -> Iterator[tuple[str, ...]]:
    for (kind, first, second), _, _, near in rows:
        is_arc = kind == "vertex"
        parent = f"vertex ({first}, {second})" if is_arc else f"edge {first}.{second}"
        ends = (f"({x:.6g}, {y:.6g})" for x, y in near)
        yield ("arc" if is_arc else "segment", parent, *ends)
