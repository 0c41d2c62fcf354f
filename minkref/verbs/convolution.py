"""`minkref convolution P Q`: the edges that the sum is made of, with their parents."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref import _core
from minkref.cli.memory import SIMPLER, Memory, memory_wall
from minkref.cli.options import (
    FirstOperand,
    Json,
    Scale,
    Schema,
    SecondOperand,
    Triangles,
    refuse_triangles,
)
from minkref.errors import Refusal, choice, refusing
from minkref.exact import read_scale, rounded
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
from minkref.space.operand import in_space

EXAMPLES = """Examples:

minkref convolution disc1 cells1815

minkref convolution g1 g2 --scale 7/5 -o convolution.svg

minkref convolution g1 g2 --full -o convolution.geojson

minkref convolution P.wkt Q.geojson --scale 541/186 -o - --format json

minkref convolution g1 o1 --compatible closed --json

minkref convolution gs3 rod --scale 2,1/3,5 -o facets.ply"""

OUTPUTS = ("json", "geojson", "svg")
SHOWN = 10  # edges that people see
MOST_DRAWN = 100_000  # edges in one picture


def command(
    P: FirstOperand,
    Q: SecondOperand,
    scale: Scale = "1",
    full: Annotated[
        bool,
        typer.Option(
            "--full/--reduced",
            help="Full: also the edges at reflex vertices, of the sign -1. Reduced: those at "
            "strictly convex vertices only.",
        ),
    ] = False,
    compatible: Annotated[
        str,
        typer.Option(
            "--compatible",
            help="Which ends of the turn at a vertex belong to it, for edges of P and Q in one "
            "direction: half-open, which is right; open, which may lose parts of the sum's "
            "boundary; closed, which covers parts twice.",
        ),
    ] = COMPATIBLE[0],
    limit: Annotated[
        int | None,
        typer.Option(
            "--limit", help="List or draw only the first N edges; all are counted.", metavar="N"
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            help="Write the convolution to this file: .json, .geojson (an edge is a LineString) or "
            ".svg; in space .json, .off or .ply. `-`: print it alone on standard output.",
            metavar="FILE",
        ),
    ] = None,
    form: Annotated[
        str | None,
        typer.Option(
            "--format",
            help="Format to write, whatever the name of the file ends in. Default for `-`: json.",
        ),
    ] = None,
    triangles: Triangles = False,
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """The convolution of P, scaled by S about the origin, and Q: every edge of the one at each
    compatible vertex of the other, with its parents. Exact. Of convex polyhedra: the facets of the
    sum, with theirs."""
    if in_space(P, Q):
        _refuse_in_space(full, compatible, limit)
        from minkref.space.commands.convolution import convolution_in_space

        convolution_in_space(P, Q, scale, output, json, form, memory, triangles)
        return
    refuse_triangles(triangles)
    watch = Stopwatch()
    exact_scale = read_scale(scale)
    if compatible not in COMPATIBLE:
        what = f"there is no reading {compatible!r} of `between`"
        raise Refusal(what, "--compatible", choice(compatible, COMPATIBLE))
    if limit is not None and limit < 0:
        raise Refusal("the limit is negative", f"--limit {limit}", "give 0 or more")
    target = target_of(output, form, OUTPUTS, "json", json)
    first, second = read_operand(P), read_operand(Q)
    if output is not None:
        refuse_overwriting(output, [first.file, second.file])
    operands = f"{first.name} and {second.name}"
    with memory_wall(memory, "the convolution", operands, SIMPLER):
        start = time.perf_counter()
        found = refusing(
            operands,
            lambda: _core.Convolution(first.set, second.set, exact_scale, full, compatible),
        )
        seconds = time.perf_counter() - start
        count = len(found) if limit is None else min(limit, len(found))
        exact = _exactly(found, target, count)
        counts = found.counts()
        fields: dict[str, Any] = {
            "P": first.name,
            "Q": second.name,
            "scale": exact_scale,
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


def _refuse_in_space(full: bool, compatible: str, limit: int | None) -> None:
    mend = "leave it out"
    if full:
        what = "convex polyhedra have no reflex edges: their convolution is the reduced one"
        raise Refusal(what, "--full", mend)
    if compatible != COMPATIBLE[0]:
        what = "in space ties are broken in one way only"
        raise Refusal(what, f"--compatible {compatible[:40]}", mend)
    if limit is not None:
        raise Refusal("in space all facets are given", f"--limit {limit}", mend)


def _exactly(found: _core.Convolution, target: Target | None, count: int) -> bool | None:
    """Whether what is written is exact. Refuses what the format cannot hold, before the first
    letter of it."""
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

    yield convolution_picture(P, Q, head["scale"], edge_documents(found, count), head["full"])


def _print(value: dict[str, Any], found: _core.Convolution, count: int) -> None:
    which = "full" if value["full"] else "reduced"
    segments = value["segments"]
    rows = [
        ("convolution", f"{value['scale']} {value['P']} and {value['Q']}"),
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
