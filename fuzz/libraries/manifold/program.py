"""The Python program for a fault of Manifold."""

from __future__ import annotations

from minkref.fuzz.libraries.program import Program, filled, scaled_operands
from minkref.fuzz.libraries.solids import double, surfaces
from minkref.fuzz.run.runner import Finding


def program(finding: Finding, name: str) -> Program | None:
    operands = scaled_operands(finding, 3)
    if operands is None:
        return None
    witness = finding.outcome.witness
    text = filled(
        "manifold/program",
        finding,
        name,
        **surfaces(operands, double),
        X=", ".join(double(n) for n in witness.point) if witness else "0.0, 0.0, 0.0",
        TRUTH=str(witness.in_truth) if witness else "None",
    )
    return Program(f"{name}.py", text, f"pip install manifold3d numpy\npython {name}.py")
