"""The rows of a sweep, in the plane and in space: found, written, and shown to people."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from minkref.cli.output import print_lines
from minkref.cli.progress import Steps
from minkref.cli.row_spool import Row, RowSpool
from minkref.errors import refusing
from minkref.output.documents import lasting, listing
from minkref.output.terminal import console
from minkref.plane.commands.sweep_folder import INDEX, SweepFolder

if TYPE_CHECKING:
    from rich.table import Table

SHOWN = 1000  # scales that people see

Scale = TypeVar("Scale")
Sum = TypeVar("Sum")


@dataclass(frozen=True)
class Setting(Generic[Scale, Sum]):
    """`told`: a scale on the line of progress. `text` and `is_exact`: a sum in a format."""

    told: Callable[[Scale], str]
    text: Callable[[Sum, str], str]
    is_exact: Callable[[Sum, str], bool]


def sweep_rows(
    scales: Sequence[Scale],
    step: Callable[[Scale], tuple[Row, Sum]],
    setting: Setting[Scale, Sum],
    folder: SweepFolder | None,
    line: Steps,
) -> RowSpool:
    """A row and, where there is a folder, a file for each scale."""
    rows = RowSpool()
    for number, scale in enumerate(scales, start=1):
        line.now(f"scale {setting.told(scale)}")
        row, found = step(scale)
        row["file"] = row["file_exact"] = None
        if folder is not None:
            row["file"] = folder.name(number)
            row["file_exact"] = setting.is_exact(found, folder.form)
            folder.write(row["file"], _text(setting, found, folder.form, row["file"]))
        rows.add(row)
        line.done()
    return rows


def _text(setting: Setting[Scale, Sum], found: Sum, form: str, name: str) -> str:
    return refusing(name, lambda: setting.text(found, form))


def write_index(folder: SweepFolder | None, value: dict[str, Any], rows: RowSpool) -> None:
    if folder is not None:
        folder.write(INDEX, listing(lasting(value), "rows", map(lasting, rows)))


def print_sweep(
    table: Table, rows: RowSpool, summary: list[tuple[str, str]], value: dict[str, Any]
) -> None:
    """The table of the first SHOWN rows, and below it the summary."""
    console().print(table)
    if len(rows) > SHOWN:
        sys.stdout.write(f"{len(rows) - SHOWN:,} more: --json or -o DIR gives all\n")
    if value["output"]:
        summary.append(("written", value["output"]))
    sys.stdout.write("\n")
    print_lines(summary, value)


def first_wrong(rows: RowSpool) -> str | None:
    """The first scale of the sweep at which the paper's program has another structure."""
    wrong = (
        row["scale"] for row in rows if row.get("exact") and not row["exact"]["same_structure"]
    )
    return next(wrong, None)
