"""The page of `minkref view P --features` as the JSON document that its scripts read."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.disc.page.picture import diagram
from minkref.plane.page.boundary import Window


def picture(
    index: _core.DiscIndex, found: _core.Features, P: _core.PolygonSet, window: Window
) -> dict[str, Any]:
    """The fields of the page's data: docs/command-line.md, "minkref view of features". `window`: of
    radii. In doubles, but for numbers that count. Refuses what is too large for a page, or for
    doubles."""
    infinity = found.radii + 1
    return {
        **diagram(index, P, window),
        "passages": None,
        "tree": [[kind[0], radius, parent] for kind, radius, parent, *_ in found.nodes()],
        "owners": list(found.feature_of),
        "bars": [
            [leaf, birth, infinity if death is None else death, end, int(essential)]
            for leaf, birth, death, end, essential, _ in found.bars()
        ],
    }


def counts(data: dict[str, Any]) -> dict[str, Any]:
    """The counts of the page for the document of the command."""
    return {
        "nodes": len(data["tree"]),
        "bars": len(data["bars"]),
        "endless_bars": sum(death > len(data["radii"]) for _, _, death, *_ in data["bars"]),
        "parts_of_the_diagram": len(data["halves"]) // 2,
    }
