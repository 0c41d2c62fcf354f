"""Cases in the plane, loaded by name."""

from __future__ import annotations

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run import naming


def named(text: str) -> Case:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, Case)
    return case
