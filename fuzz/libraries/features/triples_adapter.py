"""Features by all triples (oracle/features)."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from adapter_protocol import Set, serve  # type: ignore[import-not-found,unused-ignore]
from minkref.oracle.features import Judge
from minkref.version import version

CAPABILITIES = "plane non-convex holes components touching rational features"
HELLO = {
    "name": "features-triples",
    "version": version(),
    "language": "Python",
    "arithmetic": "exact",
    "numbers": "text",
    "sum": "none",
    "capabilities": CAPABILITIES.split(),
}
ROUNDED = Fraction(1, 10**12)  # of a radius that has no rational square


def features_of(P: Set, radius: str) -> dict[str, Any]:
    polygons = [[each["outer"], *each["holes"]] for each in P["polygons"]]
    judge = Judge(polygons)
    square = Fraction(radius) ** 2
    components, holes = judge.shape_counts(square)
    chords = [chord for feature in judge.alive(square) for _, chord in feature.bridges]
    return {
        "bars": [[_radius(judge, level) for level in bar] for bar in judge.bars()],
        "bridges": [[[str(Fraction(float(x))) for x in end] for end in chord] for chord in chords],
        "components": components,
        "holes": holes,
    }


def _radius(judge: Judge, level: int) -> Any:
    square = judge.squared_radius(level)
    if square is None:
        return None
    if square.rational is not None:
        return {"square": str(square.rational)}
    near = Fraction(float(square) ** 0.5)
    return [str(near * (1 - ROUNDED)), str(near * (1 + ROUNDED))]


if __name__ == "__main__":
    serve(HELLO, None, features_of=features_of)
