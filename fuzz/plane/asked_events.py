"""Asks a target for the scales of events."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

from minkref.fuzz.plane.case import Case
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import Unreadable, received_scale


def asked_events(
    target: AdapterTarget, case: Case, verb: str, start: str, end: str
) -> tuple[list[Fraction], Declaration] | Answer:
    """Returns the scales in [start, end] that the target lists for the verb, and its declaration;
    else the answer without them."""
    window = {"from": start, "to": end}
    return target.asked(case, verb, lambda _: window, _scales, verb)


def _scales(value: dict[str, Any], declaration: Declaration) -> list[Fraction]:
    scales = value.get("scales")
    if not isinstance(scales, list):
        raise Unreadable("scales is not a list")
    found = [received_scale(scale, declaration) for scale in scales]
    if any(a > b for a, b in pairwise(found)):
        raise Unreadable("scales do not ascend")
    return found
