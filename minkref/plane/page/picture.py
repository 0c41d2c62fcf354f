"""The page of `minkref view` as the JSON document that its scripts read."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.plane.page.boundary import (
    Progress,
    Sums,
    Window,
    refuse_beyond_doubles,
    ring_data,
    rings_of,
    states_of,
)
from minkref.plane.page.linear import double
from minkref.plane.page.passages import passages_at

CHANGES = {"birth": "b", "death": "d", "swap": "s", "touch": "t"}


def picture(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    window: Window,
    find: Callable[[], Sums],
    progress: Progress,
) -> dict[str, Any]:
    """The fields of the page's data. Exact but for the coordinates, which are doubles. `find` gives
    the sums of the window or of a larger one."""
    refuse_beyond_doubles(window)
    sums = find()
    states = states_of(sums, window, progress)
    boundary = [row for row in sums.boundary_events() if row[0] in window]
    if [row[0] for row in boundary] != states.scales:
        raise AssertionError("the states of the boundary do not begin at its events")
    at = {scale: index for index, scale in enumerate(states.scales)}
    convolution = _convolution(sums, _offsets(P), _offsets(Q))
    edges = sum(map(len, convolution.values())) // 2
    return {
        "P": rings_of(P),
        "Q": rings_of(Q),
        **convolution,
        **ring_data(sums, states, window, P, Q),
        "scales": states.scales,
        "kinds": "".join(CHANGES[row[1]] for row in boundary),
        "places": [_rounded(axis) for row in boundary for axis in row[3]],
        "passages": passages_at(P, Q, states.scales, edges),
        "topology": [_topology(row, at) for row in sums.topology_events() if row[0] in window],
        "holes": [_life(row, at, window) for row in sums.features("hole")],
        "components": [_life(row, at, window) for row in sums.features("component")],
    }


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
