"""Families of invalid input, and the members that they draw."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from minkref.degeneracies.plane.draft import PAGES

PREFIX = "invalid-"


@dataclass(frozen=True)
class Invalid:
    """A file that is refused with `code`, or a valid one beside a scale that is. A good message
    holds each text of `place`, and always the name of the file, or `--scale`.

    `operand`: which argument is refused. In a case file it is the operand that is damaged, or that
    is asked for where the case as a whole is. `part`: what a name of the file needs at its end,
    `#P` or `#Q`. `scale`: the refused argument of --scale. `slow_reads`: whether the slow engine
    reads the format, or has the limit."""

    family: str
    code: str
    file_name: str
    content: bytes
    place: tuple[str, ...]
    operand: str
    scale: str | None = None
    part: str = ""
    slow_reads: bool = True

    @property
    def argument(self) -> str:
        """The file as a command is given it."""
        return self.file_name + self.part


Draw = Callable[[Random], Invalid]


@dataclass(frozen=True)
class InvalidFamily:
    """Why code that reads input gets it wrong: degeneracies/pages/NAME.md."""

    name: str
    title: str
    code: str
    draw: Draw

    @property
    def why(self) -> str:
        """The page without its heading."""
        _, _, text = (PAGES / f"{self.name}.md").read_text(encoding="utf-8").partition("\n")
        return text.strip()


class Families(list[InvalidFamily]):
    """Those of a module, in the order in which it defines the functions that draw them. A family is
    called as its function is, after the prefix."""

    def __init__(self, prefix: str = PREFIX) -> None:
        super().__init__()
        self._prefix = prefix

    def add(self, title: str, code: str = "") -> Callable[[Draw], Draw]:
        """For the head of a function. `code`: that of the refusal, where it is not the name."""

        def added(draw: Draw) -> Draw:
            name = draw.__name__.replace("_", "-")
            self.append(InvalidFamily(self._prefix + name, title, code or name, draw))
            return draw

        return added
