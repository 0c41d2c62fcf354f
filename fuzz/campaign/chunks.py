"""A campaign in chunks: each a few rounds of one family, which depend on the campaign's seed and
the chunk's number alone."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from minkref.errors import Refusal
from minkref.fuzz.run.case_list import CaseList, Wait

#: Fields of CaseList with families, by the setting to which they belong.
SETTING_OF = {
    "families": "plane",
    "space": "space",
    "unions": "scene",
    "offsets": "disc",
    "features": "disc",
    "paths": "motion",
}
INVALID = "invalid"  # a flag of CaseList, and a family in the plane
_EMPTY: dict[str, Any] = {**dict.fromkeys(SETTING_OF, ()), INVALID: False}


@dataclass(frozen=True)
class Chunk:
    """Chunk `number` of a campaign: the part `index` of a family."""

    number: int
    family: str
    index: int
    cases: CaseList

    @property
    def name(self) -> str:
        return f"{self.family}-{self.index:08d}"


@dataclass(frozen=True)
class Plan:
    """All chunks of a campaign, without end: families take turns. `whole`: the cases that
    `minkref verify` would take. `size`: about how many cases a chunk has."""

    whole: CaseList
    size: int

    @cached_property
    def families(self) -> tuple[tuple[str, str], ...]:
        """Lists families with their field of CaseList; settings take turns."""
        groups = [[(field, name) for name in getattr(self.whole, field)] for field in SETTING_OF]
        groups.append([(INVALID, INVALID)] if self.whole.invalid else [])
        turns = itertools.zip_longest(*groups)
        return tuple(each for turn in turns for each in turn if each is not None)

    @cached_property
    def _rounds(self) -> tuple[tuple[int, int], ...]:
        """Returns rounds and planned cases per chunk, for each family."""
        counts = [self._count(field, family) for field, family in self.families]
        rounds = [max(1, self.size // count) for count in counts]
        return tuple((r, r * count) for r, count in zip(rounds, counts, strict=True))

    def chunk(self, number: int) -> Chunk:
        index, k = divmod(number, len(self.families))
        field, family = self.families[k]
        rounds, _ = self._rounds[k]
        return Chunk(number, family, index, self._list(field, family, index * rounds, rounds))

    def planned(self, number: int) -> int:
        """Counts a chunk's cases before any run: without mutants, with cases that do not exist."""
        return self._rounds[number % len(self.families)][1]

    def numbers(self, cases: int | None) -> Iterator[int]:
        """Yields the numbers of the first chunks that together have `cases` planned cases; without
        end for None."""
        left = math.inf if cases is None else cases
        for number in itertools.count():
            if left <= 0:
                return
            yield number
            left -= self.planned(number)

    def _list(self, field: str, family: str, begin: int, rounds: int) -> CaseList:
        own: dict[str, Any] = {field: True if field == INVALID else (family,)}
        return replace(
            self.whole, **{**_EMPTY, **own}, begin=begin, rounds=rounds, pairs=None,
            seconds=math.inf, models=False, notes=[],
        )  # fmt: skip

    def _count(self, field: str, family: str) -> int:
        names = self._list(field, family, 0, 1)
        return max(1, sum(not isinstance(name, Wait) for name in names))


def only_settings(whole: CaseList, settings: Collection[str]) -> CaseList:
    """Keeps families from `settings`, or all without `settings`. Refuses an empty choice."""
    if settings:
        others = [field for field, name in SETTING_OF.items() if name not in settings]
        empty: dict[str, Any] = dict.fromkeys(others, ())
        whole = replace(whole, **empty)
        whole.invalid = whole.invalid and "plane" in settings
    if not Plan(whole, 1).families:
        mend = "choose other settings, families or targets: `minkref targets` tells of each"
        raise Refusal("no target takes such cases", "settings and families", mend)
    return whole
