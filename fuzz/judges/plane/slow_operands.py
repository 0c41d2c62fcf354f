"""A case's operands in the slow engine's form."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

from minkref.exact import set_json
from minkref.fuzz.geometry.plane import read_shape, scale_factors
from minkref.fuzz.plane.case import Case
from minkref.oracle import slow
from minkref.oracle.slow.exact import positive


def slow_operands(case: Case) -> tuple[slow.Operand, slow.Operand]:
    """P, not scaled, and Q. A factor for each axis is applied here, in fractions: the engine has
    one scale, which is 1 then."""
    P = case.P_json
    if not case.is_uniform:
        shape = read_shape(P, scale_factors(case.scale))
        P = set_json((polygon[0], polygon[1:]) for polygon in shape)
    return slow_operand(P), slow_operand(case.Q_json)


def slow_scale(case: Case) -> Fraction:
    """The scale for what slow_operands gives."""
    return Fraction(case.scale) if case.is_uniform else Fraction(1)


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
