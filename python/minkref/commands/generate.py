"""`minkref generate FAMILY...|all`: degenerate cases, each with its certificate."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.table import Table

from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.files import FileRow, write_invalid, write_member
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES
from minkref.documents import Stopwatch, as_text, check_writable, document
from minkref.errors import Refusal
from minkref.options import Json, Schema
from minkref.progress import progress
from minkref.signals import ending_in_order
from minkref.terminal import console, counted, shown

EXAMPLES = """Examples:

minkref generate hole-to-segment --count 100 -o cases

minkref generate all --seed 7 -o cases && minkref check cases

minkref generate invalid --count 3 -o bad

minkref verify cgal-reduced --suite corpus --corpus cases"""

ALL, INVALID = "all", "invalid"
DEFAULT_FOLDER = Path("degenerate-cases")
Task = tuple[str, int, int, Path]


def command(
    families: Annotated[
        list[str],
        typer.Argument(
            help="Families (`minkref families`); all: those with certificates; invalid: those "
            "that must be refused.",
            metavar="FAMILY...|all|invalid",
        ),
    ],
    count: Annotated[int, typer.Option("--count", help="Cases of each family.", min=1)] = 10,
    seed: Annotated[int, typer.Option("--seed", help="Another seed, other cases.")] = 1,
    output: Annotated[
        Path,
        typer.Option(
            "-o", help="Folder for FAMILY/ID.json and FAMILY/ID.cert.json.", metavar="DIR"
        ),
    ] = DEFAULT_FOLDER,
    jobs: Annotated[int, typer.Option("--jobs", help="Processes; 0: as many as cores.", min=0)] = 0,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Make degenerate cases by the hundred (docs/degeneracies.md): files with operands, scales,
    what is expected at each, and why good code gets it wrong; beside each a certificate of all
    that. The same family, seed and number give the same bytes on every machine."""
    watch = Stopwatch()
    names = _chosen(families)
    if output.exists() and not output.is_dir():
        raise Refusal("this is not a folder", str(output), "name a folder", "cannot-write")
    check_writable(output / "ID.json" if output.is_dir() else output)
    tasks = [(name, seed, index, output) for name in names for index in range(count)]
    rows: list[FileRow] = []
    began = time.perf_counter()
    with ending_in_order(), progress(len(tasks)) as line:
        for row in _made(tasks, jobs or os.cpu_count() or 1):
            line.now(row["family"])
            rows.append(row)
            line.done()
    value = document(
        "generate",
        watch,
        output=str(output),
        seed=seed,
        cases_per_second=round(len(rows) / (time.perf_counter() - began), 3),
        bytes=sum(row["bytes"] for row in rows),
        cases=rows,
    )
    if json:
        sys.stdout.write(as_text(value))
    else:
        _print(value)


def _chosen(families: list[str]) -> list[str]:
    known = {ALL: list(FAMILIES), INVALID: list(INVALID_FAMILIES)}
    known |= {name: [name] for name in (*FAMILIES, *INVALID_FAMILIES)}
    unknown = [name for name in families if name not in known]
    if unknown:
        mend = "`minkref families` lists those that are generated with certificates"
        raise Refusal("there is no such family", shown(unknown[0]), mend, "unknown-family")
    return list(dict.fromkeys(name for word in families for name in known[word]))


def _made(tasks: list[Task], jobs: int) -> Iterator[FileRow]:
    if jobs == 1 or len(tasks) == 1:
        yield from map(_make, tasks)
        return
    with ProcessPoolExecutor(min(jobs, len(tasks)), get_context("spawn")) as pool:
        try:
            yield from pool.map(_make, tasks, chunksize=4)
        except BaseException:
            pool.shutdown(wait=True, cancel_futures=True)
            raise


def _make(task: Task) -> FileRow:
    name, seed, index, folder = task
    try:
        if name in INVALID_FAMILIES:
            return write_invalid(INVALID_FAMILIES[name], seed, index, folder)
        return write_member(FAMILIES[name], seed, index, folder)
    except (Refusal, OSError):
        raise
    except Exception as error:
        raise RuntimeError(f"member {name}:{seed}:{index}: {error}") from error


def _print(value: dict[str, Any]) -> None:
    table = Table(box=None, pad_edge=False)
    for heading in ("family", "cases", "bytes"):
        table.add_column(heading)
    for name in dict.fromkeys(row["family"] for row in value["cases"]):
        rows = [row for row in value["cases"] if row["family"] == name]
        table.add_row(name, f"{len(rows):,}", f"{sum(row['bytes'] for row in rows):,}")
    console().print(table)
    different = len({row["id"] for row in value["cases"]})
    certified = any(row["certificate"] for row in value["cases"])
    sys.stdout.write(
        f"{counted(len(value['cases']), 'case')}, {different:,} different, "
        f"{value['bytes']:,} bytes, {value['cases_per_second']:.1f} a second\n"
        + (f"check them: minkref check {shown(value['output'])}\n" if certified else "")
    )
