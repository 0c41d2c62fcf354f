"""The C++ program for a fault of Boost.Geometry in a union."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from minkref.fuzz.libraries.grid import Ring, long_double
from minkref.fuzz.libraries.program import Program, filled, united_sets
from minkref.fuzz.run.runner import Finding


def program(finding: Finding, name: str) -> Program | None:
    sets = united_sets(finding)
    if sets is None:
        return None
    witness = finding.outcome.witness
    x, y = witness.point[:2] if witness else ("0", "0")
    text = filled(
        "boost_geometry/union",
        finding,
        name,
        SETS=",\n".join(f"    {_braced(map(_polygon, polygons))}" for polygons in sets),
        X=long_double(x),
        Y=long_double(y),
        POINT=f"({x}, {y})",
        TRUTH="true" if witness and witness.in_truth else "false",
        CHECK="crossings % 2 == 1" if witness else "truth",
    )
    return Program(f"{name}.cpp", text, f"c++ -std=c++17 -O2 {name}.cpp -o {name} && ./{name}")


def _polygon(rings: list[Ring]) -> str:
    return _braced(
        _braced(f"{{{float(Fraction(x))!r}, {float(Fraction(y))!r}}}" for x, y in ring)
        for ring in rings
    )


def _braced(texts: Iterable[str]) -> str:
    return "{" + ", ".join(texts) + "}"
