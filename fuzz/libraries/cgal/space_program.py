"""The C++ program for a fault of CGAL in space, with Nef polyhedra or a convex hull."""

from __future__ import annotations

from minkref.fuzz.libraries.program import Program, filled, scaled_operands
from minkref.fuzz.libraries.solids import quoted, surfaces
from minkref.fuzz.run.runner import Finding


def cgal_space_sum(finding: Finding, name: str) -> Program | None:
    operands = scaled_operands(finding, 3)
    if operands is None:
        return None
    witness = finding.outcome.witness
    text = filled(
        finding.outcome.target.replace("-", "/"),
        finding,
        name,
        **surfaces(operands, quoted, "{}"),
        X=", ".join(quoted(n) for n in witness.point) if witness else '"0", "0", "0"',
        POINT=", ".join(witness.point) if witness else "0, 0, 0",
        TRUTH="true" if witness and witness.in_truth else "false",
        CHECKED="true" if witness else "false",
    )
    flags = "-std=c++17 -O2 -DNDEBUG -frounding-math"
    run = f"g++ {flags} {name}.cpp -o {name} -lmpfr -lgmp && ./{name}"
    return Program(f"{name}.cpp", text, run)
