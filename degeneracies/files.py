"""The files of a member: the case, and its certificate beside it."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import TypedDict

from minkref.degeneracies.case_document import Degenerate
from minkref.degeneracies.draft import Family
from minkref.degeneracies.found import Story
from minkref.degeneracies.invalid.catalogue import invalid_member
from minkref.degeneracies.invalid.member import InvalidFamily
from minkref.documents import replacing, write_atomically


class FileRow(TypedDict):
    family: str
    index: int
    id: str
    case: str
    certificate: str | None  # an invalid input has none
    bytes: int


def write_member(family: Family, seed: int, index: int, folder: Path) -> FileRow:
    """FOLDER/FAMILY/ID.json and FOLDER/FAMILY/ID.cert.json."""
    return _write(Degenerate.of(family, seed, index), index, folder)


def write_found(story: Story, folder: Path) -> FileRow:
    return _write(Degenerate(story, story.facts, "found by verification, or published"), 0, folder)


def write_invalid(family: InvalidFamily, seed: int, index: int, folder: Path) -> FileRow:
    """FOLDER/FAMILY/ID.EXT, which must be refused; ID.refusal.json: what a message should say."""
    made = invalid_member(family, seed, index)
    content = made.content + (made.scale or "").encode()
    stem = f"{family.name}-{hashlib.sha256(content).hexdigest()[:12]}"
    where = folder / family.name
    where.mkdir(parents=True, exist_ok=True)
    case = where / f"{stem}{Path(made.file_name).suffix}"
    told = {
        "file": case.name,
        "operand": f"{case.name}{made.part}",
        "scale": made.scale,
        "code": made.code,
        "place": list(made.place),
        "source": f"minkref generate {family.name} --seed {seed}, member {index}",
    }
    refusal = where / f"{stem}.refusal.json"
    write_atomically(refusal, json.dumps(told) + "\n")
    with replacing(case) as part:
        part.write_bytes(made.content)
    return {
        "family": family.name,
        "index": index,
        "id": stem,
        "case": str(case),
        "certificate": None,
        "bytes": case.stat().st_size + refusal.stat().st_size,
    }


def _write(made: Degenerate, index: int, folder: Path) -> FileRow:
    """The certificate first: a case that is there has its certificate."""
    where = folder / made.subject.name
    where.mkdir(parents=True, exist_ok=True)
    case, certificate = where / f"{made.id}.json", where / f"{made.id}.cert.json"
    write_atomically(certificate, made.certificate_text)
    write_atomically(case, made.case_text)
    return {
        "family": made.subject.name,
        "index": index,
        "id": made.id,
        "case": str(case),
        "certificate": str(certificate),
        "bytes": case.stat().st_size + certificate.stat().st_size,
    }
