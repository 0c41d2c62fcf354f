"""Bars of features along a library's Voronoi diagram, in doubles: the argument is CGAL or Boost."""

from __future__ import annotations

import math
import sys
from fractions import Fraction
from typing import Any

from adapter_protocol import GaveUp, Set, serve  # type: ignore[import-not-found,unused-ignore]
from minkref.fuzz.features.diagram_bars import bars_of
from minkref.fuzz.features.outer_diagram import DiagramJudge
from minkref.fuzz.features.outline import Outline
from minkref.version import version

SECONDS = 60.0
CAPABILITIES = "plane non-convex holes components touching rational features"


def main(library: str) -> None:
    hello = {
        "name": f"features-{library.lower()}",
        "version": version(),
        "language": "C++",
        "arithmetic": "float64",
        "numbers": "text",
        "tolerance": {"absolute": "0", "relative": "4e-9"},
        "sum": "none",
        "capabilities": CAPABILITIES.split(),
    }
    with DiagramJudge(library, SECONDS) as judge:

        def features_of(P: Set, radius: str) -> dict[str, Any]:
            rings = [ring for each in P["polygons"] for ring in (each["outer"], *each["holes"])]
            outline = Outline(rings)
            graph = judge.graph(outline)
            if isinstance(graph, str):
                raise GaveUp(graph)
            return {
                "bars": [[_text(birth), _text(death)] for birth, death in bars_of(outline, graph)]
            }

        serve(hello, None, features_of=features_of)


def _text(radius: float) -> str | None:
    return str(Fraction(radius)) if math.isfinite(radius) else None


if __name__ == "__main__":
    main(sys.argv[1])
