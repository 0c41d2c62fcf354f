"""Faulty adapters in the plane: `update` and `events`."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from conversation import Answer, Request
from minkref import _core
from plane_adapter import Events, Updating
from plane_sets import set_of
from stale_updates import StaysAtLastSum


class UpdateDrifts(Updating):
    """Each `update` moves the sum a billionth to the right, and the next one on from there."""

    off = Fraction(0)

    def at(self, request: Request) -> Answer:
        self.off = Fraction(0)
        return super().at(request)

    def update(self, request: Request) -> Answer:
        self.off += Fraction(1, 10**9)
        return super().update(request)

    def number(self, value: Fraction) -> Any:
        return str(value + self.off)


class SecondUpdateStays(Updating):
    """The second `update` after an `at` answers the sum of the first."""

    def at(self, request: Request) -> Answer:
        self.count = 0
        return super().at(request)

    def update(self, request: Request) -> Answer:
        self.count += 1
        if self.count > 1:
            return self.last
        self.last = super().update(request)
        return self.last


class UpdateIgnoresScale(StaysAtLastSum, Updating):
    pass


class UpdateKeepsHoles(Updating):
    """`update` to a smaller scale forgets newly born holes."""

    def update(self, request: Request) -> Answer:
        before = self.scale
        found = super().update(request)
        if self.scale < before:
            for polygon in found["polygons"]:
                polygon["holes"] = []
        return found


class EventsWithoutTouch(Events):
    """Leaves out scales at which something only touches itself."""

    def found(self, request: Request) -> list[Any]:
        return [event for event in super().found(request) if event[2] != "touch"]


class EventsWithoutDeaths(Events):
    """Leaves out scales at which something dies."""

    def found(self, request: Request) -> list[Any]:
        return [event for event in super().found(request) if event[2] != "death"]


class EventsWithoutSplits(Events):
    """Leaves out scales at which something splits."""

    def found(self, request: Request) -> list[Any]:
        return [event for event in super().found(request) if event[2] != "split"]


class EventsOfHolesOnly(Events):
    """Leaves out what happens to components."""

    def found(self, request: Request) -> list[Any]:
        return [event for event in super().found(request) if event[1] == "hole"]


class EventsOneMore(Events):
    """Lists one more scale, halfway between the first two."""

    def scales(self, request: Request) -> list[Fraction]:
        found = super().scales(request)
        return sorted([*found, (found[0] + found[1]) / 2]) if len(found) > 1 else found


class EventsShifted(Events):
    """Moves the last scale by 1e-6."""

    def scales(self, request: Request) -> list[Fraction]:
        found = super().scales(request)
        return [*found[:-1], found[-1] + Fraction(1, 10**6)] if found else found


class EventsOfPairs(Events):
    """Knows scales of edge pairs only: omits events of three edges."""

    def scales(self, request: Request) -> list[Fraction]:
        found = super().scales(request)
        if not found:
            return found
        P, Q = set_of(self.P), set_of(self.Q)
        all_pairs = _core.pair_events(P, Q, str(found[0]), str(found[-1]))
        pairs = {Fraction(row[0]) for row in all_pairs.rows(0, len(all_pairs))}
        return [scale for scale in found if scale in pairs]


class EventsDescending(Events):
    """Lists the scales in descending order."""

    def scales(self, request: Request) -> list[Fraction]:
        return super().scales(request)[::-1]


class EventsEmpty(Events):
    """Lists no scale at all."""

    def scales(self, request: Request) -> list[Fraction]:
        return []
