"""The Python program for a fault of Manifold."""

from __future__ import annotations

from minkref.fuzz.libraries.program import Program, filled, observed, scaled_operands
from minkref.fuzz.libraries.solids import double, surface
from minkref.fuzz.run.runner import Finding


def program(finding: Finding, name: str) -> Program | None:
    operands = scaled_operands(finding)
    if operands is None or finding.case.dimension != 3:
        return None
    P, Q = (surface(text, double) for text in operands)
    witness = finding.outcome.witness
    text = filled(
        "manifold/program",
        OBSERVED=observed(finding.outcome),
        NAME=name,
        P_VERTICES=P[0],
        P_TRIANGLES=P[1],
        Q_VERTICES=Q[0],
        Q_TRIANGLES=Q[1],
        X=", ".join(double(n) for n in witness.point) if witness else "0.0, 0.0, 0.0",
        TRUTH=str(witness.in_truth) if witness else "None",
    )
    return Program(f"{name}.py", text, f"pip install manifold3d numpy\npython {name}.py")
