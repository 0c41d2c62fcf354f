"""Targets that a floor above the run offers to it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from minkref.fuzz.plane.case import Case
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Outcome

Made = TypeVar("Made", covariant=True)


class Judge(Protocol):
    """Rules on the reference, one case after another."""

    def rule(self, case: Case) -> Outcome: ...

    def close(self) -> None: ...


def no_title(name: str) -> str | None:
    """All targets are listed."""
    return None


def always(name: str) -> bool:
    return True


@dataclass(frozen=True)
class Offer(Generic[Made]):
    """`about`: each target by its name, with a sentence on it. `absence` says why a target cannot
    begin here, None if it can. `title` has the sentence on targets that are not listed, as their
    names have parameters; None for other names, and a refusal of wrong parameters. `in_all`:
    whether the group of all targets has a listed target. The functions stand in modules: a worker's
    start pickles them."""

    about: Mapping[str, str]
    absence: Callable[[str], str | None]
    make: Callable[[str, Limits], Made]
    title: Callable[[str], str | None] = no_title
    in_all: Callable[[str], bool] = always

    def has(self, name: str) -> bool:
        """Whether it offers the name. Refuses wrong parameters."""
        return name in self.about or self.title(name) is not None
