"""The C++ program for a fault in a CGAL method in the plane."""

from __future__ import annotations

from minkref.fuzz.cgal.executables import method_of_target
from minkref.fuzz.cgal.program import cgal_program
from minkref.fuzz.libraries.program import Program, observed, scaled_operands
from minkref.fuzz.run.runner import Finding


def cgal_sum(finding: Finding, name: str) -> Program | None:
    """Returns the program, or None if CGAL refuses such operands."""
    operands = scaled_operands(finding, 2)
    if operands is None:
        return None
    method, raw = method_of_target(finding.outcome.target)
    witness = finding.outcome.witness
    try:
        text = cgal_program(
            *operands,
            method,
            (witness.point[0], witness.point[1]) if witness else None,
            witness.in_truth if witness else False,
            raw=raw,
            observed=observed(finding.outcome),
            name=name,
        )
    except ValueError:
        return None
    flags = "-std=c++17 -O2 -DNDEBUG -frounding-math"
    run = f"g++ {flags} {name}.cpp -o {name} -lmpfr -lgmp && ./{name}"
    return Program(f"{name}.cpp", text, run)
