"""A finding, read from degeneracies/findings/findings.json."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import minkref.degeneracies

FOLDER = Path(minkref.degeneracies.__file__).parent / "findings"
LANGUAGES = {
    ".py": "python", ".mjs": "js", ".java": "java", ".rs": "rust", ".cpp": "cpp", ".scad": "scad",
}  # fmt: skip


@dataclass(frozen=True)
class Entry:
    """`fault`: a class. `case`: operands, sets, a set and a radius, or a path, as `minkref
    verify --case` takes them. `answers`: the library's answer; `right`: the truth. `witness`: a
    point, its side in truth, and a tolerance (on a path the part's place, in where it collides);
    None for a crash. `issue`: upstream's, if known. `adapter` names the
    target of `minkref verify`."""

    id: str
    library: str
    call: str
    first: str
    last: str
    verb: str
    fault: str
    title: str
    answers: str
    right: str
    case: dict[str, Any]
    witness: dict[str, Any] | None
    issue: str | None
    adapter: str
    program: str

    @property
    def path(self) -> Path:
        return FOLDER / "programs" / self.program

    @property
    def language(self) -> str:
        return LANGUAGES[self.path.suffix]

    @property
    def reproduce(self) -> str:
        text = json.dumps(self.case, separators=(",", ":"))
        return f"minkref verify {self.adapter} --case '{text}'"

    @property
    def versions(self) -> str:
        return self.first if self.first == self.last else f"{self.first} to {self.last}"


@cache
def entries() -> tuple[Entry, ...]:
    """All findings, as listed."""
    values = json.loads((FOLDER / "findings.json").read_text(encoding="utf-8"))
    return tuple(Entry(**value) for value in values)
