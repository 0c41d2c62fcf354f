"""`minkref report`: pages about what the project knows."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from minkref.degeneracies import lint
from minkref.documents import Stopwatch, as_text, document
from minkref.errors import Refusal
from minkref.options import Json, Schema
from minkref.reports.degeneracies.page import write_report
from minkref.signals import ending_in_order
from minkref.terminal import shown

EXAMPLES = """Examples:

minkref report degeneracies -o report

minkref report degeneracies --corpus cases -o report"""

SUBJECTS = ("degeneracies",)


def command(
    subject: Annotated[str, typer.Argument(help=f"{', '.join(SUBJECTS)}.", metavar="SUBJECT")],
    output: Annotated[Path, typer.Option("-o", help="Folder for the pages.", metavar="DIR")] = Path(
        "report"
    ),
    corpus: Annotated[
        Path,
        typer.Option(
            "--corpus",
            help="Cases, as `minkref generate` makes them.",
            show_default="the corpus that comes with minkref",
        ),
    ] = lint.CORPUS,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Write pages to be looked at. degeneracies: for each family what makes good code get it
    wrong, drawings of cases, and a table of all; what flags mean; invalid input."""
    watch = Stopwatch()
    if subject not in SUBJECTS:
        raise Refusal("there is no such report", shown(subject), f"name {' or '.join(SUBJECTS)}")
    if not lint.case_paths(corpus):
        mend = "make some with `minkref generate all -o DIR`"
        raise Refusal("there is no case in this folder", str(corpus), mend, "no-case-files")
    with ending_in_order():
        front = write_report(output, corpus)
    if json:
        sys.stdout.write(as_text(document("report", watch, subject=subject, front=str(front))))
    else:
        sys.stdout.write(f"{shown(str(front))}\n")
