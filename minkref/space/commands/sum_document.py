"""The document of `minkref sum --json` for a sum in space, by any route."""

from __future__ import annotations

import json
from typing import Any

from minkref.exact import in_double_range
from minkref.space.general_sum import GeneralSum
from minkref.space.operand import SpaceOperand
from minkref.space.space_sum import SpaceSum
from minkref.space.sums import sum_fields


def of_convex_sum(answer: SpaceSum, P: SpaceOperand, Q: SpaceOperand) -> dict[str, Any]:
    """The document of a sum by a route for convex operands."""
    fields = sum_fields(answer)
    return {
        "compute_seconds": answer.seconds,
        "convex": True,
        **fields,
        "components": 1 if fields["facets"] else 0,
        "cavities": 0,
        "tunnels": 0,
        "projected_areas": list(map(str, answer.surface.projected_areas())),
        "signs": None,
        "statistics": None,
        "result": json.loads(answer.surface.canonical_json()),
        "surface": None,
        "vertex_parents": answer.vertex_parents,
        "facet_parents": [{"P": list(p), "Q": list(q)} for p, q in answer.facet_parents],
        "operands": _operands(P, Q),
    }


def of_general_sum(answer: GeneralSum, P: SpaceOperand, Q: SpaceOperand) -> dict[str, Any]:
    """The document of a sum by a route for operands of any shape."""
    volume = answer.set.volume()
    return {
        "compute_seconds": answer.seconds,
        "convex": answer.convex is not None,
        "digest": answer.digest,
        "volume": volume,
        "volume_approximate": in_double_range(volume),
        **answer.surface.counts(),
        "projected_areas": list(map(str, answer.set.projected_areas())),
        **_signs_and_counts(answer.statistics),
        "result": json.loads(answer.canonical_json()),
        "surface": _surface(answer),
        "vertex_parents": None,
        "facet_parents": None,
        "operands": _operands(P, Q),
    }


def _surface(answer: GeneralSum) -> dict[str, Any]:
    return {
        "vertices": answer.surface.boundary.written_points(),
        "facets": [
            {
                "plane": facet.plane,
                "rings": facet.rings,
                "tips": facet.tips,
                "parents": [{"P": p, "Q": q} for p, q in facet.parents],
            }
            for facet in answer.surface.facets
        ],
    }


def _operands(P: SpaceOperand, Q: SpaceOperand) -> dict[str, Any]:
    return {
        name: json.loads(operand.canonical().canonical_json())
        for name, operand in (("P", P), ("Q", Q))
    }


def _signs_and_counts(statistics: dict[str, int] | None) -> dict[str, Any]:
    """As for a sum in the plane, with the shares of them all."""
    if statistics is None:
        return {"signs": None, "statistics": None}
    counts = dict(statistics)
    signs = {name: counts.pop(name) for name in ("by_float", "by_integer")}
    total = sum(signs.values())
    shares = {name: count / total if total else 0.0 for name, count in signs.items()}
    return {"signs": {**signs, "total": total, "shares": shares}, "statistics": counts}
