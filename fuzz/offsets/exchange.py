"""Answers about a set grown by a disc: polygons, or curves."""

from __future__ import annotations

import json
from typing import Any

from minkref.fuzz.offsets.curves import read_curves
from minkref.fuzz.plane.protocol import PlaneExchange
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import Unreadable, double


class OffsetExchange(PlaneExchange):
    """Reads `components`, rings of circles and lines, beside sets of polygons. Sends lines too."""

    def sent(self, text: str, declaration: Declaration) -> Any:
        value = json.loads(text)
        if "lines" not in value or declaration.numbers == "text":
            return super().sent(text, declaration)
        return {"lines": [[[double(x) for x in p] for p in line] for line in value["lines"]]}

    def received(self, value: dict[str, Any], declaration: Declaration, seconds: float) -> Answer:
        if "components" not in value:
            return super().received(value, declaration, seconds)
        if "polygons" in value or "rings" in value:
            raise Unreadable("it has both components and polygons or rings")
        curves = read_curves(value["components"], declaration)
        return Answer(curves=curves, seconds=seconds, declaration=declaration)

    def received_of_function(
        self, value: dict[str, Any], declaration: Declaration, seconds: float
    ) -> Answer:
        if "components" in value:
            return self.received(value, declaration, seconds)
        return super().received_of_function(value, declaration, seconds)


IN_CURVES = OffsetExchange()
