"""`minkref campaign run`: begins a campaign, or goes on with it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer
from minkref.cli.options import Json, Schema

EXAMPLES = """Examples:

minkref campaign run nightly.toml

minkref campaign run nightly.toml --workers 8 --cases 1000000 -o nightly

minkref campaign run nightly.toml --scheduler tcp://10.0.0.1:8786 --json"""

File = Annotated[Path, typer.Argument(help="The campaign.", metavar="CAMPAIGN.toml")]
Folder = Annotated[
    Path | None,
    typer.Option(
        "-o",
        "--output",
        help="Folder of the ledger; a campaign found there goes on. Default: the name of the file.",
        metavar="DIR",
    ),
]
Workers = Annotated[
    int | None,
    typer.Option("--workers", help="Worker processes here. Default: one per core.", metavar="N"),
]
Scheduler = Annotated[
    str | None,
    typer.Option(
        "--scheduler", help="Use the workers of this Dask scheduler.", metavar="tcp://HOST:PORT"
    ),
]
CaseBudget = Annotated[
    int | None, typer.Option("--cases", help="Cases in all, instead of the file's.", metavar="N")
]
TimeBudget = Annotated[
    float | None,
    typer.Option("--seconds", help="Time of all runs, instead of the file's.", metavar="N"),
]
Share = Annotated[
    str,
    typer.Option(
        "--share",
        help="Take the K-th of N shares; `minkref campaign merge` joins them.",
        metavar="K/N",
    ),
]
Site = Annotated[
    Path | None,
    typer.Option("--site", help="Write pages with the history there, each minute.", metavar="DIR"),
]
Strict = Annotated[
    bool, typer.Option("--strict", help="Exit with 4 if something stays undecided or is given up.")
]
Quiet = Annotated[
    bool, typer.Option("--quiet", help="Print nothing; see the exit code and the folder.")
]


def command(
    file: File,
    output: Folder = None,
    workers: Workers = None,
    scheduler: Scheduler = None,
    cases: CaseBudget = None,
    seconds: TimeBudget = None,
    share: Share = "1/1",
    site: Site = None,
    strict: Strict = False,
    quiet: Quiet = False,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Run a campaign on many workers. Run again to continue after any end, or with a larger
    budget. Findings do not depend on workers."""
    asked: dict[str, Any] = {name: value for name, value in locals().items() if name != "schema"}
    from minkref.verbs.campaign_request import CampaignRequest
    from minkref.verbs.campaign_work import answer  # all judges, which --help does not need

    answer(CampaignRequest(**asked))
