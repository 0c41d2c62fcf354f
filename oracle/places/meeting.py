"""Parts of the complement connected by bridges with one length, which separate there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Self

from .boundary import Place
from .bridges import Bridge
from .joined import Joined


@dataclass(frozen=True)
class Gate:
    """A bridge, and the parts to its left and right."""

    bridge: Bridge
    left: int
    right: int


class Meeting:
    def __init__(self, gates: Sequence[Gate], hole_of: Mapping[int, int]) -> None:
        self.gates = gates
        self.parts = sorted({part for gate in gates for part in (gate.left, gate.right)})
        self._hole_of = {part: hole_of[part] for part in self.parts if part in hole_of}
        self.holes = set(self._hole_of.values())

    @classmethod
    def all_of(cls, gates: Sequence[Gate], hole_of: Mapping[int, int]) -> Iterator[Self]:
        """Group gates with one length into meetings. `hole_of` maps parts that reach farther away
        to holes."""
        joined = Joined(1 + max((max(gate.left, gate.right) for gate in gates), default=0))
        for gate in gates:
            joined.join(gate.left, gate.right)
        for root in sorted({joined.root(gate.left) for gate in gates}):
            yield cls([gate for gate in gates if joined.root(gate.left) == root], hole_of)

    @property
    def where(self) -> str:
        """Name the meeting by a bridge's middle."""
        x, y = map(float, self.gates[0].bridge.middle)
        return f"({x:.9g}, {y:.9g})"

    def gates_at(self, place: Place, slack: float) -> list[Gate]:
        x, y = map(float, place)
        return [gate for gate in self.gates if gate.bridge.is_at(x, y, slack)]

    def cut_off_at(self, hole: int, elder: int, slack: float) -> tuple[float, float] | None:
        """Find the place, in doubles, where a hole separates from another: at a gate into the hole
        on a way through the fewest doors from the other hole; first by x, then by y. Gates with
        nothing farther away between them are one door."""
        doors = self._doors()
        allowed = self._doors_to(hole, elder, doors)
        places = [
            place
            for gate, door in zip(self.gates, doors, strict=True)
            if door in allowed
            for place in self._places_into(gate, hole)
        ]
        if not places:
            return None
        first = min(x for x, _ in places)
        return min((place for place in places if place[0] <= first + slack), key=lambda p: p[1])

    def _doors(self) -> list[int]:
        joined = Joined(len(self.gates))
        for k, gate in enumerate(self.gates):
            for j, other in enumerate(self.gates[:k]):
                shared = {gate.left, gate.right} & {other.left, other.right}
                if shared - self._hole_of.keys():
                    joined.join(j, k)
        return [joined.root(k) for k in range(len(self.gates))]

    def _behind(self, doors: Sequence[int], door: int) -> set[int]:
        sides = {
            side for k, gate in enumerate(self.gates) if doors[k] == door
            for side in (gate.left, gate.right)
        }  # fmt: skip
        return {self._hole_of[side] for side in sides if side in self._hole_of}

    def _doors_to(self, hole: int, elder: int, doors: Sequence[int]) -> set[int]:
        """Find the last doors on the shortest ways to a hole."""
        passed: set[int] = set()
        known, here = {elder}, {elder}
        while here:
            opened = {d for d in set(doors) - passed if self._behind(doors, d) & here}
            if hole in set().union(*(self._behind(doors, d) for d in opened)) - known:
                return {d for d in opened if hole in self._behind(doors, d)}
            passed |= opened
            here = set().union(*(self._behind(doors, d) for d in opened)) - known
            known |= here
        return set()

    def _places_into(self, gate: Gate, hole: int) -> Iterator[tuple[float, float]]:
        """Yield a bridge's middle, or the ends of its flat ridge on the hole's side."""
        a, b = (tuple(map(float, p)) for p in (gate.bridge.a, gate.bridge.b))
        for place in gate.bridge.ends:
            across = (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0])
            sides = [gate.left, gate.right]
            if gate.bridge.flat is not None:
                sides = [gate.left if across > 0 else gate.right]
            if any(self._hole_of.get(side) == hole for side in sides):
                yield place
