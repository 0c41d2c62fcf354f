"""Frames of the page of `minkref view` in space for sums that are found from scratch, of polyhedra
of any shape."""

from __future__ import annotations

from collections import Counter
from typing import Any

from minkref.exact import in_double_range
from minkref.page.template import json_for_script
from minkref.space.general_sum import GeneralSum
from minkref.space.page.view_page import KINDS, STEPS, Body, FrameBox, kind_of
from minkref.space.space_sum import Face

GENERAL_KINDS = (*KINDS, "several")


def general_row(answer: GeneralSum) -> dict[str, Any]:
    """The row of a frame for both the document and the page."""
    found = Counter(_kind(facet.parents) for facet in answer.surface.facets)
    volume = answer.set.volume()
    return {
        "scale": list(answer.scaling),
        "digest": answer.digest,
        "volume": volume,
        "volume_approximate": in_double_range(volume),
        **answer.surface.counts(),
        "kinds": {kind: found[kind] for kind in GENERAL_KINDS},
        **dict.fromkeys(STEPS),
    }


def general_text(row: dict[str, Any], answer: GeneralSum, P: Body, Q: Body) -> str:
    """A frame of the page: its row, and what is drawn."""
    box = FrameBox(row["scale"], P, Q)
    facets, boundary = answer.surface.facets, answer.surface.boundary
    near = [
        [float((axis - middle) / box.size) for axis, middle in zip(point, box.centre, strict=True)]
        for point in boundary.points()
    ]
    return json_for_script(
        {
            **row,
            **box.data,
            "points": boundary.written_points(),
            "near": near,
            "outlines": [facet.rings for facet in facets],
            "triangles": boundary.triangles(),
            "parents": [facet.parents for facet in facets],
        }
    )


def _kind(parents: list[Face]) -> str:
    kinds = {kind_of(*pair) for pair in parents}
    return kinds.pop() if len(kinds) == 1 else "several"
