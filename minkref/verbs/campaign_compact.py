"""`minkref campaign compact`: few large files of many small ones."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer
from minkref.cli.options import Json, Schema
from minkref.cli.output import give
from minkref.errors import Refusal
from minkref.output.documents import Stopwatch, document
from minkref.output.signals import ending_in_order
from minkref.output.terminal import console, counted

EXAMPLES = """Examples:

minkref campaign compact nightly"""

Ledger = Annotated[Path, typer.Argument(help="Folder of the campaign.", metavar="DIR")]


def command(folder: Ledger, json: Json = False, schema: Schema = False) -> None:
    """Make few large files of a ledger's parts, with counts that answer questions at once. A
    campaign does this by itself while it runs; nothing is lost if it is ended. Verifies the
    checksums of all parts that it reads."""
    from minkref.fuzz.ledgers.compaction import compact
    from minkref.fuzz.ledgers.place import is_ledger

    watch = Stopwatch()
    if not is_ledger(folder):
        mend = "name the folder of a campaign: minkref campaign run FILE.toml"
        raise Refusal("there is no ledger in this folder", str(folder), mend, "no-ledger")
    with ending_in_order():
        done = compact(folder)
    give(document("campaign_compact", watch, folder=str(folder), **vars(done)), json, _print)


def _print(value: dict[str, Any]) -> None:
    chunks, files = counted(value["chunks"], "chunk"), counted(value["files"], "file")
    console().print(f"{chunks}, {counted(value['rows'], 'row')}: {files} written")
