"""The fields of a sum in every document."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.exact import digest, in_double_range

SUM_FIELDS = ("digest", "area", "area_approximate", "components", "holes", "vertices")


def sum_fields(answer: _core.Sum) -> dict[str, Any]:
    """The fields SUM_FIELDS, exact but for `area_approximate`."""
    area = answer.region.area()
    values = (
        digest(answer.region.canonical_json()),
        area,
        in_double_range(area),
        answer.components,
        answer.holes,
        answer.region.vertices,
    )
    return dict(zip(SUM_FIELDS, values, strict=True))
