"""`minkref report`: pages about what the project knows."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from minkref.degeneracies import lint
from minkref.degeneracies.files import folder_to_write
from minkref.documents import Stopwatch, as_text, document
from minkref.errors import Refusal
from minkref.options import Json, Schema
from minkref.progress import progress
from minkref.reports.degeneracies.page import write_report
from minkref.signals import ending_in_order
from minkref.terminal import shown

EXAMPLES = """Examples:

minkref report degeneracies -o report

minkref report degeneracies --corpus cases -o report"""

SUBJECTS = ("degeneracies",)


def command(
    subject: Annotated[
        str, typer.Argument(help=f"Of the pages: {', '.join(SUBJECTS)}.", metavar="SUBJECT")
    ],
    output: Annotated[
        str, typer.Option("-o", help="Folder for the pages.", metavar="DIR")
    ] = "report",
    corpus: Annotated[
        str | None,
        typer.Option(
            "--corpus",
            help="Folder of cases, as `minkref generate` makes them.",
            metavar="DIR",
            show_default="the corpus that comes with minkref",
        ),
    ] = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Write pages to be looked at. degeneracies: for each family what makes good code get it
    wrong, drawings of cases, and a table of all; what flags mean; invalid input."""
    watch = Stopwatch()
    if subject not in SUBJECTS:
        raise Refusal("there is no such report", shown(subject), f"name {' or '.join(SUBJECTS)}")
    folder = folder_to_write(output)
    cases = _corpus(corpus)
    with ending_in_order(), progress(len(lint.case_paths(cases))) as line:

        def reading(family: str) -> None:
            line.now(family)
            line.done()

        front = write_report(folder, cases, reading)
    if json:
        sys.stdout.write(as_text(document("report", watch, subject=subject, front=str(front))))
    else:
        sys.stdout.write(f"{shown(str(front))}\n")


def _corpus(name: str | None) -> Path:
    """The folder with cases; Path would take an empty name for the folder where you are."""
    folder = lint.CORPUS if name is None else Path(name)
    if name == "" or not folder.is_dir():
        mend = "name a folder that `minkref generate all -o DIR` has made"
        raise Refusal("there is no such folder", f"--corpus {shown(name or repr(name))}", mend)
    if not lint.case_paths(folder):
        mend = "make some with `minkref generate all -o DIR`"
        raise Refusal("there is no case in this folder", str(folder), mend, "no-case-files")
    return folder
