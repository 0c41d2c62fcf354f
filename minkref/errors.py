"""Refusals on the command line: the fault, the place, and the remedy."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterable
from typing import TypeVar

from minkref import _core
from minkref.output.terminal import escaped

T = TypeVar("T")

LONGEST_MESSAGE = 2000  # characters kept of other people's messages


class Refusal(_core.BadInput):
    """A wrong use or a bad input. `where` names the file, option or model; `mend` says what to do.
    Has all attributes of BadInput: `source` holds the place."""

    def __init__(self, what: str, where: str, mend: str, code: str = "usage") -> None:
        super().__init__(f"{where}: {what}")
        self.what = self.problem = what
        self.where = self.source = where
        self.mend = mend
        self.code = code
        self.line = self.ring = self.face = None
        self.other_ring = self.other_face = None
        self.vertices, self.coordinates, self.other_vertices = [], [], []

    def __reduce__(self) -> tuple[type[Refusal], tuple[str, str, str, str]]:
        """Pickle all parts, so that a refusal leaves a worker process whole."""
        return type(self), (self.what, self.where, self.mend, self.code)

    def document(self) -> dict[str, object]:
        return {"code": self.code, "what": self.what, "where": self.where, "mend": self.mend}


def nearest(word: str, known: Iterable[str]) -> str:
    """Write `did you mean X? ` if another known word is near, in any letter case; else nothing."""
    by_small = {each.lower(): each for each in known if each != word}
    near = difflib.get_close_matches(word.lower(), list(by_small), n=1)
    return f"did you mean {by_small[near[0]]}? " if near else ""


def choice(word: str, known: Iterable[str]) -> str:
    """Say which words to choose from instead of an unknown word."""
    words = list(known)
    return f"{nearest(word, words)}choose one of {', '.join(words)}"


def refusal_text(error: dict[str, object]) -> str:
    """Write a refusal for people, from its document `error`."""
    text = f"minkref: {escaped(str(error['where']))}: {escaped(str(error['what']))}\n"
    return text + (f"  fix: {escaped(str(error['mend']))}\n" if error["mend"] else "")


def message_of(error: BaseException) -> str:
    """Write `Type: text` for an exception from other people's code, whatever that code does."""
    name = type(error).__name__
    try:
        return cut(f"{name}: {error}")
    except BaseException:  # noqa: BLE001 its own __str__ raises
        return f"{name} (its text cannot be read)"


def cut(text: str) -> str:
    """Cut a text to at most LONGEST_MESSAGE characters."""
    return text if len(text) <= LONGEST_MESSAGE else text[: LONGEST_MESSAGE - 3] + "..."


def refusal_of(error: _core.BadInput, source: str = "") -> Refusal:
    """Convert an error from a reader or from the validation to a Refusal with ring or face,
    vertices and coordinates."""
    if isinstance(error, Refusal):
        return error
    where = [str(getattr(error, "source", "") or source)]
    line = getattr(error, "line", None)
    ring = getattr(error, "ring", None)
    vertices = list(getattr(error, "vertices", None) or [])
    coordinates = list(getattr(error, "coordinates", None) or [])
    if line is not None:
        where.append(f"line {line}")
    if ring is not None:
        where.append(f"ring {ring}")
    face = getattr(error, "face", None)
    if face is not None:
        where.append(f"face {face}")
    if vertices:
        word = "vertex" if len(vertices) == 1 else "vertices"
        where.append(f"{word} {', '.join(str(v) for v in vertices)}")
    other = getattr(error, "other_ring", None)
    if other is not None:
        others = [str(v) for v in getattr(error, "other_vertices", None) or []]
        where.append(f"and ring {other}" + (f", vertices {', '.join(others)}" if others else ""))
    other_face = getattr(error, "other_face", None)
    if other_face is not None:
        where.append(f"and face {other_face}")
    if coordinates:
        where.append("at " + ", ".join(str(c) for c in coordinates))
    return Refusal(
        str(getattr(error, "problem", "") or error),
        ", ".join(part for part in where if part),
        str(getattr(error, "mend", "")),
        str(getattr(error, "code", "bad-input")),
    )


def refusing(source: str, call: Callable[[], T]) -> T:
    """Return the value of `call`; turns the reference's BadInput into a Refusal about `source`."""
    try:
        return call()
    except Refusal:
        raise
    except _core.BadInput as error:
        raise refusal_of(error, source) from error
