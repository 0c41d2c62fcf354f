"""Hypothesis strategies for testing your own Minkowski sums (docs/strategies.md).

from minkref.strategies import scaled_pairs
@given(scaled_pairs())
def test_my_sum(case): ...
"""

from __future__ import annotations

try:
    import hypothesis as _hypothesis  # noqa: F401
except ModuleNotFoundError as error:
    if error.name != "hypothesis":
        raise
    raise ImportError(
        "minkref.strategies needs Hypothesis, which is not installed. To fix it: pip install "
        "'minkref[strategies]', or pip install hypothesis"
    ) from error

from minkref.strategies.degenerate import DEGENERATE_FAMILIES, degenerate_pairs
from minkref.strategies.event_scales import scaled_pairs, scales_near_events
from minkref.strategies.regions import pairs, polygons
from minkref.strategies.values import (
    DegeneratePair,
    PolygonData,
    ScaledPair,
    SetData,
    to_data,
    to_fractions,
    to_set,
)

__all__ = [
    "DEGENERATE_FAMILIES",
    "DegeneratePair",
    "PolygonData",
    "ScaledPair",
    "SetData",
    "degenerate_pairs",
    "pairs",
    "polygons",
    "scaled_pairs",
    "scales_near_events",
    "to_data",
    "to_fractions",
    "to_set",
]
