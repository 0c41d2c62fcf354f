"""The sum at, just below and just above a scale, and the changes there, without knowing any
event."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from .identity import Link, component_links, hole_links
from .minkowski import Sum, checked_frame, sum_of
from .operand import Operand
from .state import State, state

Corner = tuple[Fraction, ...]
Cycle = tuple[Corner, ...]


@dataclass(frozen=True)
class Topology:
    """Changes at a scale. `boundary_changes`: the boundary changes its vertices or their order, or
    touches itself there and not nearby. `topology_changes`: a hole or component starts, dies,
    merges, splits or touches."""

    below: State
    at: State
    above: State
    result: Sum
    boundary_changes: bool
    holes: list[Link]
    components: list[Link]

    @property
    def topology_changes(self) -> bool:
        return any(link.change != "same" for link in self.holes + self.components)


def topology(
    P: Operand, Q: Operand, scale: Fraction = Fraction(1), explicit: bool = False
) -> Topology:
    """Compute the states and changes at a scale. Exact, by one computation over numbers a + b e
    with an infinitesimal e. Raises as `minkowski_sum`; cost: three sums. `explicit`: with slower
    germs that refuse to exceed their degree."""
    frame = checked_frame(P, Q, scale)
    below, at, above = (state(frame, scale, side, explicit) for side in (-1, 0, 1))
    return Topology(
        below,
        at,
        above,
        sum_of(at),
        boundary_changes(below, at, above),
        hole_links(below, at, above),
        component_links(below, at, above),
    )


def boundary_changes(below: State, at: State, above: State) -> bool:
    """Tell whether tracks and rings differ above and below, or the state between differs."""
    return (
        tracks(below) != tracks(above)
        or places(below) != places(at)
        or not below.pinches == at.pinches == above.pinches
    )


def tracks(of: State) -> list[list[Cycle]]:
    """Return rings as cycles of vertices with position and velocity, in a fixed order."""
    return cycles(
        [
            [[(x.value, y.value, x.slope, y.slope) for x, y in ring] for ring in part]
            for part in of.rings
        ]
    )


def places(of: State) -> list[list[Cycle]]:
    """Return rings as cycles of positions at the scale."""
    return cycles([[[(x.value, y.value) for x, y in ring] for ring in part] for part in of.rings])


def cycles(parts: list[list[list[Corner]]]) -> list[list[Cycle]]:
    def from_least(ring: list[Corner]) -> Cycle:
        low = ring.index(min(ring))
        return (*ring[low:], *ring[:low])

    found = []
    for part in parts:
        rings = [from_least(ring) for ring in part]
        found.append([rings[0], *sorted(rings[1:])])
    return sorted(found)
