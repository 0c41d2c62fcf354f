"""The evidence's operands: the paper's models if MINKREF_MODELS provides them, else our
look-alikes."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.model_catalogue import all_models, or_look_alike
from minkref.plane.operand import Operand, read_operand
from minkref.reports.evidence.framework.part import Findings

SCALES = ("1/3", "1", "7/5", "541/186", "9")
REAL_PAIRS = (("disc1", "neuron"), ("disc5", "neuron"), ("monkey", "bird"))


@cache
def operand(name: str) -> Operand:
    """The model, or our look-alike."""
    return read_operand(or_look_alike(name, all_models()))


def has_paper_models(*names: str) -> bool:
    return all(name in all_models() for name in names)


def tell_absent(findings: Findings, *names: str) -> bool:
    """Whether the paper's models exist for all names; notes each model that a look-alike
    replaces."""
    absent = [name for name in names if not has_paper_models(name)]
    for name in absent:
        alike = or_look_alike(name, all_models())
        findings.note(f"MINKREF_MODELS does not provide {name}: our {alike} stands for it")
    return not absent


def case_of(first: str, second: str, scale: str) -> Case:
    """`scale` times the first model, and the second."""
    P, Q = operand(first), operand(second)
    name = CaseName(f"{P.name}+{Q.name}@{scale}", "evidence")
    return Case(name, P.set, Q.set, str(Fraction(scale)), P.name, Q.name)
