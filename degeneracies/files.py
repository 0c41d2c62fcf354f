"""The files of a member: the case, and its certificate beside it."""

from __future__ import annotations

from pathlib import Path
from typing import TypedDict

from minkref.degeneracies.case_document import Degenerate
from minkref.degeneracies.draft import Family
from minkref.degeneracies.found import Story
from minkref.documents import write_atomically


class FileRow(TypedDict):
    family: str
    index: int
    id: str
    case: str
    certificate: str
    bytes: int


def write_member(family: Family, seed: int, index: int, folder: Path) -> FileRow:
    """FOLDER/FAMILY/ID.json and FOLDER/FAMILY/ID.cert.json."""
    return _write(Degenerate.of(family, seed, index), folder)


def write_found(story: Story, folder: Path) -> FileRow:
    return _write(Degenerate(story, 0, 0, story.facts), folder)


def _write(made: Degenerate, folder: Path) -> FileRow:
    """The certificate first: a case that is there has its certificate."""
    where = folder / made.family.name
    where.mkdir(parents=True, exist_ok=True)
    case, certificate = where / f"{made.id}.json", where / f"{made.id}.cert.json"
    write_atomically(certificate, made.certificate_text)
    write_atomically(case, made.case_text)
    return {
        "family": made.family.name,
        "index": made.index,
        "id": made.id,
        "case": str(case),
        "certificate": str(certificate),
        "bytes": case.stat().st_size + certificate.stat().st_size,
    }
