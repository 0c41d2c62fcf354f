"""One entry for each table, figure and stated time of the paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any


class Verdict(StrEnum):
    REPRODUCED = "reproduced"
    NOT_REPRODUCED = "not reproduced"
    NOT_ATTEMPTED = "not attempted"


@dataclass(frozen=True)
class Picture:
    caption: str
    svg: str


@dataclass(frozen=True)
class Table:
    """`rows` also go to NAME.csv and NAME.json."""

    name: str
    columns: Sequence[str]
    rows: Sequence[Sequence[Any]]


@dataclass
class Entry:
    """`place`: what the paper calls it. `verdict` and `why`: how far ours is the same. `command`:
    what makes it."""

    place: str
    title: str
    verdict: Verdict
    why: str
    command: str
    pictures: list[Picture] = field(default_factory=list)
    tables: list[Table] = field(default_factory=list)
