"""`minkref decompose`: a shape in pieces, cut at the notches of its features."""

from __future__ import annotations

import math
import time
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certain_digits import between, root
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, plain_table, print_lines, written_row
from minkref.disc.commands.sum import enclosed
from minkref.disc.decomposition import Decomposition, Piece, decompose
from minkref.disc.disc_index import Bounds
from minkref.disc.features import Place
from minkref.errors import Refusal, refusing
from minkref.exact import digest, in_double_range, rounded, set_json
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.output.terminal import console
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import Operand, read_operand
from minkref.verbs.decompose import DecomposeRequest

FORMS = ("wkt", "geojson", "json", "svg")
SHOWN = 10  # pieces that people see
DIGITS = 6


def run(request: DecomposeRequest) -> None:
    watch = Stopwatch()
    alpha, last = _window(request)
    target = target_of(request.output, request.form, FORMS, "wkt", request.json)
    with memory_wall(request.memory, "the decomposition", request.P, SIMPLER):
        operand = read_operand(request.P)
        if request.output is not None:
            refuse_overwriting(request.output, [operand.file])
        began = time.perf_counter()
        found = refusing(
            operand.source,
            lambda: decompose(operand.set, alpha, request.persistence, last, cores()),
        )
        seconds = time.perf_counter() - began
        pieces = _core.PolygonSet(
            [rings for piece in found.pieces for rings in piece.region.rings()], validate=False
        )
        if target is not None:
            text, is_exact = _text(operand, found, pieces, target)
            if target.write(text, is_exact):
                return
        value = document(
            "decompose",
            watch,
            P=operand.name,
            alpha=str(alpha),
            to=None if last is None else str(last),
            persistence=request.persistence,
            warnings=operand.warnings,
            output=None if request.output is None else str(request.output),
            output_exact=None if target is None else _core.writes_exactly(pieces, target.form),
            compute_seconds=seconds,
            digest=digest(set_json((outer, holes) for outer, *holes in pieces.rings())),
            **_fields(found),
        )
    give(value, request.json, _print)


def _window(request: DecomposeRequest) -> tuple[Fraction, Fraction | None]:
    """Return the diameter and the last one that counts. Refuses half a range, and two diameters."""
    if request.first is None and request.last is None:
        return request.alpha or Fraction(0), None
    if request.first is None or request.last is None:
        what = "a range has two ends"
        raise Refusal(what, "--from, --to", "give both, or --alpha")
    if request.alpha is not None:
        what = "features are taken at one diameter"
        raise Refusal(what, "--alpha, --from", "leave out one of the two")
    if request.first > request.last:
        where = f"--from {request.first} --to {request.last}"
        raise Refusal("the range is empty", where, "exchange the bounds", "empty-range")
    return request.first, request.last


def _text(
    operand: Operand, found: Decomposition, pieces: _core.PolygonSet, target: Target
) -> tuple[str, bool]:
    """The output text, and whether exact."""
    if target.form == "svg":
        from minkref.disc.commands.decomposition_picture import decomposition_picture

        return decomposition_picture(operand, found), False
    text = refusing(target.name, lambda: _core.write(pieces, target.form))
    return text, _core.writes_exactly(pieces, target.form)


def _fields(found: Decomposition) -> dict[str, Any]:
    cut_of = {cut.notch: number for number, cut in enumerate(found.cuts)}
    return {
        "notches": [
            {
                "vertex": _point(notch.vertex),
                "birth": enclosed(bar.birth),
                "death": _finite(bar.death),
                "depth": _finite(notch.depth),
                "tie": notch.tie,
                "cut": cut_of.get(number),
            }
            for number, (notch, bar) in enumerate(zip(found.notches, found.bars, strict=True))
        ],
        "cuts": [
            {
                "from": _point(cut.start),
                "to": _point(cut.end),
                "squared_length": str(cut.squared_length),
                "notch": cut.notch,
                "wall": cut.wall,
            }
            for cut in found.cuts
        ],
        "pieces": [_piece(piece) for piece in found.pieces],
    }


def _piece(piece: Piece) -> dict[str, Any]:
    area = piece.region.area()
    outer, *holes = piece.region.rings()[0]
    longest = piece.longest_bar
    return {
        "area": area,
        "area_approximate": in_double_range(area),
        "convex": piece.is_convex,
        "bars": len(piece.bars),
        "endless_bars": piece.endless_bars,
        "longest_bar": None if longest is None else enclosed(longest),
        "slits": [[_point(a), _point(b)] for a, b in piece.slits],
        "outer": [_point(point) for point in outer],
        "holes": [[_point(point) for point in hole] for hole in holes],
    }


def _finite(bounds: Bounds) -> dict[str, float | None] | None:
    return None if math.isinf(bounds[0]) else enclosed(bounds)


def _point(place: Place) -> list[str]:
    return [str(place[0]), str(place[1])]


def _print(value: dict[str, Any]) -> None:
    pieces, cuts, notches = value["pieces"], value["cuts"], value["notches"]
    until = "" if value["to"] is None else f" to {value['to']}"
    convex = sum(piece["convex"] for piece in pieces)
    rows = [
        ("P", value["P"]),
        ("alpha", f"{value['alpha']}{until}, persistence {value['persistence']}"),
        ("notches", f"{len(notches):,}, of which {len(notches) - len(cuts):,} resolved already"),
        ("cuts", f"{len(cuts):,}"),
    ]
    if cuts:
        squares = [Fraction(cut["squared_length"]) for cut in cuts]
        rows.append(
            ("lengths", f"{root(min(squares), DIGITS)} to {root(max(squares), DIGITS)}, rounded")
        )
    rows.append(("pieces", f"{len(pieces):,}, of which {convex:,} convex"))
    if pieces:
        areas = sorted((Fraction(piece["area"]), piece["area"]) for piece in pieces)
        rows.append(("areas", f"{rounded(areas[0][1], DIGITS)} to {rounded(areas[-1][1], DIGITS)}"))
    rows += [*written_row(value), ("seconds", f"{value['seconds']:.3f}")]
    print_lines(rows, value)
    if len(pieces) > 1:
        _print_pieces(pieces)


def _print_pieces(pieces: list[dict[str, Any]]) -> None:
    """The largest pieces."""
    order = sorted(
        range(len(pieces)), key=lambda number: Fraction(pieces[number]["area"]), reverse=True
    )
    headings = ("piece", "area", "vertices", "bars", "without end", "longest that ends")
    table = plain_table(*headings, right=headings[:-1])
    for number in order[:SHOWN]:
        piece = pieces[number]
        vertices = len(piece["outer"]) + sum(map(len, piece["holes"]))
        longest = piece["longest_bar"]
        bar = "" if longest is None else between(**longest)
        counts = (vertices, piece["bars"], piece["endless_bars"])
        table.add_row(str(number), rounded(piece["area"], DIGITS), *map(str, counts), bar)
    console().print()
    console().print(table)
    if len(pieces) > SHOWN:
        console().print(f"and {len(pieces) - SHOWN:,} smaller pieces; --json prints all")
