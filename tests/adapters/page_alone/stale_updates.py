"""A fault of updates, for the plane and for space."""

from __future__ import annotations

from conversation import Adapter, Answer, Request


class StaysAtLastSum(Adapter):
    """`update` answers the sum that the last `at` found."""

    def at(self, request: Request) -> Answer:
        self.last = super().at(request)
        return self.last

    def update(self, request: Request) -> Answer:
        return self.last
