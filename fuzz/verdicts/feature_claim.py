"""Witnesses about concave features: true count beside told count."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class FeatureClaim:
    """`kind`: bar; bridge, at the case's radius; shape, where `what` counts components or holes;
    set, refused. `in_set`, `in_answer`: true and told count. `nearest`: a true bar, most like an
    invented bar. `begins_at`, `ends_at`: near places where bars begin and end."""

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
