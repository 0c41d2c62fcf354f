"""Polygon sets, and pairs of polygon sets."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from hypothesis import strategies as st
from minkref.strategies.growth import Corner, Part, grown
from minkref.strategies.values import SetData, data_of

MOSTLY = st.sampled_from((False, True, True))  # shrinks to False


@dataclass(frozen=True)
class Bounds:
    """Bounds for a drawn set."""

    max_vertices: int
    holes: int
    components: int
    denominators: tuple[int, ...]
    magnitude: int

    def __post_init__(self) -> None:
        least = {"max_vertices": 3, "holes": 0, "components": 1, "magnitude": 1}
        for name, low in least.items():
            if getattr(self, name) < low:
                raise ValueError(
                    f"{name} is {getattr(self, name)}: give a number of at least {low}"
                )
        if not self.denominators or min(self.denominators) < 1:
            raise ValueError(f"denominators are {self.denominators}: give numbers of at least 1")


def polygons(
    *,
    max_vertices: int = 8,
    holes: int = 1,
    components: int = 1,
    denominators: Sequence[int] = (1, 2, 3),
    magnitude: int = 10,
) -> st.SearchStrategy[SetData]:
    """Draw polygon sets: up to `components` polygons, beside or within one another, each with up to
    `holes` holes, and up to `max_vertices` vertices per ring. Coordinates lie within [-magnitude,
    magnitude], multiples of 1/d with one denominator for the whole set. Rings may touch at points,
    and vertices may be straight.

    Shrinks to fewer components, holes and vertices, the first denominator, and numbers towards 0;
    at last to the triangle (0,0) (1,0) (0,1). Exact, and always valid (docs/definitions.md). Some
    milliseconds per set; O(n^2) validations by the reference. Raises ValueError for impossible
    bounds."""
    bounds = Bounds(max_vertices, holes, components, tuple(denominators), magnitude)
    return _polygons(bounds)


def pairs(
    *,
    max_vertices: int = 8,
    holes: int = 1,
    components: int = 1,
    denominators: Sequence[int] = (1, 2, 3),
    magnitude: int = 10,
    without_area: bool = False,
) -> st.SearchStrategy[tuple[SetData, SetData]]:
    """Draw operands (P, Q), each as `polygons` draws a set. `without_area`: one operand may also be
    a point, a segment, or the empty set.

    Shrinks as `polygons` does, both to the least triangle; without area to a point. Exact, and
    always valid. Twice the cost of a set. Raises ValueError as `polygons`."""
    bounds = Bounds(max_vertices, holes, components, tuple(denominators), magnitude)
    region = _polygons(bounds)
    both = st.tuples(region, region)
    if not without_area:
        return both
    thin = _without_area(bounds)
    return st.one_of(st.tuples(region, thin), st.tuples(thin, region), both)


@st.composite
def _polygons(draw: st.DrawFn, bounds: Bounds) -> SetData:
    """Draw the whole plan first, independent of the geometry, so that it shrinks freely."""
    unit = draw(st.sampled_from(bounds.denominators))
    limit = bounds.magnitude * unit
    reach = min(limit, 2 ** draw(st.integers(0, limit.bit_length())))
    parts = draw(st.lists(_parts(bounds, reach), min_size=1, max_size=bounds.components))
    return data_of(grown(parts, limit, bounds.max_vertices), unit)


def _parts(bounds: Bounds, reach: int) -> st.SearchStrategy[Part]:
    near = st.integers(-reach, reach)
    corner: st.SearchStrategy[Corner] = st.tuples(
        near, near, st.integers(0, bounds.max_vertices - 1)
    )
    corners = st.lists(corner, min_size=3, max_size=2 * bounds.max_vertices)
    choices: dict[str, Any] = {}
    if bounds.holes:
        choices["holes"] = st.lists(st.tuples(MOSTLY, corners), max_size=bounds.holes)
    if bounds.holes or bounds.components > 1:
        choices |= {"boxed": st.booleans(), "bare": st.booleans()}
        choices |= {name: st.sampled_from((1, 0, 2, 3)) for name in ("margin", "gap")}
    if bounds.components > 1:
        choices |= {"kept": MOSTLY, "around": st.booleans() if bounds.holes else st.just(False)}
    return st.builds(Part, corners=corners, **choices)


@st.composite
def _without_area(draw: st.DrawFn, bounds: Bounds) -> SetData:
    """Draw a point, a segment, or the empty set."""
    unit = draw(st.sampled_from(bounds.denominators))
    limit = bounds.magnitude * unit
    number = st.integers(-limit, limit)
    points = st.lists(st.tuples(number, number), min_size=1, max_size=2, unique=True)
    ring = draw(st.one_of(points, st.just([])))
    return data_of([[list(ring)]], unit) if ring else {"polygons": []}
