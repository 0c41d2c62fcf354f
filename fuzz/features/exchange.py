"""Answers about features: bars, and at a radius bridges, components and holes."""

from __future__ import annotations

from typing import Any

from minkref.fuzz.features.claims import features_text
from minkref.fuzz.plane.protocol import PlaneExchange
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration


class FeaturesExchange(PlaneExchange):
    answer_is_no = "not a list of bars"

    def received(self, value: dict[str, Any], declaration: Declaration, seconds: float) -> Answer:
        text = features_text(value, declaration)
        return Answer(features=text, seconds=seconds, declaration=declaration)

    def received_of_function(
        self, value: dict[str, Any], declaration: Declaration, seconds: float
    ) -> Answer:
        return self.received(value, declaration, seconds)


IN_BARS = FeaturesExchange()
