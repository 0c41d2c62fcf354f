"""Where a point lies in a set, in the plane and in space: the answer to `--at`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from minkref import _core

INSIDE, BOUNDARY, OUTSIDE, UNDECIDED = "inside", "boundary", "outside", "undecided"


def placed(
    point: Sequence[str] | None, region: _core.PolygonSet | _core.PolyhedralSet | None
) -> dict[str, Any] | None:
    """Make the document's field `at`; None without a point or a set. Exact."""
    if point is None or region is None:
        return None
    return {"point": list(point), "place": region.locate(tuple(point))}


def placed_between(
    point: Sequence[str] | None, inner: _core.PolyhedralSet, outer: _core.PolyhedralSet
) -> dict[str, Any] | None:
    """As `placed`, for a set between two others: points within the inner set are inside, points
    off the outer set outside."""
    if point is None:
        return None
    if inner.locate(tuple(point)) == INSIDE:
        place = INSIDE
    else:
        place = OUTSIDE if outer.locate(tuple(point)) == OUTSIDE else UNDECIDED
    return {"point": list(point), "place": place}


def place_rows(value: dict[str, Any]) -> list[tuple[str, str]]:
    """Make the table's row; no row without a question."""
    at = value["at"]
    return [] if at is None else [(f"({', '.join(at['point'])})", at["place"])]
