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
    CONSISTENT = "consistent"
    NOT_REPRODUCED = "not reproduced"
    NOT_ATTEMPTED = "not attempted"


RULE = (
    "An entry quotes sentences of the paper that can be measured or counted, says how each was "
    "tested, and gives the numbers of one run with their spread; times of the paper's machine are "
    "not compared. Reproduced: all of it comes out, and nothing was unlike the paper. Reproduced "
    "in kind: all of it comes out, with the differences from the paper that the entry lists. "
    "Consistent: it comes out for some values of something that the paper does not give. Not "
    "reproduced: some of it does not come out. Not attempted: nothing of it was measured."
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
    """A tested sentence. `words`: the paper's own, nothing else; `place`: section, figure or table.
    `tested`: test and threshold, in our words. `found`: numbers. `chosen`: the sentence comes out
    only for a chosen value of something that the paper does not give."""

    words: str
    place: str
    tested: str
    found: str
    holds: bool
    chosen: bool = False


def verdict_of(claims: Sequence[Claim], unlike: Sequence[str]) -> Verdict:
    """By RULE."""
    if not claims:
        return Verdict.NOT_ATTEMPTED
    if not all(claim.holds for claim in claims):
        return Verdict.NOT_REPRODUCED
    if any(claim.chosen for claim in claims):
        return Verdict.CONSISTENT
    return Verdict.IN_KIND if unlike else Verdict.REPRODUCED


@dataclass
class Entry:
    """`place`: the paper's name for the entry. `why`: the runs, with caveats. `command`: the
    command that makes the entry. `unlike`: differences from the paper."""

    place: str
    title: str
    why: str
    command: str
    claims: Sequence[Claim] = ()
    unlike: Sequence[str] = ()
    pictures: list[Picture] = field(default_factory=list)
    tables: list[Table] = field(default_factory=list)

    @property
    def verdict(self) -> Verdict:
        return verdict_of(self.claims, self.unlike)
