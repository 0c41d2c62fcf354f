"""The stand-alone C++ program that shows a fault of CGAL without us."""

from __future__ import annotations

from dataclasses import dataclass

from minkref import _core
from minkref.fuzz.cgal.executables import method_of_target
from minkref.fuzz.cgal.program import cgal_program
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.verdicts.verdict import Outcome


@dataclass(frozen=True)
class Program:
    file: str
    text: str


def program(finding: Finding, name: str) -> Program | None:
    """The program for a finding against CGAL; None for others and where CGAL takes no such
    operands."""
    outcome, case = finding.outcome, finding.case
    if not outcome.target.startswith("cgal-") or case.P is None or case.Q is None:
        return None
    method, raw = method_of_target(outcome.target)
    scaled = _core.PolygonSet.from_json(case.P).scaled(case.scale).to_json()
    witness = outcome.witness
    try:
        text = cgal_program(
            scaled,
            case.Q,
            method,
            (witness.point[0], witness.point[1]) if witness else None,
            witness.in_truth if witness else False,
            raw=raw,
            observed=_observed(outcome),
            name=name,
        )
    except ValueError:
        return None
    return Program(f"{name}.cpp", text)


def _observed(outcome: Outcome) -> str:
    signal = f", {outcome.signal}" if outcome.signal else ""
    return f"{outcome.target} {outcome.was or outcome.verdict}: {', '.join(outcome.kinds)}{signal}"
