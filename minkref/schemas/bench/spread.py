"""Times of many calls."""

from __future__ import annotations

from typing import Annotated, TypedDict

from minkref.schemas.values import Amount, Count
from msgspec import Meta


class Spread(TypedDict):
    count: Count
    mean: Amount
    lower: Annotated[Amount, Meta(description="Quartile.")]
    median: Amount
    upper: Annotated[Amount, Meta(description="Quartile.")]
