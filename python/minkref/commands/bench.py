"""`minkref bench`: how much faster the dynamic update is than finding the same afresh."""

from __future__ import annotations

import sys
from typing import Annotated, Any

import typer
from rich.table import Table

from minkref.documents import Stopwatch, as_text, document
from minkref.errors import Refusal
from minkref.exits import ExitCode
from minkref.options import Json, Schema
from minkref.progress import progress
from minkref.reports.bench.baselines import ABOUT
from minkref.reports.bench.table1 import PAPER_MEAN, pair_count, run, summary
from minkref.signals import ending_in_order
from minkref.terminal import console, lines

EXAMPLES = """Examples:

minkref bench --quick

minkref bench --only table1 --json

MINKREF_MODELS=folder minkref bench"""

PARTS = ("table1",)


def command(
    quick: Annotated[
        bool,
        typer.Option("--quick", help="10 re-scalings instead of 100, without the largest pair."),
    ] = False,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", help=f"Parts to run: {', '.join(PARTS)}.", metavar="NAME"),
    ] = None,
    seed: Annotated[int, typer.Option("--seed", help="Of the re-scalings.", metavar="K")] = 1,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Times the dynamic update against finding the same afresh (Table 1 of Behar & Lien 2012):
    intersections, and whole sums. Some minutes; less than one with --quick."""
    watch = Stopwatch()
    for name in only or []:
        if name not in PARTS:
            mend = f"choose one of {', '.join(PARTS)}"
            raise Refusal(f"there is no part {name!r}", "--only", mend)
    with ending_in_order(), progress(pair_count(quick)) as line:
        table = run(quick, seed, line.now, line.done)
    value = document(
        "bench",
        watch,
        quick=quick,
        seed=table.seed,
        rescalings=table.rescalings,
        pairs=table.pairs,
        rows=table.rows,
        **summary(table),
        notes=table.notes,
        wrong=table.wrong,
    )
    if json:
        sys.stdout.write(as_text(value))
    else:
        _print(value)
    if table.wrong:
        raise typer.Exit(ExitCode.WRONG)


def _print(value: dict[str, Any]) -> None:
    out = console()
    out.print(_pairs_table(value["pairs"]))
    for measure, title in (
        ("intersections", "Updating all intersections, against finding them afresh"),
        ("sum", "Updating and giving the sum, against computing the sum afresh"),
    ):
        rows = [row for row in value["rows"] if row["measure"] == measure]
        out.print()
        out.print(_rows_table(title, rows))
    text = [
        ("re-scalings", f"{value['rescalings']} out of 0.1, 0.2, ..., 10; seed {value['seed']}")
    ]
    for name, mean in value["mean_ratios"].items():
        reached = f"{mean:.2f}" if mean is not None else "not all pairs were timed"
        text.append((f"mean ratio, {name}", f"{reached} over the small pairs: {ABOUT[name]}"))
    text.append(("the paper's", f"{PAPER_MEAN} over its 25 pairs (as pairwise; another machine)"))
    text += [("note", note) for note in value["notes"]]
    text += [("WRONG", f"the sum differs from the static one: {wrong}") for wrong in value["wrong"]]
    text.append(("seconds", f"{value['seconds']:.1f}"))
    sys.stdout.write("\n" + lines(text))


def _pairs_table(rows: list[dict[str, Any]]) -> Table:
    table = Table(box=None, pad_edge=False, title="Pairs", title_justify="left")
    headings = ("pair", "edges", "events", "scales crossed", "changes", "update ms", "all events s")
    for heading in headings:
        table.add_column(heading, justify="left" if heading == "pair" else "right", no_wrap=True)
    for row in rows:
        table.add_row(
            row["name"],
            f"{row['edges']:,}",
            f"{row['events']:,}",
            f"{row['event_scales_per_step']:,.0f}",
            f"{row['changes_per_step']:,.0f}",
            milliseconds(row["update"]["median"]),
            f"{row['preprocessing_seconds']:.3f}",
        )
    return table


def _rows_table(title: str, rows: list[dict[str, Any]]) -> Table:
    table = Table(box=None, pad_edge=False, title=title, title_justify="left")
    headings = ("pair", "against", "timed", "ours ms", "theirs ms", "ratio", "median", "quartiles",
                "pays from")  # fmt: skip
    for heading in headings:
        left = heading in ("pair", "against")
        table.add_column(heading, justify="left" if left else "right", no_wrap=True)
    for row in rows:
        of_each = row["ratios"]
        table.add_row(
            row["name"],
            row["baseline"],
            f"{row['rescalings_timed']} of {row['rescalings']}",
            milliseconds(row["ours_s"]),
            milliseconds(row["baseline_s"]),
            f"{row['ratio']:,.2f}",
            f"{of_each['median']:,.2f}",
            f"{of_each['lower']:,.1f} - {of_each['upper']:,.1f}",
            f"{row['break_even']:,}" if row["break_even"] is not None else "never",
        )
    return table


def milliseconds(seconds: float) -> str:
    return f"{seconds * 1000:,.4f}" if seconds < 0.01 else f"{seconds * 1000:,.1f}"
