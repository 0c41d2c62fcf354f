"""The page of `minkref view` as the JSON document that its scripts read."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.plane.page.linear import double, linear, out_of_range
from minkref.plane.page.passages import passages_at
from minkref.plane.page.ring_changes import Row
from minkref.plane.page.states import States

Sums = _core.ScaleIndex | _core.DynamicSum

Progress = Callable[[int, int], None]  # states done, states in all

NARROWEST = 1e-12
# The count that says how many states there are.
GROUPS = {_core.DynamicSum: "boundary_groups", _core.ScaleIndex: "boundary_events"}
CHANGES = {"birth": "b", "death": "d", "swap": "s", "touch": "t"}


@dataclass(frozen=True)
class Window:
    """Closed; exact."""

    first: str
    last: str

    def __contains__(self, scale: str) -> bool:
        return Fraction(self.first) <= Fraction(scale) <= Fraction(self.last)


def picture(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    window: Window,
    find: Callable[[], Sums],
    progress: Progress,
) -> dict[str, Any]:
    """The fields of the page's data. Exact but for the coordinates, which are doubles. `find` gives
    the sums of the window or of a larger one."""
    first = double(Fraction(window.first), "a scale")
    last = double(Fraction(window.last), "a scale")
    if first == 0:
        raise Refusal("the scale is too small for a double", "--from", "begin later", "limit")
    if last <= first * (1 + NARROWEST):
        raise Refusal(
            "the window is too narrow for doubles", "--from, --to", "take a wider one", "limit"
        )
    sums = find()
    states = _states(sums, window, progress)
    boundary = [row for row in sums.boundary_events() if row[0] in window]
    if [row[0] for row in boundary] != states.scales:
        raise AssertionError("the states of the boundary do not begin at its events")
    at = {scale: index for index, scale in enumerate(states.scales)}
    convolution = _convolution(sums, _offsets(P), _offsets(Q))
    edges = sum(map(len, convolution.values())) // 2
    return {
        "window": [[window.first, first], [window.last, last]],
        "P": rings_of(P),
        "Q": rings_of(Q),
        **convolution,
        **_tracks(sums, states, Fraction(window.last), _reach(P, Q, window)),
        "scales": states.scales,
        "about": [double(Fraction(scale), "a scale") for scale in states.scales],
        "kinds": "".join(CHANGES[row[1]] for row in boundary),
        "places": [_rounded(axis) for row in boundary for axis in row[3]],
        "passages": passages_at(P, Q, states.scales, edges),
        "states": states.encoded,
        "topology": [_topology(row, at) for row in sums.topology_events() if row[0] in window],
        "holes": [_life(row, at, window) for row in sums.features("hole")],
        "components": [_life(row, at, window) for row in sums.features("component")],
    }


def _states(sums: Sums, window: Window, progress: Progress) -> States:
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


def rings_of(operand: _core.PolygonSet) -> list[list[list[float]]]:
    """The rings of each polygon, as x, y, x, y, ..."""
    rings = [
        [[axis for point in ring for axis in point] for ring in polygon]
        for polygon in operand.approximate_rings()
    ]
    if not all(math.isfinite(axis) for polygon in rings for ring in polygon for axis in ring):
        raise out_of_range("a coordinate")
    return rings


def _offsets(operand: _core.PolygonSet) -> list[int]:
    """How many vertices stand before each ring, rings numbered outer, holes, outer, ..."""
    offsets, total = [], 0
    for polygon in operand.approximate_rings():
        for ring in polygon:
            offsets.append(total)
            total += len(ring)
    return offsets


def _convolution(sums: Sums, of_P: list[int], of_Q: list[int]) -> dict[str, list[int]]:
    """S- and T-edges: the vertex where the edge starts and the vertex of the other operand, by
    their numbers in all the operand."""
    edges: dict[str, list[int]] = {"S": [], "T": []}
    for kind, _, edge_ring, edge, vertex_ring, vertex in sums.edges():
        own, other = (of_P, of_Q) if kind == "S" else (of_Q, of_P)
        edges[kind] += [own[edge_ring] + edge, other[vertex_ring] + vertex]
    return edges


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


def _topology(row: Any, at: dict[str, int]) -> list[Any]:
    """The number of the event, what changes and how, which before and after, where."""
    scale, feature, change, before, after, parts, place = row
    return [
        at[scale], feature[0], change, list(before), list(after), parts,
        [_rounded(axis) for axis in place],
    ]  # fmt: skip


def _life(row: Any, at: dict[str, int], window: Window) -> list[int] | None:
    """The numbers of the events of birth and death; -1, or their count, where it is there when the
    window begins, or when it ends. None: not there in the window."""
    born, died = row
    if died is not None and Fraction(died) < Fraction(window.first):
        return None
    if born is not None and Fraction(born) > Fraction(window.last):
        return None
    return [at.get(born, -1), at.get(died, len(at))]


def _rounded(number: str) -> float:
    """For pointing at a place."""
    return double(Fraction(number), "a coordinate")
