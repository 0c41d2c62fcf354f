"""A member's files: the case, and beside it the certificate."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypedDict

from minkref.degeneracies.case_texts import CaseTexts
from minkref.output.documents import replacing
from minkref.output.output_folder import make_folder


class FileRow(TypedDict):
    family: str
    index: int
    id: str
    case: str
    certificate: str | None  # an invalid input has none
    bytes: int


@dataclass(frozen=True)
class Made:
    """A member's files, by name, before writing. `beside`: the certificate of a case, or the words
    that a message should hold for an invalid input; None for a case without certificate."""

    family: str
    index: int
    id: str
    case: tuple[str, bytes]
    beside: tuple[str, bytes] | None
    certified: bool = True

    def row(self, folder: Path) -> FileRow:
        """The row for the files in FOLDER/FAMILY."""
        case, content = self.case
        beside, more = self.beside or ("", b"")
        where = folder / self.family
        return {
            "family": self.family,
            "index": self.index,
            "id": self.id,
            "case": str(where / case),
            "certificate": str(where / beside) if self.certified and beside else None,
            "bytes": len(content) + len(more),
        }

    def write(self, folder: Path) -> FileRow:
        """Writes both or neither: the certificate takes its place first, so a case never lacks
        one."""
        where = folder / self.family
        make_folder(where)
        case, content = self.case
        with replacing(where / case) as part:
            part.write_bytes(content)
            if self.beside is not None:
                beside, more = self.beside
                with replacing(where / beside) as other:
                    other.write_bytes(more)
        return self.row(folder)


def made_case(made: CaseTexts[Any], index: int) -> Made:
    """Makes ID.json, and ID.cert.json if the member has a certificate."""
    case = f"{made.id}.json", made.case_text.encode()
    text = made.certificate_text
    certificate = None if text is None else (f"{made.id}.cert.json", text.encode())
    return Made(made.subject.name, index, made.id, case, certificate)
