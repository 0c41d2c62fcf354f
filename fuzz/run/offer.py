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


@dataclass(frozen=True)
class Offer(Generic[Made]):
    """`about`: each target by its name, with a sentence on it. `absence` says why a target cannot
    begin here, None if it can. Both functions stand in modules: a worker's start pickles them."""

    about: Mapping[str, str]
    absence: Callable[[str], str | None]
    make: Callable[[str, Limits], Made]
