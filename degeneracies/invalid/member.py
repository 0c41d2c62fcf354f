"""Families of invalid input, and their members."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from minkref.degeneracies.family import PAGES

PREFIX = "invalid-"


@dataclass(frozen=True)
class Invalid:
    """A file refused with `code`, or a valid file beside a refused scale. A good message holds each
    text of `place`, and always the file's name, or `--scale`.

    `operand`: the refused argument. In a case file, the damaged operand, or the requested operand
    if the whole case is refused. `part`: the end that the file's name needs, `#P` or `#Q`. `scale`:
    the refused argument of --scale. `slow_reads`: whether the slow engine reads the format, or has
    the limit."""

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
        """The file's name as a command's argument."""
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
    """A module's families, in the order in which the module defines their drawing functions. A
    family takes its function's name, after the prefix."""

    def __init__(self, prefix: str = PREFIX) -> None:
        super().__init__()
        self._prefix = prefix

    def add(self, title: str, code: str = "") -> Callable[[Draw], Draw]:
        """Decorates a drawing function. `code`: the refusal's code, if different from the name."""

        def added(draw: Draw) -> Draw:
            name = draw.__name__.replace("_", "-")
            self.append(InvalidFamily(self._prefix + name, title, code or name, draw))
            return draw

        return added
