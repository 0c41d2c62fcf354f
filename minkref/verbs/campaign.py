"""`minkref campaign`: verification beyond one machine."""

from __future__ import annotations

import typer
from minkref.verbs import campaign_compact, campaign_query, campaign_site

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="rich",
    help="Verification beyond one machine: run, resume, merge, ask, publish.",
)

app.command("compact", epilog=campaign_compact.EXAMPLES)(campaign_compact.command)
app.command("query", epilog=campaign_query.EXAMPLES)(campaign_query.command)
app.command("site", epilog=campaign_site.EXAMPLES)(campaign_site.command)
