"""Entries for each table, figure and stated time of the paper, and the rule for calling an entry
reproduced."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any


class Verdict(StrEnum):
    REPRODUCED = "reproduced"
    IN_KIND = "reproduced in kind"
    NOT_REPRODUCED = "not reproduced"
    NOT_ATTEMPTED = "not attempted"


RULE = (
    "An entry lists what the paper states there that can be measured or counted and is no time of "
    "its machine; speed-ups are compared by what is said of them, and by their order of magnitude. "
    "Reproduced: all of it comes out, with the paper's own input. Reproduced in kind: "
    "all of it comes out, with input of ours, because the paper's is not published or not at hand. "
    "Not reproduced: some of it does not come out. Not attempted: nothing of it was measured."
)


@dataclass(frozen=True)
class Picture:
    """A picture; plots keep their width if the page has room."""

    caption: str
    svg: str
    is_plot: bool = False


@dataclass(frozen=True)
class Table:
    """`rows` also go to NAME.csv and NAME.json."""

    name: str
    columns: Sequence[str]
    rows: Sequence[Sequence[Any]]


@dataclass(frozen=True)
class Claim:
    """A statement of the paper, quoted or paraphrased, the finding, and whether the statement
    holds."""

    stated: str
    found: str
    holds: bool


def verdict_of(claims: Sequence[Claim], their_input: bool) -> Verdict:
    """By RULE."""
    if not claims:
        return Verdict.NOT_ATTEMPTED
    if not all(claim.holds for claim in claims):
        return Verdict.NOT_REPRODUCED
    return Verdict.REPRODUCED if their_input else Verdict.IN_KIND


@dataclass
class Entry:
    """`place`: the paper's name for the entry. `why`: the runs, with caveats. `command`: the
    command that makes the entry. `their_input`: whether all input is the paper's own."""

    place: str
    title: str
    why: str
    command: str
    claims: Sequence[Claim] = ()
    their_input: bool = False
    pictures: list[Picture] = field(default_factory=list)
    tables: list[Table] = field(default_factory=list)

    @property
    def verdict(self) -> Verdict:
        return verdict_of(self.claims, self.their_input)
