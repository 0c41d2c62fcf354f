"""The event array of the paper's program beside the exact array: missed and invented events."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import islice

from minkref import _core

CORRECTED = {name: corrected for name, _, corrected, _ in _core.paper_readings()}
Pair = tuple[int, int, bool]  # two edges, and whether they begin to meet
Edge = tuple[str, int, int, int, int, int]
Found = tuple[Fraction, str, Pair]


@dataclass(frozen=True)
class Event:
    """Two edges of the reduced convolution, by their parents, that begin or cease to meet."""

    scale: str
    begins: bool
    a: Edge
    b: Edge


@dataclass(frozen=True)
class Events:
    """Events at all scales; the first event of each kind has the least scale."""

    right: int
    misplaced: int  # the same edges begin or cease to meet, at another scale
    missed: int
    invented: int
    first_missed: Event | None
    first_invented: Event | None
    listed: list[tuple[Event, str | None]]  # with the exact scale, if such an event exists
    missed_within: list[Event]  # within the requested window, ascending
    invented_within: list[Event]


def compare_events(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    program: _core.PaperUpdate,
    adjacent: str,
    bits: int | None,
    most: int = 0,
    window: tuple[Fraction, Fraction] | None = None,
    threads: int = 1,
) -> Events:
    """The events of a program, in numbers of so many bits (None: exact numbers), by their edges. A
    scale is right if half its digits are, or all in exact numbers. Lists the first `most` events,
    and the first `most` missed and invented in a closed `window`. `adjacent`: the reading of the
    program, which says whether edges that share a vertex are asked. O(N^2) for N edges."""
    exact = _core.PaperUpdate(P, Q, "1", "rational", CORRECTED | {"adjacent": adjacent}, threads)
    wanted, found = _by_pair(exact), _by_pair(program)
    edges = _core.reduced_convolution(P, Q)
    off = Fraction(0) if bits is None else Fraction(1, 2 ** (bits // 2))
    both = wanted.keys() & found.keys()
    missed, invented = _alone(wanted, found), _alone(found, wanted)
    right = sum(_near(wanted[pair], found[pair], off) for pair in both)
    return Events(
        right,
        len(both) - right,
        len(missed),
        len(invented),
        _event(missed[0], edges) if missed else None,
        _event(invented[0], edges) if invented else None,
        [
            (_event((Fraction(scale), scale, pair), edges), wanted.get(pair))
            for pair, scale in islice(found.items(), most)
        ],
        _within(missed, window, most, edges),
        _within(invented, window, most, edges),
    )


def _by_pair(program: _core.PaperUpdate) -> dict[Pair, str]:
    return {(a, b, begins): scale for scale, a, b, begins in program.events()}


def _near(exact: str, scale: str, off: Fraction) -> bool:
    return abs(Fraction(scale) - Fraction(exact)) <= off * Fraction(exact)


def _alone(of: dict[Pair, str], without: dict[Pair, str]) -> list[Found]:
    """Ascending."""
    return sorted(
        (Fraction(scale), scale, pair) for pair, scale in of.items() if pair not in without
    )


def _event(found: Found, edges: list[Edge]) -> Event:
    _, scale, (a, b, begins) = found
    return Event(scale, begins, edges[a], edges[b])


def _within(
    found: list[Found], window: tuple[Fraction, Fraction] | None, most: int, edges: list[Edge]
) -> list[Event]:
    if window is None:
        return []
    inside = (one for one in found if window[0] <= one[0] <= window[1])
    return [_event(one, edges) for one in islice(inside, most)]
