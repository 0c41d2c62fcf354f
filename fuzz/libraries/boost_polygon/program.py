"""The C++ program for a fault of Boost.Polygon."""

from __future__ import annotations

from minkref.fuzz.libraries.grid import Ring, long_double, polygons_of, shift_of, to_grid
from minkref.fuzz.libraries.program import Program, filled, scaled_operands
from minkref.fuzz.run.runner import Finding

BITS = 28


def program(finding: Finding, name: str) -> Program | None:
    operands = scaled_operands(finding, 2)
    if operands is None:
        return None
    P, Q = (polygons_of(text) for text in operands)
    shift = shift_of((P, Q), BITS)
    witness = finding.outcome.witness
    x, y = witness.point[:2] if witness else ("0", "0")
    text = filled(
        "boost_polygon/program",
        finding,
        name,
        SHIFT=str(shift),
        P=_set(P, shift),
        Q=_set(Q, shift),
        X=long_double(x, shift),
        Y=long_double(y, shift),
        POINT=f"({x}, {y})",
        TRUTH="true" if witness and witness.in_truth else "false",
        CHECK="crossings % 2 == 1" if witness else "truth",
    )
    return Program(f"{name}.cpp", text, f"c++ -std=c++17 -O2 {name}.cpp -o {name} && ./{name}")


def _set(polygons: list[list[Ring]], shift: int) -> str:
    return ",\n".join(
        "    {" + ",\n     ".join(_ring(ring, shift) for ring in rings) + "}" for rings in polygons
    )


def _ring(ring: Ring, shift: int) -> str:
    points = [f"{{{to_grid(x, shift)}, {to_grid(y, shift)}}}" for x, y in ring]
    lines = [", ".join(points[k : k + 4]) for k in range(0, len(points), 4)]
    return "{" + ",\n      ".join(lines) + "}"
