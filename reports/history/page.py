"""A site with history: which release of a library mended or broke what."""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref.fuzz.ledgers.heard import run
from minkref.fuzz.ledgers.questions import named
from minkref.fuzz.ledgers.views import opened
from minkref.output.documents import write_together
from minkref.output.output_folder import make_folder
from minkref.reports.conformance.finding_page import file_names
from minkref.reports.conformance.words import REASONS, VERDICTS
from minkref.reports.pages import environment

FRONT = "index.html"
QUESTIONS = ("families", "first-seen", "regressions", "slowest", "campaigns")
Row = dict[str, Any]


@dataclass(frozen=True)
class Release:
    """A version of a subject. `right`, `judged`: answers; `broken`, `mended`: cases that differ
    from the version before."""

    version: str
    right: int
    judged: int
    skipped: int
    broken: int
    mended: int

    @property
    def worst(self) -> str:
        return "pass" if self.right == self.judged else "wrong"


@dataclass(frozen=True)
class Subject:
    """A library's target over its versions. `families`: rows of a name and the numbers of each
    version, None where it was not asked."""

    name: str
    file: str
    releases: list[Release]
    families: list[tuple[str, list[Row | None]]]
    kinds: list[Row]
    changes: list[Row]
    slowest: list[Row]


def write_site(folder: Path, output: Path, live: bool = False) -> Path:
    """Writes `index.html` and a page for each library, all or none; returns the front page. `live`:
    the pages load themselves again each minute. Cost: that of the questions, seconds for 10^8
    rows. Refuses a folder without ledger."""
    answers = _answers(folder)
    subjects = _subjects(answers)
    templates = environment("history")
    shared = {"subjects": subjects, "campaigns": answers["campaigns"], "live": live}
    make_folder(output)
    files: dict[Path, str | bytes] = {
        output / f"{subject.file}.html": templates.get_template("subject.html.j2").render(
            **shared, subject=subject
        )
        for subject in subjects
    }
    files[output / FRONT] = templates.get_template("index.html.j2").render(**shared)
    write_together(files)
    return output / FRONT


def subjects_of(folder: Path) -> list[str]:
    """The libraries that have pages."""
    with opened(folder) as con:
        rows = run(con, "SELECT DISTINCT subject FROM versions ORDER BY subject")
    return [subject for (subject,) in rows]


def _answers(folder: Path) -> dict[str, list[Row]]:
    found: dict[str, list[Row]] = {}
    with opened(folder) as con:
        for name in QUESTIONS:
            found[name] = con.sql(named(name).sql).to_arrow_table().to_pylist()
    return found


def _subjects(answers: dict[str, list[Row]]) -> list[Subject]:
    names = list(dict.fromkeys(row["subject"] for row in answers["families"]))
    files = file_names(f"history-{name}" for name in names)
    return [_subject(name, file, answers) for name, file in zip(names, files, strict=True)]


def _subject(name: str, file: str, answers: dict[str, list[Row]]) -> Subject:
    own = {q: [row for row in answers[q] if row.get("subject") == name] for q in QUESTIONS}
    versions = list(dict.fromkeys(row["version"] for row in own["families"]))
    releases = [_release(version, own) for version in versions]
    cells = {(row["family"], row["version"]): row for row in own["families"]}
    families = sorted({row["family"] for row in own["families"]})
    rows: list[tuple[str, list[Row | None]]] = [
        (family, [cells.get((family, version)) for version in versions]) for family in families
    ]
    kinds = [{**row, "meaning": meaning(row["verdict"], row["kind"])} for row in own["first-seen"]]
    changes = [{**row, "command": _command(name, row["example"])} for row in own["regressions"]]
    for row in kinds:
        row["command"] = _command(name, row["example"])
    return Subject(name, file, releases, rows, kinds, changes, own["slowest"])


def _release(version: str, own: dict[str, list[Row]]) -> Release:
    mine = [row for row in own["families"] if row["version"] == version]
    steps = [row for row in own["regressions"] if row["version"] == version]

    def changed(how: str) -> int:
        return sum(row["cases"] for row in steps if row["change"] == how)

    right = sum(row["right"] for row in mine)
    skipped = sum(row["skipped"] for row in mine)
    judged = sum(row["asked"] for row in mine) - skipped
    return Release(version, right, judged, skipped, changed("broken"), changed("mended"))


def meaning(verdict: str, kind: str) -> str:
    """Says in words what a kind of fault means."""
    reasons = {str(reason): text for reason, text in REASONS.items()}
    words = [reasons[word] for word in kind.split() if word in reasons]
    meanings = {str(each): text for each, text in VERDICTS.items()}
    return "; ".join(words) or meanings.get(verdict, "")


def _command(subject: str, example: str | None) -> str:
    return shlex.join(["minkref", "verify", subject, "--case", example]) if example else ""
