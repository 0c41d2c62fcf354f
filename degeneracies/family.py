"""Families of degenerate cases, and their members, by drawing until a candidate belongs."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any, ClassVar, Generic, TypeVar

from minkref import _core
from minkref.errors import Refusal

PAGES = Path(__file__).parent / "pages"
PATIENCE = 400
FEWEST, MOST = 8, 24  # vertices of a pair, about
D = TypeVar("D")  # a draft
F = TypeVar("F")  # facts about it


class NothingDrawn(Exception):
    """A generator has no candidate; another draw may have one."""


@dataclass(frozen=True)
class Subject:
    """The subject of a case. `why`: the reason that good code gets it wrong."""

    name: str
    title: str

    @property
    def why(self) -> str:
        """pages/NAME.md without its heading, a paragraph a line."""
        _, _, text = (PAGES / f"{self.name}.md").read_text(encoding="utf-8").partition("\n")
        return "\n\n".join(" ".join(part.split()) for part in text.strip().split("\n\n"))


@dataclass(frozen=True)
class Family(Subject, ABC, Generic[D, F]):
    """`draw` draws a candidate, with about `size` vertices where families have sizes. `belongs`
    decides from the facts whether the candidate belongs to the family: some settings give a list
    that shows membership, empty for other candidates."""

    draw: Callable[..., D]
    belongs: Callable[[F], Any]
    has_sizes: ClassVar[bool] = True

    @abstractmethod
    def look(self, draft: D) -> F:
        """The facts about a draft. Raises _core.BadInput if an operand is invalid, NothingDrawn for
        no candidate."""

    def tried(self, dice: Random, *size: int) -> tuple[F, Any] | None:
        """Draws once: the facts, and the result of `belongs`; None if nothing belongs."""
        try:
            facts = self.look(self.draw(dice, *size))
        except (NothingDrawn, _core.BadInput):
            return None
        shown = self.belongs(facts)
        return (facts, shown) if shown else None

    def member(self, seed: int, index: int, size: int | None = None) -> tuple[F, Any]:
        """Draws member number `index`, with about `size` vertices if the family can be large. The
        arguments alone decide the result, on any machine. Refuses a size that no draw reaches."""
        dice = Random(f"minkref degeneracy {self.name} {seed} {index}")
        for _ in range(PATIENCE):
            wanted = [size or dice.randint(FEWEST, MOST)] if self.has_sizes else []
            found = self.tried(dice, *wanted)
            if found is not None:
                return found
        if size is None:  # the fault is ours
            raise RuntimeError(f"{self.name}:{seed}:{index}: nothing drawn belongs to the family")
        raise Refusal(
            f"no member of about {size} vertices was found in {PATIENCE} draws",
            f"{self.name} --seed {seed} --index {index} --size {size}",
            "choose another --size or --seed, or leave out --size",
            "nothing-drawn",
        )
