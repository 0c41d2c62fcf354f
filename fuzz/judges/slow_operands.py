"""The operands of a case as the slow engine takes them."""

from __future__ import annotations

import json

from minkref.fuzz.cases.case import Case
from minkref.oracle import slow


def slow_operands(case: Case) -> tuple[slow.Operand, slow.Operand]:
    """P, not scaled, and Q."""
    return slow_operand(case.P_json), slow_operand(case.Q_json)


def slow_operand(text: str) -> slow.Operand:
    return slow.operand_from_json(json.loads(text))
