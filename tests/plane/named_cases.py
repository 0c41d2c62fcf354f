"""Cases in the plane by their names."""

from __future__ import annotations

from minkref.fuzz.cases import naming
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case


def named(text: str) -> Case:
    case = naming.load(CaseName(text, "test"))
    assert isinstance(case, Case)
    return case
