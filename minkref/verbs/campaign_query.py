"""`minkref campaign query`: questions to a ledger, by name or as SQL."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from datetime import datetime
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref.cli.options import Json, Schema
from minkref.cli.output import give, plain_table
from minkref.errors import Refusal
from minkref.output.documents import Stopwatch, as_text, document, listing
from minkref.output.output_target import Target, target_of
from minkref.output.signals import ending_in_order
from minkref.output.terminal import console, counted, escaped
from minkref.verbs.campaign_compact import Ledger

EXAMPLES = """Examples:

minkref campaign query nightly --question regressions

minkref campaign query nightly "SELECT target, count(*) FROM results GROUP BY target"

minkref campaign query nightly "FROM findings" -o findings.parquet"""

FORMATS = ("json", "jsonl", "csv", "parquet")
SHOWN = 100  # rows of a table for people
LEAST_MEMORY = 64


def command(
    folder: Ledger,
    sql: Annotated[
        str | None,
        typer.Argument(
            help="One SELECT of DuckDB over results, findings, counts, disputed, versions and "
            "campaigns.",
            metavar="SQL",
        ),
    ] = None,
    question: Annotated[
        str | None,
        typer.Option(
            "--question",
            help="Instead of SQL: verdicts, families, flags, positions, first-seen, regressions, "
            "slowest or campaigns.",
            metavar="NAME",
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            help="Write the answer to this file: .json, .jsonl (one row per line), .csv or "
            ".parquet; - for standard output.",
            metavar="FILE",
        ),
    ] = None,
    form: Annotated[
        str | None, typer.Option("--format", help=f"One of {', '.join(FORMATS)}.", metavar="FORMAT")
    ] = None,
    memory: Annotated[
        int, typer.Option("--memory", help="The most memory for the answer.", metavar="MIB")
    ] = 2048,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Ask a campaign's ledger, while the campaign runs or later. Nothing is written but the answer,
    and SQL reads no other file."""
    from minkref.fuzz.ledgers.questions import batches, named
    from minkref.fuzz.ledgers.views import opened

    watch = Stopwatch()
    if (sql is None) == (question is None):
        what, mend = "this takes either SQL or --question", "give one of the two"
        raise Refusal(what, "minkref campaign query", mend)
    if memory < LEAST_MEMORY:
        what = f"it has to be {LEAST_MEMORY} or more"
        raise Refusal(what, f"--memory {memory}", "choose another number")
    where, title = "SQL", ""
    if question is not None:
        chosen = named(question)
        sql, title, where = chosen.sql, chosen.title, f"--question {question}"
    target = target_of(output, form, FORMATS, "json", json)
    with ending_in_order(), opened(folder, memory) as con:
        fields, found = batches(con, str(sql), where)
        head: dict[str, Any] = {
            "folder": str(folder),
            "question": question,
            "sql": " ".join(str(sql).split()),
        }
        head["columns"] = [{"name": f.name, "type": str(f.type)} for f in fields]
        if target is None:
            rows = list(_rows(found, None if json else SHOWN))
            value = document(
                "campaign_query", watch, **head, count=len(rows), output=None, rows=rows
            )
            give(value, json, lambda answer: _print(answer, title))
            return
        count = _write(target, document("campaign_query", watch, **head), fields, found)
    if json:
        more = {"count": count, "output": str(target.path), "rows": []}
        console_value = document("campaign_query", watch, **head, **more)
        typer.echo(as_text(console_value), nl=False)
    elif not target.is_standard_output:
        console().print(f"{counted(count, 'row')} written: {escaped(str(target.path))}")


def _rows(batches: Iterable[Any], most: int | None = None) -> Iterator[list[Any]]:
    """Rows of values for JSON; one more than `most` at most."""
    count = 0
    for batch in batches:
        for row in zip(*(column.to_pylist() for column in batch.columns), strict=True):
            yield [_plain(each) for each in row]
            count += 1
            if most is not None and count > most:
                return


def _plain(value: Any) -> Any:
    if isinstance(value, float) and not math.isfinite(value):
        return str(value)
    if value is None or isinstance(value, str | int | float | bool):
        return value
    if isinstance(value, datetime):
        return value.isoformat(timespec="milliseconds")
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    if isinstance(value, dict):
        return {str(name): _plain(each) for name, each in value.items()}
    return str(value)


def _write(target: Target, head: dict[str, Any], fields: Any, found: Iterable[Any]) -> int:
    """Writes the answer as it comes; returns the number of rows."""
    count = 0

    def counted_batches() -> Iterator[Any]:
        nonlocal count
        for batch in found:
            count += batch.num_rows
            yield batch

    batches = counted_batches()
    names = [field.name for field in fields]
    if target.form in ("jsonl", "parquet") and len(set(names)) < len(names):
        what = "two columns of the answer have one name"
        raise Refusal(what, "SQL", "name them: SELECT ... AS name", "bad-sql")
    if target.form == "json":
        head = {**head, "seconds": None, "peak_bytes": None}
        target.write_pieces(listing(head, "rows", _rows(batches)))
    elif target.form == "jsonl":
        import json

        objects = (dict(zip(names, row, strict=True)) for row in _rows(batches))
        target.write_pieces(json.dumps(each) + "\n" for each in objects)
    else:
        with target.stream() as stream:
            _write_arrow(target.form, stream, fields, batches)
    return count


def _write_arrow(form: str, stream: Any, fields: Any, batches: Iterable[Any]) -> None:
    from pyarrow import csv, parquet

    made = csv.CSVWriter if form == "csv" else parquet.ParquetWriter
    with made(stream, fields) as writer:
        for batch in batches:
            writer.write_batch(batch)


def _print(value: dict[str, Any], title: str) -> None:
    out = console()
    if title:
        out.print(f"{title}:")
    numbers = [c["name"] for c in value["columns"] if _is_number(c["type"])]
    table = plain_table(*(escaped(c["name"]) for c in value["columns"]), right=numbers)
    for row in value["rows"][:SHOWN]:
        table.add_row(*(escaped(_shown(each)) for each in row))
    out.print(table)
    if len(value["rows"]) > SHOWN:
        out.print(f"the first {SHOWN} rows; --json or -o FILE gives all")
    elif not value["rows"]:
        out.print("no rows")


def _is_number(kind: str) -> bool:
    return kind.startswith(("int", "uint", "float", "double", "decimal"))


def _shown(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, float):
        return f"{value:,.2f}"
    return f"{value:,}" if isinstance(value, int) and not isinstance(value, bool) else str(value)
