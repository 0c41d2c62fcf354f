"""Claims in path and trap certificates, compared with fresh results from the reference, which
shares nothing with the checkers."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from math import inf
from typing import Any

import minkref
from minkref.motion.scale_ranges import ScaleRange

Cut = tuple[Any, bool]
Span = tuple[Cut, Cut]


class PathConfirmation:
    """Confirms the claims about one case. Raises BadInput if the case has invalid sets."""

    def __init__(self, case: str) -> None:
        value = json.loads(case)
        part, obstacles = (minkref.read_text(json.dumps(value[name]), "json") for name in "RO")
        for name, one in (("R", part), ("O", obstacles)):
            one.validate(name)
        path = [(str(Fraction(x)), str(Fraction(y))) for x, y in value["path"]]

        @cache
        def valid(contact: str) -> list[Span]:
            found = minkref.valid_scales(part, obstacles, path, contact)
            return [_span(one) for one in found.ranges]

        @cache
        def trapped(contact: str) -> list[Span]:
            found = minkref.trapped_scales(part, obstacles, path[0], contact)
            return [_span(one) for one in found.ranges]

        self._valid, self._trapped = valid, trapped

    def all_hold(self, claims: Sequence[dict[str, Any]]) -> bool:
        return all(self.holds(claim) for claim in claims)

    def holds(self, claim: dict[str, Any]) -> bool:
        """Decides exactly, at all scales of the claim."""
        contact, scales = claim["contact"], _told(claim["scales"])
        kind = claim["claim"]
        if kind in ("free", "hit", "valid"):
            true = self._valid(contact)
        else:
            true = self._trapped(contact)
        here = _common(true, scales)
        if kind in ("valid", "trap"):
            listed = claim["valid" if kind == "valid" else "trapped"]
            return [_told(one) for one in listed] == here
        if kind in ("free", "trapped"):
            return here == [scales]
        if kind == "escapes":
            return here == [] and _common(self._valid(contact), scales) == [scales]
        return here == []


def _told(value: dict[str, Any]) -> Span:
    low = Fraction(value["from"])
    high = inf if value["to"] is None else Fraction(value["to"])
    return (low, not value["from_in"]), (high, value["to_in"])


def _span(one: ScaleRange) -> Span:
    high: Any = inf if one.high is None else one.high
    return (one.low, not one.low_in), (high, one.high_in)


def _common(ranges: Sequence[Span], scales: Span) -> list[Span]:
    both = [(max(low, scales[0]), min(high, scales[1])) for low, high in ranges]
    return [(low, high) for low, high in both if low < high]
