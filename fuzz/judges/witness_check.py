"""A witness of `minkref verify` before the slow engine."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref.oracle import slow


def confirmed(finding: dict[str, Any]) -> bool:
    """Whether the slow engine agrees with a finding about its witness point (from the document of
    `verify`, small enough to hold its operands)."""
    witness = finding["witness"]
    if witness is None:
        return False
    P, Q = (slow.operand_from_json(finding[name]["set"]) for name in ("P", "Q"))
    x = (Fraction(witness["point"][0]), Fraction(witness["point"][1]))
    inside: bool = slow.witness(P, Q, Fraction(finding["scale"]), x).in_sum
    return inside == bool(witness["in_truth"])
