"""The C++ program for a fault of CGAL in space: of Nef polyhedra, or of a convex hull."""

from __future__ import annotations

from minkref.fuzz.libraries.program import Program, filled, observed, scaled_operands
from minkref.fuzz.libraries.solids import quoted, surface
from minkref.fuzz.run.runner import Finding


def cgal_space_sum(finding: Finding, name: str) -> Program | None:
    operands = scaled_operands(finding)
    if operands is None or finding.case.dimension != 3:
        return None
    P, Q = (surface(text, quoted, "{}") for text in operands)
    witness = finding.outcome.witness
    text = filled(
        finding.outcome.target.replace("-", "/"),
        OBSERVED=observed(finding.outcome),
        NAME=name,
        P_VERTICES=P[0],
        P_TRIANGLES=P[1],
        Q_VERTICES=Q[0],
        Q_TRIANGLES=Q[1],
        X=", ".join(quoted(n) for n in witness.point) if witness else '"0", "0", "0"',
        POINT=", ".join(witness.point) if witness else "0, 0, 0",
        TRUTH="true" if witness and witness.in_truth else "false",
        CHECKED="true" if witness else "false",
    )
    flags = "-std=c++17 -O2 -DNDEBUG -frounding-math"
    run = f"g++ {flags} {name}.cpp -o {name} -lmpfr -lgmp && ./{name}"
    return Program(f"{name}.cpp", text, run)
