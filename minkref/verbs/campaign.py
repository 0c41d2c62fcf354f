"""`minkref campaign`: verification beyond one machine."""

from __future__ import annotations

import typer
from minkref.verbs import (
    campaign_compact,
    campaign_merge,
    campaign_query,
    campaign_run,
    campaign_site,
    campaign_status,
)

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="rich",
    help="Verification beyond one machine: run, resume, merge, ask, publish.",
)

app.command("run", epilog=campaign_run.EXAMPLES)(campaign_run.command)
app.command("status", epilog=campaign_status.EXAMPLES)(campaign_status.command)
app.command("merge", epilog=campaign_merge.EXAMPLES)(campaign_merge.command)
app.command("compact", epilog=campaign_compact.EXAMPLES)(campaign_compact.command)
app.command("query", epilog=campaign_query.EXAMPLES)(campaign_query.command)
app.command("site", epilog=campaign_site.EXAMPLES)(campaign_site.command)
