"""The Python program for a fault of GEOS in a union."""

from __future__ import annotations

import math
from fractions import Fraction

from minkref.fuzz.libraries.grid import Ring
from minkref.fuzz.libraries.program import Program, filled, united_sets
from minkref.fuzz.run.runner import Finding

BITS = 40  # as the adapter


def program(finding: Finding, name: str) -> Program | None:
    sets = united_sets(finding)
    if sets is None:
        return None
    unit = None
    if finding.outcome.target == "geos-grid":
        rings = [ring for polygons in sets for polygon in polygons for ring in polygon]
        size = max(abs(float(Fraction(n))) for ring in rings for point in ring for n in point)
        unit = math.ldexp(1.0, math.frexp(size)[1] - BITS)
    witness = finding.outcome.witness
    text = filled(
        "geos/union",
        finding,
        name,
        COUNT=str(len(sets)),
        HOW=" in doubles" if unit is None else " on a grid",
        SETS="".join(f"    {_set(polygons)},\n" for polygons in sets),
        GRID=repr(unit),
        X=", ".join(f'"{number}"' for number in (witness.point if witness else ("0", "0"))),
        TRUTH=str(witness.in_truth) if witness else "None",
    )
    return Program(f"{name}.py", text, f"pip install shapely\npython {name}.py")


def _set(polygons: list[list[Ring]]) -> str:
    return str([(_ring(rings[0]), [_ring(hole) for hole in rings[1:]]) for rings in polygons])


def _ring(ring: Ring) -> list[tuple[float, float]]:
    return [(float(Fraction(x)), float(Fraction(y))) for x, y in ring]
