"""A member's files: the case, and beside it the certificate."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path
from typing import TypedDict

from minkref.degeneracies.disc.case_document import DegenerateWithDisc
from minkref.degeneracies.disc.draft import DiscFamily
from minkref.degeneracies.found import Story
from minkref.degeneracies.invalid.catalogue import invalid_member
from minkref.degeneracies.invalid.member import InvalidFamily
from minkref.degeneracies.motion.case_document import DegeneratePath
from minkref.degeneracies.motion.draft import PathFamily
from minkref.degeneracies.plane.case_document import Degenerate
from minkref.degeneracies.plane.draft import Family
from minkref.degeneracies.solids.case_document import DegenerateSolids
from minkref.degeneracies.solids.draft import SolidFamily
from minkref.degeneracies.space.case_document import DegenerateInSpace
from minkref.degeneracies.space.draft import SpaceFamily
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


AnyFamily = Family | SpaceFamily | SolidFamily
AnyDegenerate = Degenerate | DegenerateInSpace | DegenerateSolids


def made_member(family: AnyFamily, seed: int, index: int, size: int | None = None) -> Made:
    """Makes ID.json, and ID.cert.json if the member has a certificate."""
    return _made(member_of(family, seed, index, size), index)


def member_of(family: AnyFamily, seed: int, index: int, size: int | None = None) -> AnyDegenerate:
    """Makes a member in the plane or in space."""
    if isinstance(family, SolidFamily):
        return DegenerateSolids.of(family, seed, index, size)
    if isinstance(family, SpaceFamily):
        return DegenerateInSpace.of(family, seed, index, size)
    return Degenerate.of(family, seed, index, size)


def made_with_disc(family: DiscFamily, seed: int, index: int, size: int | None = None) -> Made:
    """ID.json, of disc-case-v1."""
    return _made(DegenerateWithDisc.of(family, seed, index, size), index)


def made_path(family: PathFamily, seed: int, index: int) -> Made:
    """ID.json, of path-case-v1, and ID.cert.json."""
    return _made(DegeneratePath.of(family, seed, index), index)


def made_invalid(family: InvalidFamily, seed: int, index: int) -> Made:
    """ID.EXT, which must be refused; ID.refusal.json: what a message should say."""
    drawn = invalid_member(family, seed, index)
    ending = Path(drawn.file_name).suffix
    told = json.dumps([ending, drawn.part, drawn.scale]).encode() + drawn.content
    stem = f"{family.name}-{hashlib.sha256(told).hexdigest()[:12]}"
    name = f"{stem}{ending}"
    renamed = {drawn.file_name: name, drawn.argument: f"{name}{drawn.part}"}
    refusal = {
        "file": name,
        "operand": renamed[drawn.argument],
        "scale": drawn.scale,
        "code": drawn.code,
        "place": [renamed.get(text, text) for text in drawn.place],
        "source": f"minkref generate {family.name} --seed {seed} --index {index}",
    }
    beside = f"{stem}.refusal.json", (json.dumps(refusal) + "\n").encode()
    return Made(family.name, index, stem, (name, drawn.content), beside, certified=False)


def write_member(
    family: AnyFamily, seed: int, index: int, folder: Path, size: int | None = None
) -> FileRow:
    """FOLDER/FAMILY/ID.json, and FOLDER/FAMILY/ID.cert.json where it has a certificate."""
    return made_member(family, seed, index, size).write(folder)


def write_found(story: Story, folder: Path) -> FileRow:
    return _made(Degenerate(story, story.value["source"], story.facts), 0).write(folder)


def _made(made: AnyDegenerate | DegenerateWithDisc | DegeneratePath, index: int) -> Made:
    case = f"{made.id}.json", made.case_text.encode()
    text = made.certificate_text
    certificate = None if text is None else (f"{made.id}.cert.json", text.encode())
    return Made(made.subject.name, index, made.id, case, certificate)
