"""A hostile file: its making, the command that reads it, and the possible endings."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

FILE = "{}"  # where its name stands in a command
PLANE = ("sum", FILE, "g3", "-o", "out.json")
SPACE = ("sum", FILE, "gs3", "-o", "out.json")
SQUARE = "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))"
REFUSED = (2,)
# minkref's state folder with the ledger key, shared by all these commands.
_STATE = tempfile.TemporaryDirectory(prefix="minkref-evidence-state-")
STATE = {"XDG_STATE_HOME": _STATE.name}
JUDGED = (0, 2)  # a reader may take it: what counts is that it ends, in time and in memory


@dataclass(frozen=True)
class Large:
    """A text made only when needed."""

    make: Callable[[], bytes | str]


Content = bytes | str | Large | Callable[[Path], None]


@dataclass(frozen=True)
class Hostile:
    """`content`: the file's bytes, or a function that makes the file. `during`: a change to make
    while a command reads the file."""

    title: str
    name: str
    content: Content
    command: tuple[str, ...] = PLANE
    codes: tuple[int, ...] = REFUSED
    during: Callable[[Path], None] | None = None
    environment: dict[str, str] = field(default_factory=dict)  # values may hold {}
    seconds: float = 30  # of a processor

    def make(self, folder: Path) -> Path:
        path = folder / self.name
        if callable(self.content):
            self.content(path)
        else:
            text = self.content.make() if isinstance(self.content, Large) else self.content
            path.write_bytes(text.encode() if isinstance(text, str) else text)
        return path

    def words(self, path: Path) -> list[str]:
        return [word.replace(FILE, str(path)) for word in self.command]


def odd(base: int, power: int, k: int) -> str:
    """base^power + 2 k + 1, longer than Python likes to write numbers."""
    sys.set_int_max_str_digits(0)
    return str(base**power + 2 * k + 1)


def sparse(size: int, start: bytes = b"") -> Callable[[Path], None]:
    """A file of so many bytes that takes no room: zeros behind a start."""

    def make(path: Path) -> None:
        with path.open("wb") as stream:
            stream.write(start)
            stream.truncate(size)

    return make


def case(P: str, Q: str = "", more: str = "") -> str:
    """The text of a case with these rings as operands."""
    Q = Q or '[["0","0"],["1","0"],["0","1"]]'
    return (
        '{"schema":"case-v1","id":"hostile","title":"hostile","dimension":2,"scales":["1"],'
        f'"P":{{"polygons":[{{"outer":{P}}}]}},"Q":{{"polygons":[{{"outer":{Q}}}]}}{more}}}'
    )
