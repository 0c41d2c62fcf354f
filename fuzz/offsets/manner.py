"""How a set or line grows at corners and ends of lines: joins and caps."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref.errors import Refusal, choice
from minkref.fuzz.geometry.number_text import number_of

ROUND, MITRE, BEVEL, SQUARE, FLAT = "round", "mitre", "bevel", "square", "flat"
SHARP = "sharp"  # a mitre without limit
JOINS, CAPS = (ROUND, MITRE, BEVEL, SQUARE, SHARP), (ROUND, FLAT, SQUARE)
MANNERS = tuple(
    f"{kind}-{word}" for kind, words in (("join", JOINS), ("cap", CAPS)) for word in words[1:]
)  # capabilities


@dataclass(frozen=True)
class Manner:
    """`limit`: of a mitre, the most distance of its tip from the corner, in radii."""

    join: str = ROUND
    cap: str = ROUND
    limit: Fraction | None = None

    @property
    def is_round(self) -> bool:
        return self.join == self.cap == ROUND

    @property
    def needs(self) -> frozenset[str]:
        """The capabilities that it asks for."""
        words = (("join", self.join), ("cap", self.cap))
        return frozenset(f"{kind}-{word}" for kind, word in words if word != ROUND)

    def members(self, number: Callable[[Fraction], Any] = str) -> dict[str, Any]:
        """The members of a case or a request that say it; none if all is round."""
        value: dict[str, Any] = {} if self.join == ROUND else {"join": self.join}
        if self.limit is not None:
            value["limit"] = number(self.limit)
        return value if self.cap == ROUND else {**value, "cap": self.cap}

    def __str__(self) -> str:
        limit = "" if self.limit is None else f" up to {self.limit} radii"
        joins = "" if self.join == ROUND else f"{self.join} joins{limit}"
        return " and ".join(filter(None, (joins, "" if self.cap == ROUND else f"{self.cap} caps")))


def read_manner(value: dict[str, Any], is_line: bool, where: str) -> Manner:
    """Reads joins and caps of a case. Refuses others, and caps of what has no ends."""
    join, cap, limit = value.get("join", ROUND), value.get("cap", ROUND), value.get("limit")
    for name, word, words in (("join", join, JOINS), ("cap", cap, CAPS)):
        if word not in words:
            raise Refusal(f"there is no such {name}", where, choice(str(word), words))
    if cap != ROUND and not is_line:
        raise Refusal("a set without lines has no caps", where, 'leave out "cap"')
    if join == SHARP and is_line:
        raise Refusal("lines have no sharp joins", where, 'write "join":"mitre","limit":"2"')
    if (limit is None) == (join == MITRE):
        mend = 'write "join":"mitre","limit":"2"'
        raise Refusal("a mitre has a limit, and no other join has one", where, mend)
    try:
        most = None if limit is None else number_of(str(limit))
    except ValueError as error:
        raise Refusal(f"the limit is no number: {error}", where, 'write "limit":"2"') from error
    if most is not None and most < 1:
        raise Refusal("the limit is less than 1", where, 'write "limit":"2"')
    return Manner(join, cap, most)
