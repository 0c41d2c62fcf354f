"""A case's operands in the slow engine's form."""

from __future__ import annotations

import json
from pathlib import Path

from minkref.fuzz.plane.case import Case
from minkref.oracle import slow
from minkref.oracle.slow.exact import positive


def slow_operands(case: Case) -> tuple[slow.Operand, slow.Operand]:
    """P, not scaled, and Q."""
    return slow_operand(case.P_json), slow_operand(case.Q_json)


def slow_operand(text: str) -> slow.Operand:
    return slow.operand_from_json(json.loads(text))


def slow_refuses(argument: Path, scale: str | None = None) -> bool:
    """Whether the reader of the slow engine refuses a file, `#P` or `#Q` of a case at its end, or
    the scale."""
    try:
        slow.read_operand(str(argument))
        if scale is not None:
            positive(scale)
    except slow.InputError:
        return True
    return False
