"""The C++ program for a fault of Clipper2, or of the region built on its MinkowskiSum."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.libraries.grid import Ring, long_double, polygons_of, shift_of, to_grid
from minkref.fuzz.libraries.program import Program, filled, scaled_operands
from minkref.fuzz.run.runner import Finding

BITS = 30
NOTES = {
    "clipper2-region": (
        "Clipper2 has no sum of regions. The program follows the recipe that is given for it "
        "(Clipper2 issue 719), the sum of the rings united with translates of the operands, in one "
        "union: MinkowskiSum would unite and round the parallelograms before."
    )
}
_WHAT = {
    "clipper2": "MinkowskiSum of Paths64: the sum of the two curves",
    "clipper2-double": "MinkowskiSum of PathsD: the sum of the two curves",
    "clipper2-region": "the region: Union of the parallelograms of MinkowskiSum and of translates",
}


def program(finding: Finding, name: str) -> Program | None:
    """None in space, and for operands that the call does not take."""
    operands = scaled_operands(finding, 2)
    target = finding.outcome.target
    if operands is None:
        return None
    P, Q = (polygons_of(text) for text in operands)
    real = target == "clipper2-double"
    shift = 0 if real else shift_of((P, Q), BITS)
    if target != "clipper2-region" and any(len(s) != 1 or len(s[0]) != 1 for s in (P, Q)):
        return None
    witness = finding.outcome.witness
    x, y = witness.point[:2] if witness else ("0", "0")
    scale = f"times 2^{shift}, " if shift else ""
    text = filled(
        "clipper2/region" if target == "clipper2-region" else "clipper2/curves",
        finding,
        name,
        WHAT=_WHAT[target],
        UNIT=f"{scale}rounded" if not real else "as doubles",
        P=_set(P, shift, real),
        Q=_set(Q, shift, real),
        KIND="D" if real else "64",
        X=long_double(x, shift),
        Y=long_double(y, shift),
        POINT=f"({x}, {y})",
        TRUTH="true" if witness and witness.in_truth else "false",
        CHECK="winding(sum, x, y) > 0" if witness else "truth",
    )
    library = "$CLIPPER2/include $CLIPPER2/src/clipper.*.cpp"
    build = f"c++ -std=c++17 -O2 -I{library} {name}.cpp -o {name} && ./{name}"
    run = f"CLIPPER2=...  # the folder CPP/Clipper2Lib of the library's sources\n{build}"
    return Program(f"{name}.cpp", text, run, NOTES.get(target, ""))


def _set(polygons: list[list[Ring]], shift: int, real: bool) -> str:
    return ",\n".join(
        "    {" + ",\n     ".join(_path(ring, shift, real) for ring in rings) + "}"
        for rings in polygons
    )


def _path(ring: Ring, shift: int, real: bool) -> str:
    points = [
        f"{{{float(Fraction(x))!r}, {float(Fraction(y))!r}}}"
        if real
        else f"{{{to_grid(x, shift)}, {to_grid(y, shift)}}}"
        for x, y in ring
    ]
    lines = [", ".join(points[k : k + 4]) for k in range(0, len(points), 4)]
    return "{" + ",\n      ".join(lines) + "}"
