"""`minkref campaign site`: pages with history, which release mended or broke what."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer
from minkref.cli.options import Json, Schema
from minkref.cli.output import give
from minkref.output.documents import Stopwatch, document
from minkref.output.output_folder import folder_to_write
from minkref.output.signals import ending_in_order
from minkref.output.terminal import console, escaped
from minkref.verbs.campaign_compact import Ledger

EXAMPLES = """Examples:

minkref campaign site nightly -o site"""


def command(
    folder: Ledger,
    output: Annotated[
        str, typer.Option("-o", "--output", help="Folder for the pages.", metavar="DIR")
    ] = "site",
    live: Annotated[
        bool, typer.Option("--live", help="Pages that load themselves again each minute.")
    ] = False,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Write static pages of a ledger: each library in each version, right of judged by family,
    kinds of faults with the versions in which they were seen, and what each release mended or
    broke, with cases to reproduce it."""
    from minkref.reports.history.page import subjects_of, write_site

    watch = Stopwatch()
    path: Path = folder_to_write(output)
    with ending_in_order():
        page = write_site(folder, path, live)
    value = document("campaign_site", watch, folder=str(folder), page=str(page))
    value["subjects"] = subjects_of(folder)
    give(value, json, _print)


def _print(value: dict[str, Any]) -> None:
    console().print(escaped(value["page"]))
