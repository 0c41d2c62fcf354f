"""The program for a fault in CGAL, for plane and space."""

from __future__ import annotations

from minkref.fuzz.cgal.executables import METHOD_GROUPS, method_of_target
from minkref.fuzz.libraries.cgal.plane_program import cgal_sum
from minkref.fuzz.libraries.cgal.space_program import cgal_space_sum
from minkref.fuzz.libraries.program import Program
from minkref.fuzz.run.runner import Finding


def shows(target: str) -> bool:
    """Whether the target is a method in the plane; these methods have no adapters."""
    return method_of_target(target)[0] in METHOD_GROUPS


def program(finding: Finding, name: str) -> Program | None:
    make = cgal_sum if shows(finding.outcome.target) else cgal_space_sum
    return make(finding, name)
