"""`minkref bench`: how much faster the dynamic update is than finding the same afresh."""

from __future__ import annotations

import sys
from typing import Annotated, Any

import typer
from minkref.cli.options import Json, Schema
from minkref.cli.output import give
from minkref.cli.progress import progress
from minkref.errors import Refusal, choice
from minkref.output.documents import Stopwatch, document
from minkref.output.exits import ExitCode
from minkref.output.signals import ending_in_order
from minkref.output.terminal import lines
from minkref.reports.bench import index, table1, table2
from minkref.reports.bench.tables import print_index, print_polygons, print_polyhedra

EXAMPLES = """Examples:

minkref bench --quick

minkref bench --only table2 --json

minkref bench --only index

MINKREF_MODELS=folder minkref bench"""

PRINTED = {"table1": print_polygons, "table2": print_polyhedra, "index": print_index}
PARTS = tuple(PRINTED)


def command(
    quick: Annotated[
        bool,
        typer.Option("--quick", help="10 re-scalings instead of 100, without the largest pair."),
    ] = False,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", help=f"Parts to run: {', '.join(PARTS)}.", metavar="NAME"),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", help="Seed of the re-scalings.", metavar="K")] = 1,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Time the dynamic update against computing from scratch: intersections and sums of polygons
    (Table 1 of Behar & Lien 2012), and sums of convex polyhedra under non-uniform scaling (Table
    2); and the index of all scales against CGAL's sums. Takes some minutes each; with --quick about
    one minute in all."""
    watch = Stopwatch()
    for name in only or []:
        if name not in PARTS:
            raise Refusal(f"there is no part {name!r}", "--only", choice(name, PARTS))
    parts = only or PARTS
    flat: table1.Table1 | None = None
    solid: table2.Table2 | None = None
    all_scales: index.IndexTable | None = None
    count = (table1.pair_count(quick) if "table1" in parts else 0) + (
        table2.pair_count() if "table2" in parts else 0
    )
    count += index.pair_count(quick) if "index" in parts else 0
    with ending_in_order(), progress(count) as line:
        if "table1" in parts:
            flat = table1.run(quick, seed, line.now, line.done)
        if "table2" in parts:
            solid = table2.run(quick, seed, line.now, line.done)
        if "index" in parts:
            all_scales = index.run(quick, seed, line.now, line.done)
    value = document(
        "bench",
        watch,
        quick=quick,
        seed=seed,
        table1=None if flat is None else _table1(flat),
        table2=None if solid is None else _table2(solid),
        index=None if all_scales is None else _index(all_scales),
    )
    give(value, json, lambda value: _print(value, seed))
    if any(table is not None and table.wrong for table in (flat, solid, all_scales)):
        raise typer.Exit(ExitCode.WRONG)


def _table1(table: table1.Table1) -> dict[str, Any]:
    head = {"rescalings": table.rescalings, "pairs": table.pairs}
    return _part(table, head, table1.summary(table))


def _table2(table: table2.Table2) -> dict[str, Any]:
    summary = {**table2.summary(table), "paper": table2.PAPER}
    return _part(table, {"rescalings": table.rescalings}, summary)


def _index(table: index.IndexTable) -> dict[str, Any]:
    return _part(table, {"queries": table.queries}, index.summary(table))


def _part(table: Any, head: dict[str, Any], summary: dict[str, Any]) -> dict[str, Any]:
    """A part of the document, with the rows, the notes and the wrong results of the table."""
    return {**head, "rows": table.rows, **summary, "notes": table.notes, "wrong": table.wrong}


def _print(value: dict[str, Any], seed: int) -> None:
    for name, print_part in PRINTED.items():
        if value[name] is not None:
            print_part(value[name], seed)
    sys.stdout.write(lines([("seconds", f"{value['seconds']:.1f}")]))
