"""`minkref convolution P Q` in the plane: the edges that the sum is made of, with their parents."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterable, Iterator
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import Refusal, choice, refusing
from minkref.exact import rounded
from minkref.output.documents import (
    Stopwatch,
    as_text,
    document,
    lasting,
    listing,
    refuse_overwriting,
)
from minkref.output.output_target import Target, target_of
from minkref.output.terminal import console, escaped, lines
from minkref.plane.commands.convolution_output import (
    edge_documents,
    geojson_pieces,
    refuse_unrepresentable,
)
from minkref.plane.convolution_values import COMPATIBLE
from minkref.plane.operand import Operand, read_operand
from minkref.plane.scaling import document_of, shown_scale, text_of
from minkref.verbs.convolution import ConvolutionInPlane

OUTPUTS = ("json", "geojson", "svg")
SHOWN = 10  # edges that people see
MOST_DRAWN = 100_000  # edges in one picture


def run(request: ConvolutionInPlane) -> None:
    watch = Stopwatch()
    scale, compatible, limit, json = (
        text_of(request.scale), request.compatible, request.limit, request.json,
    )  # fmt: skip
    output, full = request.output, request.full
    if compatible not in COMPATIBLE:
        what = f"there is no reading {compatible!r} of `between`"
        raise Refusal(what, "--compatible", choice(compatible, COMPATIBLE))
    if limit is not None and limit < 0:
        raise Refusal("the limit is negative", f"--limit {limit}", "give 0 or more")
    target = target_of(output, request.form, OUTPUTS, "json", json)
    first, second = read_operand(request.P), read_operand(request.Q)
    if output is not None:
        refuse_overwriting(output, [first.file, second.file])
    operands = f"{first.name} and {second.name}"
    with memory_wall(request.memory, "the convolution", operands, SIMPLER):
        start = time.perf_counter()
        found = refusing(
            operands, lambda: _core.Convolution(first.set, second.set, scale, full, compatible)
        )
        seconds = time.perf_counter() - start
        count = len(found) if limit is None else min(limit, len(found))
        exact = _exactly(found, target, count)
        counts = found.counts()
        fields: dict[str, Any] = {
            "P": first.name,
            "Q": second.name,
            "scale": document_of(request.scale),
            "full": full,
            "compatible": compatible,
            "warnings": first.warnings + second.warnings,
            "output": str(output) if output else None,
            "output_exact": exact,
            "compute_seconds": seconds,
            "count": len(found),
            "segments": {"S": counts["S"], "T": counts["T"]},
            "negative": counts["negative"],
        }
        head = document("convolution", watch, **fields)
        if target is not None:
            target.write_pieces(_pieces(target, head, found, count, first, second))
            target.tell_rounding(bool(exact))
        if json and target is None:
            sys.stdout.writelines(listing(head, "edges", edge_documents(found, count)))
        elif json:
            sys.stdout.write(as_text(document("convolution", watch, **fields, edges=None)))
        elif target is None or not target.is_standard_output:
            shown = min(count, SHOWN) if limit is None else count
            _print(document("convolution", watch, **fields), found, shown)


def _exactly(found: _core.Convolution, target: Target | None, count: int) -> bool | None:
    """Whether the written file is exact. Refuses, before writing, a result beyond the format."""
    if target is None or target.form == "json":
        return None if target is None else True
    if target.form == "svg":
        if count > MOST_DRAWN:
            raise Refusal(
                f"there are {count:,} edges, and a picture shows at most {MOST_DRAWN:,}",
                target.name,
                f"write .json or .geojson, or draw the first with --limit {MOST_DRAWN}",
                "limit",
            )
        return False
    if found.has_decimals(count):
        return True
    refusing(target.name, lambda: refuse_unrepresentable(found, count))
    return False


def _pieces(
    target: Target,
    head: dict[str, Any],
    found: _core.Convolution,
    count: int,
    P: Operand,
    Q: Operand,
) -> Iterable[str]:
    if target.form == "json":
        return listing(lasting(head), "edges", edge_documents(found, count))
    if target.form == "geojson":
        return geojson_pieces(found, count)
    return _picture(head, found, count, P, Q)


def _picture(
    head: dict[str, Any], found: _core.Convolution, count: int, P: Operand, Q: Operand
) -> Iterator[str]:
    from minkref.reports.convolution_picture import convolution_picture

    yield convolution_picture(
        P, Q, shown_scale(head["scale"]), edge_documents(found, count), head["full"]
    )


def _print(value: dict[str, Any], found: _core.Convolution, count: int) -> None:
    which = "full" if value["full"] else "reduced"
    segments = value["segments"]
    rows = [
        ("convolution", f"{shown_scale(value['scale'])} {value['P']} and {value['Q']}"),
        ("kind", f"{which}, {value['compatible']}"),
        ("edges", f"{segments['S']:,} S-edges, {segments['T']:,} T-edges"),
    ]
    if value["full"]:
        rows.append(("of the sign -1", f"{value['negative']:,}"))
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    if value["output"]:
        rounded = "" if value["output_exact"] else " (rounded; .json is exact)"
        rows.append(("written", value["output"] + rounded))
    sys.stdout.write(lines(rows))
    if value["output"] is None:
        _print_first(found, count)
    for warning in value["warnings"]:
        sys.stderr.write(f"warning: {escaped(warning)}\n")


def _print_first(found: _core.Convolution, count: int) -> None:
    from rich.table import Table

    if count == 0:
        return
    table = Table("kind", "edge", "vertex", "sign", "from, about", "to, about")
    for edge in edge_documents(found, count):
        parents = [f"{ring}.{index}" for ring, index in (edge["edge"], edge["vertex"])]
        ends = [", ".join(rounded(x, 6) for x in edge[end]) for end in ("start", "end")]
        table.add_row(edge["kind"], *parents, f"{edge['sign']:+}", *(f"({end})" for end in ends))
    sys.stdout.write("\n")
    console().print(table)
    if len(found) > count:
        sys.stdout.write(f"{len(found) - count:,} more: --json or -o FILE gives all\n")
