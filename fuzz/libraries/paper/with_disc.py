"""The program of the paper's Appendix, as an adapter asks it: a set grown by a disc."""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from minkref import _core

ELSEWHERE = (Fraction(1), Fraction(2))  # walks begin at the first other radius


def grown(P: str, radius: str, arithmetic: str, readings: Mapping[str, str]) -> dict[str, Any]:
    """The components of P grown by a disc, walked to from another radius; the disc has the radius 1
    at the scale 1."""
    wanted = Fraction(radius)
    start = next(each for each in ELSEWHERE if each != wanted)
    region = _core.PolygonSet.from_json(P)
    walk = _core.DiscUpdate(region, str(start**2), "1", arithmetic, readings)
    walk.move_to(str(wanted**2))
    return {"components": json.loads(walk.answer().canonical)["components"]}


def corrected() -> dict[str, str]:
    """All sentences of the Appendix, corrected."""
    return {name: right for name, _, right, _ in _core.appendix_readings()}
