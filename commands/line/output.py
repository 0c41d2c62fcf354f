"""What a command gives: one JSON document for programs, or lines and tables for people."""

from __future__ import annotations

import sys
from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Any

from minkref.documents import as_text
from minkref.exact import scientific
from minkref.terminal import escaped, lines

if TYPE_CHECKING:
    from rich.table import Table


def give(value: dict[str, Any], json: bool, shown: Callable[[dict[str, Any]], None]) -> None:
    """Prints the document where --json asks for it, or has it `shown`."""
    if json:
        sys.stdout.write(as_text(value))
    else:
        shown(value)


def print_lines(rows: list[tuple[str, str]], value: dict[str, Any]) -> None:
    """Names and values in two columns; then the warnings of the document."""
    sys.stdout.write(lines(rows))
    for warning in value["warnings"]:
        sys.stderr.write(f"warning: {escaped(warning)}\n")


def measure(exact: str, near: float | None) -> str:
    """An area or volume, rounded and exact. `near`: None where it is beyond doubles."""
    exactly = exact if len(exact) <= 60 else f"({len(exact):,} characters; --json prints it)"
    return f"{scientific(exact) if near is None else f'{near:.10g}'} = {exactly}"


def written_row(value: dict[str, Any]) -> list[tuple[str, str]]:
    """The line that says where a sum was written; none where it was not."""
    if not value["output"]:
        return []
    rounded = "" if value["output_exact"] else " (rounded; .json is exact)"
    return [("written", value["output"] + rounded)]


def plain_table(*headings: str, right: Collection[str] = (), whole: bool = False) -> Table:
    """Without lines. `right`: the headings of columns of numbers; `whole`: nothing is cut off."""
    from rich.table import Table

    table = Table(box=None, pad_edge=False)
    for heading in headings:
        table.add_column(heading, justify="right" if heading in right else "left", no_wrap=whole)
    return table
