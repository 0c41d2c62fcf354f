"""The tight passages that the page shows at events: these have no area, and no other scale shows
them."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction

from minkref import _core
from minkref.plane.commands.scale_index import cores
from minkref.plane.page.linear import double

MOST_WORK = 400_000  # edges of the convolution at events; some seconds

Passages = dict[str, list[list[float]]]  # by the number of the event, x, y, x, y, ... of each


def passages_at(
    P: _core.PolygonSet, Q: _core.PolygonSet, scales: list[str], edges: int
) -> Passages | None:
    """Those of the sums at these scales, found exactly, in doubles; None where there are too many
    `edges` and scales for a page that is not waited for."""
    if edges * len(scales) > MOST_WORK:
        return None
    with ThreadPoolExecutor(cores()) as pool:
        found = pool.map(lambda scale: _core.tight_passages(P, Q, scale), scales)
        return {
            str(event): [
                [double(Fraction(axis), "a coordinate") for point in points for axis in point]
                for points, _ in rows
            ]
            for event, rows in enumerate(found)
            if rows
        }
