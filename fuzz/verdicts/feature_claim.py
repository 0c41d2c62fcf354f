"""A witness about concave features: what a set has of them, and an answer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class FeatureClaim:
    """`kind`: bar; bridge, at the case's radius; shape, of which `what` counts components or holes;
    set, refused. `in_set` and `in_answer`: how many there are. `nearest`: the set's bar most like
    an invented one. `begins_at`, `ends_at`: places of a bar's birth and death, near them."""

    kind: str
    what: str
    in_set: int
    in_answer: int
    nearest: str | None = None
    begins_at: tuple[str, ...] | None = None
    ends_at: tuple[str, ...] | None = None

    def document(self) -> dict[str, Any]:
        def listed(place: tuple[str, ...] | None) -> list[str] | None:
            return None if place is None else list(place)

        ends = {"begins_at": listed(self.begins_at), "ends_at": listed(self.ends_at)}
        return {**vars(self), **ends}
