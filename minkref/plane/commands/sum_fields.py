"""The fields of a sum or another set in every document."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.exact import digest, in_double_range
from minkref.plane.proved_sum import ProvedSum

SUM_FIELDS = ("digest", "area", "area_approximate", "components", "holes", "vertices")


def sum_fields(answer: _core.Sum | ProvedSum) -> dict[str, Any]:
    """The fields SUM_FIELDS, exact but for `area_approximate`."""
    return set_fields(answer.region, answer.components, answer.holes)


def set_fields(region: _core.PolygonSet, components: int, holes: int) -> dict[str, Any]:
    """The fields SUM_FIELDS of a set in canonical form."""
    area = region.area()
    values = (
        digest(region.canonical_json()),
        area,
        in_double_range(area),
        components,
        holes,
        region.vertices,
    )
    return dict(zip(SUM_FIELDS, values, strict=True))
