"""Refusal of invalid operands, as a question of `verify`."""

from __future__ import annotations

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.invalid.asking import InvalidAsking
from minkref.fuzz.invalid.invalid_case import FAMILY, InvalidCase, load_invalid
from minkref.fuzz.setting import Question


class Refusals(Question):
    """Two operands in the plane, one invalid. No smaller cases are known to be invalid."""

    cases = InvalidCase
    asking = InvalidAsking

    def drawn(self, name: CaseName, family: str, seed: int, index: int) -> InvalidCase | None:
        return load_invalid(name, seed, index) if family == FAMILY else None


REFUSALS = Refusals()
