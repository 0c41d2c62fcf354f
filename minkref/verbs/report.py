"""`minkref report`: pages about what the project knows."""

from __future__ import annotations

import sys
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref.cli.options import Json, Schema
from minkref.cli.progress import progress
from minkref.degeneracies import lint
from minkref.errors import Refusal, nearest
from minkref.output.documents import Stopwatch, as_text, document
from minkref.output.exits import ExitCode
from minkref.output.output_folder import folder_to_write
from minkref.output.signals import ending_in_order
from minkref.output.terminal import escaped
from minkref.reports.degeneracies.page import case_paths_of_report, write_report

EXAMPLES = """Examples:

minkref report audit paper -o report

minkref report audit --quick

minkref report degeneracies --corpus cases -o report

minkref report findings --quick -o findings

MINKREF_MODELS=folder minkref report paper"""

SUBJECTS = ("audit", "paper", "degeneracies", "findings")
PACKAGES = "the packages matplotlib, sympy, markdown-it-py, mdit-py-plugins and latex2mathml"


def command(
    subjects: Annotated[
        list[str], typer.Argument(help=f"Which pages: {', '.join(SUBJECTS)}.", metavar="SUBJECT...")
    ],
    output: Annotated[
        str, typer.Option("-o", help="Folder for the pages.", metavar="DIR")
    ] = "report",
    quick: Annotated[
        bool, typer.Option("--quick", help="audit, paper, findings: leave out what takes long.")
    ] = False,
    seed: Annotated[
        int, typer.Option("--seed", help="paper: seed of the re-scalings of Table 1.", metavar="K")
    ] = 1,
    corpus: Annotated[
        str | None,
        typer.Option(
            "--corpus",
            help="degeneracies: folder of cases, as `minkref generate` makes them.",
            metavar="DIR",
            show_default="the corpus that comes with minkref",
        ),
    ] = None,
    json: Json = False,
    schema: Schema = False,
) -> ExitCode:
    """Write pages, most as HTML. audit: which formulas of the paper hold, with a check for each
    (exit code 1 if one fails). paper: its tables, figures and times beside ours. degeneracies: for
    each family why good code gets it wrong, drawings of cases, and a table of all cases; what the
    flags mean; invalid input. findings: wrong answers of libraries: which still show, by programs
    that use the library alone, and a report about each, ready to send, as Markdown."""
    watch = Stopwatch()
    for subject in subjects:
        if subject not in SUBJECTS:
            mend = f"{nearest(subject, SUBJECTS)}name some of {', '.join(SUBJECTS)}"
            raise Refusal("there is no such report", escaped(subject), mend)
    folder = folder_to_write(output)
    cases = _corpus(corpus)
    fronts: list[Path] = []
    failed: list[dict[str, Any]] = []
    with ending_in_order():
        for subject in dict.fromkeys(subjects):
            if subject == "audit":
                front, failures = _audit(folder, quick)
                failed += failures
            elif subject == "paper":
                front = _paper(folder, quick, seed)
            elif subject == "findings":
                front = _findings(folder, quick)
            else:
                front = _degeneracies(folder, cases)
            fronts.append(front)
    if json:
        pages = [str(front) for front in fronts]
        sys.stdout.write(
            as_text(document("report", watch, subjects=subjects, pages=pages, failed=failed))
        )
    else:
        for front in fronts:
            sys.stdout.write(f"{escaped(str(front))}\n")
        for failure in failed:
            sys.stdout.write(f"check failed: {failure['entry']}: {escaped(failure['failure'])}\n")
    return ExitCode.WRONG if failed else ExitCode.ALL_WELL


def _audit(folder: Path, quick: bool) -> tuple[Path, list[dict[str, Any]]]:
    page, catalogue = _imported("audit.page", "audit.catalogue")
    with progress(len(catalogue.ENTRIES)) as line:
        outcomes = page.write_audit(folder, quick, line.now, line.done)
    failed = [{"entry": o.entry.name, "failure": o.failure} for o in outcomes if o.failure]
    return folder / page.PAGE, failed


def _paper(folder: Path, quick: bool, seed: int) -> Path:
    page, made = _imported("paper.page", "paper.entries")
    with progress(made.steps(quick)) as line:
        front: Path = page.write_paper(folder, quick, seed, line.now, line.done)
    return front


def _degeneracies(folder: Path, cases: Path) -> Path:
    with progress(len(case_paths_of_report(cases))) as line:

        def reading(family: str) -> None:
            line.now(family)
            line.done()

        return write_report(folder, cases, reading)


def _findings(folder: Path, quick: bool) -> Path:
    entry, made = _imported("findings.entry", "findings.reports")
    with progress(len(entry.entries())) as line:
        front: Path = made.write_findings(folder, quick, line.now, line.done)
    return front


def _imported(*names: str) -> list[Any]:
    """Modules of `reports/`, which take a second, and packages that other commands do not need."""
    try:
        return [import_module(f"minkref.reports.{name}") for name in names]
    except ModuleNotFoundError as error:
        mend = f"install {PACKAGES}: pip install 'minkref[reports]'"
        raise Refusal("a package is missing", str(error.name), mend, "missing-package") from error


def _corpus(name: str | None) -> Path:
    """The folder with cases; Path would take an empty name for the folder where you are."""
    folder = lint.CORPUS if name is None else Path(name)
    if name == "" or not folder.is_dir():
        mend = "name a folder that `minkref generate all -o DIR` has made"
        raise Refusal("there is no such folder", f"--corpus {escaped(name or repr(name))}", mend)
    if not lint.case_paths(folder):
        mend = "make some with `minkref generate all -o DIR`"
        raise Refusal("there is no case in this folder", str(folder), mend, "no-case-files")
    return folder
