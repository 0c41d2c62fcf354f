"""`minkref campaign status`: how far campaigns are."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref.cli.options import Json, Schema

EXAMPLES = """Examples:

minkref campaign status nightly

minkref campaign status nightly --json"""

Folder = Annotated[Path, typer.Argument(help="Folder of campaigns.", metavar="DIR")]


def command(folder: Folder, json: Json = False, schema: Schema = False) -> None:
    """Show the campaigns in a folder, also while they run: chunks, verdicts, kinds of findings."""
    from minkref.cli.output import give
    from minkref.output.documents import Stopwatch, document

    watch = Stopwatch()
    rows = campaigns_in(folder)
    value = document("campaign_status", watch, folder=str(folder), campaigns=rows)
    give(value, json, _print)


def campaigns_in(folder: Path) -> list[dict[str, Any]]:
    """Returns a row for each campaign, from the ledger and the last written state."""
    from minkref.fuzz.campaign.folder import heads, read_json, state_path
    from minkref.fuzz.ledgers.counting import counts
    from minkref.fuzz.ledgers.place import chunks_in

    rows = []
    for head in heads(folder):
        campaign = head["id"]
        path = state_path(folder, campaign)
        state = read_json(path) if path.is_file() else {}
        verdicts: Counter[str] = Counter()
        for (_, verdict), count in counts(folder, campaign).items():
            verdicts[verdict] += count
        rows.append(
            {
                "campaign": campaign,
                "name": head["name"],
                "minkref": head["minkref"],
                "seed": head["seed"],
                "versions": head["versions"],
                "families": head["families"],
                "chunks": len(chunks_in(folder, campaign)),
                "verdicts": dict(sorted(verdicts.items())),
                "cases": sum(state.get("cases", {}).values()),
                "kinds": len(state.get("kinds", [])),
                "behaviours": len(state.get("behaviours", [])),
                "campaign_seconds": state.get("spent", 0.0),
            }
        )
    return rows


def _print(value: dict[str, Any]) -> None:
    from minkref.cli.output import plain_table
    from minkref.output.terminal import console, escaped

    columns = ("chunks", "cases", "behaviours", "kinds")
    table = plain_table("campaign", "name", *columns, "seconds", "verdicts", right=columns)
    for row in value["campaigns"]:
        verdicts = ", ".join(f"{count:,} {verdict}" for verdict, count in row["verdicts"].items())
        table.add_row(
            row["campaign"],
            escaped(row["name"]),
            *(f"{row[column]:,}" for column in columns),
            f"{row['campaign_seconds']:,.0f}",
            verdicts,
        )
    console().print(table)
