"""The boundary of a sum over a window of scales, for scripts of pages."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.plane.page.linear import double, linear, out_of_range
from minkref.plane.page.ring_changes import Row
from minkref.plane.page.states import States

Sums = _core.ScaleIndex | _core.DynamicSum

Progress = Callable[[int, int], None]  # states done, states in all

NARROWEST = 1e-12
# Names of counts: the number of states.
GROUPS = {_core.DynamicSum: "boundary_groups", _core.ScaleIndex: "boundary_events"}


@dataclass(frozen=True)
class Window:
    """Closed; exact."""

    first: str
    last: str

    @property
    def doubles(self) -> tuple[float, float]:
        """The doubles next to the ends."""
        first, last = (double(Fraction(end), "a scale") for end in (self.first, self.last))
        return first, last

    def __contains__(self, scale: str) -> bool:
        return Fraction(self.first) <= Fraction(scale) <= Fraction(self.last)


def refuse_beyond_doubles(window: Window) -> None:
    """Refuse a window whose ends doubles do not tell apart, or do not hold."""
    first, last = window.doubles
    if first == 0:
        raise Refusal("the scale is too small for a double", "--from", "begin later", "limit")
    if last <= first * (1 + NARROWEST):
        raise Refusal(
            "the window is too narrow for doubles", "--from, --to", "take a wider one", "limit"
        )


def rings_of(operand: _core.PolygonSet) -> list[list[list[float]]]:
    """The rings of each polygon, as x, y, x, y, ..."""
    rings = [
        [[axis for point in ring for axis in point] for ring in polygon]
        for polygon in operand.approximate_rings()
    ]
    if not all(math.isfinite(axis) for polygon in rings for ring in polygon for axis in ring):
        raise out_of_range("a coordinate")
    return rings


def states_of(sums: Sums, window: Window, progress: Progress) -> States:
    """The states of the window. Those that begin before it count up to the last of them only."""
    states = States()
    total = int(sums.counts().get(GROUPS[type(sums)], 0)) + 1
    pending: Sequence[Row] = []
    done = 0

    def take(state: tuple[str | None, Sequence[Row]]) -> None:
        nonlocal pending, done
        scale, rows = state
        done += 1
        progress(done, total)
        if scale is None or Fraction(scale) < Fraction(window.first):
            pending = rows
        elif scale in window:
            if not states.begun:
                states.begin(pending)
            states.add(scale, rows)

    sums.ring_states(take)
    if not states.begun:
        states.begin(pending)
    return states


def ring_data(
    sums: Sums, states: States, window: Window, P: _core.PolygonSet, Q: _core.PolygonSet
) -> dict[str, Any]:
    """Return fields for the rings of sP + Q at any scale of the window: `window`, `about` (scales
    of all states but the first), `states`, `tracks`, `centres`, `lives`. Doubles, computed from
    exact tracks."""
    first, last = window.doubles
    return {
        "window": [[window.first, first], [window.last, last]],
        **_tracks(sums, states, Fraction(window.last), _reach(P, Q, window)),
        "about": [double(Fraction(scale), "a scale") for scale in states.scales],
        "states": states.encoded,
    }


def _reach(P: _core.PolygonSet, Q: _core.PolygonSet, window: Window) -> Fraction:
    """No coordinate of the sums is greater."""
    if P.is_empty or Q.is_empty:
        return Fraction(0)
    sizes = [max(abs(Fraction(axis)) for axis in operand.bounding_box()) for operand in (P, Q)]
    return Fraction(window.last) * sizes[0] + sizes[1]


def _tracks(sums: Sums, states: States, last: Fraction, reach: Fraction) -> dict[str, Any]:
    """`tracks`: r and m of x and of y of each, one after another; `centres`: c of the few that have
    one, by place (2 i for x of track i, 2 i + 1 for y); `lives`: first and last state of each."""
    every = sums.tracks()
    tracks: list[float] = []
    centres: dict[str, float] = {}
    for number, original in enumerate(states.used):
        a, b = every[original]
        for axis in (0, 1):
            r, m, c = linear(Fraction(a[axis]), Fraction(b[axis]), last, reach)
            tracks += [r, m]
            if c:
                centres[str(2 * number + axis)] = c
    lives = [state for life in states.lives for state in life]
    return {"tracks": tracks, "centres": centres, "lives": lives}
