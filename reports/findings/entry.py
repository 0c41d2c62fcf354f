"""A finding as it is kept in degeneracies/findings/findings.json."""

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
    """`fault`: its class. `case`: operands, sets, or a set and a radius, as `minkref verify --case`
    takes them. `answers`: what the library says; `right`: what is right. `witness`: a point, on
    which side of the truth it lies, and its tolerance; None for a crash. `issue`: upstream's, if
    one is known. `adapter` names the target of `minkref verify`."""

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
    """All findings, in the file's order."""
    values = json.loads((FOLDER / "findings.json").read_text(encoding="utf-8"))
    return tuple(Entry(**value) for value in values)
