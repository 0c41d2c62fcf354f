"""Output of a command: one JSON document for programs, or lines and tables for people."""

from __future__ import annotations

import sys
from collections.abc import Callable, Collection
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from minkref.exact import rounded
from minkref.output.documents import as_text
from minkref.output.terminal import escaped, lines

if TYPE_CHECKING:
    from rich.table import Table


LONGEST_NUMBER = 60  # characters, in a table


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


def measure(exact: str) -> str:
    """An area or volume: exact, and beside it as a decimal, which is told from it where it is
    rounded."""
    near = rounded(exact)
    if near == exact:
        return exact
    if len(exact) > LONGEST_NUMBER:
        return f"about {near} ({len(exact):,} characters; --json prints it)"
    return f"{exact} = {near}" if Fraction(near) == Fraction(exact) else f"{exact}, about {near}"


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
