"""`minkref bench`: how much faster the dynamic update is than finding the same afresh."""

from __future__ import annotations

import sys
from typing import Annotated, Any

import typer
from minkref.commands.line.options import Json, Schema
from minkref.commands.line.progress import progress
from minkref.documents import Stopwatch, as_text, document
from minkref.errors import Refusal, choice
from minkref.exits import ExitCode
from minkref.reports.bench import index, table1, table2
from minkref.reports.bench.tables import print_index, print_polygons, print_polyhedra
from minkref.signals import ending_in_order
from minkref.terminal import lines

EXAMPLES = """Examples:

minkref bench --quick

minkref bench --only table2 --json

minkref bench --only index

MINKREF_MODELS=folder minkref bench"""

PARTS = ("table1", "table2", "index")


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
            mend = choice(name, PARTS)
            raise Refusal(f"there is no part {name!r}", "--only", mend)
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
    if json:
        sys.stdout.write(as_text(value))
    else:
        if flat is not None:
            print_polygons(value["table1"], seed)
        if solid is not None:
            print_polyhedra(value["table2"], seed)
        if all_scales is not None:
            print_index(value["index"], seed)
        sys.stdout.write(lines([("seconds", f"{value['seconds']:.1f}")]))
    if any(table is not None and table.wrong for table in (flat, solid, all_scales)):
        raise typer.Exit(ExitCode.WRONG)


def _table1(table: table1.Table1) -> dict[str, Any]:
    return {
        "rescalings": table.rescalings,
        "pairs": table.pairs,
        "rows": table.rows,
        **table1.summary(table),
        "notes": table.notes,
        "wrong": table.wrong,
    }


def _table2(table: table2.Table2) -> dict[str, Any]:
    return {
        "rescalings": table.rescalings,
        "rows": table.rows,
        **table2.summary(table),
        "paper": table2.PAPER,
        "notes": table.notes,
        "wrong": table.wrong,
    }


def _index(table: index.IndexTable) -> dict[str, Any]:
    return {
        "queries": table.queries,
        "rows": table.rows,
        **index.summary(table),
        "notes": table.notes,
        "wrong": table.wrong,
    }
