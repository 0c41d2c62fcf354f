"""`minkref index P disc`: the outer Voronoi diagram, with events, holes and components."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import give, print_lines
from minkref.disc.commands.events import event_row, feature_row
from minkref.disc.commands.index_file import disc_index_of
from minkref.disc.commands.sum import enclosed
from minkref.disc.disc import ANY
from minkref.disc.eroded import ErodedByDisc, eroded_by_disc
from minkref.errors import Refusal
from minkref.output.documents import Stopwatch, document, lasting, listing, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import read_operand
from minkref.verbs.index import IndexWithDisc

Row = dict[str, Any]


def run(request: IndexWithDisc) -> None:
    watch = Stopwatch()
    P, Q, output, threads = request.P, request.Q, request.output, request.threads
    if Q != ANY or P == ANY:
        mend = "give `minkref index P disc`"
        raise Refusal("an index is of all radii", f"{P} {Q}", mend)
    target = target_of(output, None, ("json",), "json", request.json)
    assert target is not None
    operand = read_operand(P)
    eroded = eroded_by_disc(operand.set, operand.name) if request.erode else None
    refuse_overwriting(output, [operand.file])
    with memory_wall(request.memory, "the index of all radii", P, SMALLER):
        around = operand if eroded is None else replace(operand, set=eroded.set)
        index = disc_index_of(None, around, threads)
    parts = index.graph()
    value = document(
        "index",
        watch,
        P=operand.name,
        Q=Q,
        erode=request.erode,
        warnings=operand.warnings,
        output=str(output),
        threads=threads or cores(),
        build_seconds=index.seconds,
        exact_signs=index.exact_signs,
        events=len(index.kinds()),
        radii=len(index),
        parts=len(parts),
        holes=[_hole(*hole) for hole in index.holes()],
        joins=[
            {"radius": None if radius is None else enclosed(radius), "polygons": [a, b]}
            for radius, a, b in index.joins()
        ],
    )
    head = {name: value[name] for name in value if name != "events"}  # they come last
    head["places"] = index.places()
    head["parts"] = [_part(*part, eroded) for part in parts]
    target.write_pieces(listing(lasting(head), "events", _events(index, eroded)))
    give(value, request.json, _print)


def _events(index: _core.DiscIndex, eroded: ErodedByDisc | None) -> Iterator[Row]:
    for number in range(len(index.kinds())):
        yield event_row(index.rows(number, 1)[0], eroded)


def _hole(birth: tuple[float, float] | None, end: tuple[float, float], place: Any, of: int) -> Row:
    return {
        "birth": None if birth is None else enclosed(birth),
        "end": enclosed(end),
        "place": [c if math.isfinite(c) else None for c in place],
        "of": of,
    }


def _part(start: Any, end: Any, left: Any, right: Any, eroded: ErodedByDisc | None) -> Row:
    sides = [left, right] if eroded is None else [eroded.feature(*side) for side in (left, right)]
    return {
        "from": _end(*start),
        "to": _end(*end),
        "features": [feature_row(*side) for side in sides],
    }


def _end(kind: str, told: list[str]) -> Row:
    if kind == "event":
        return {"event": int(told[0])}
    points = [told[k : k + 2] for k in range(0, len(told), 2)]
    return {kind: points[0] if kind == "vertex" else points}


def _print(value: Row) -> None:
    rows = [
        ("index", f"{value['P']} {'less' if value['erode'] else '+'} disc"),
        ("events, radii", f"{value['events']:,}, {value['radii']:,}"),
        ("parts of the diagram", f"{value['parts']:,}"),
        ("holes", f"{len(value['holes']):,}"),
        ("build", f"{value['build_seconds']:.3f} s"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines([*rows, ("written", value["output"])], value)
