"""A single ring: closing, spikes, direction."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from minkref.repair.change import Change
from minkref.repair.weld import squared_distance

Point = tuple[Fraction, Fraction]


@dataclass
class Ring:
    """Points with their numbers in the file. `number`: the ring's number, None for a ring made
    by the repair; `lines`: line of each point in the file, if known."""

    number: int | None
    points: list[Point]
    is_open: bool = False
    lines: list[int] = field(default_factory=list)
    indices: list[int] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.indices = self.indices or list(range(len(self.points)))

    def change(self, kind: str, index: int | None = None, **sizes: Any) -> Change:
        """A change at the ring, or at the vertex with this number in the file."""
        if self.number is None:
            return Change(kind, **sizes)
        at = index or 0
        line = self.lines[at] if at < len(self.lines) and self.lines[at] else None
        return Change(kind, ring=self.number, vertex=index, line=line, **sizes)


Note = Callable[[Change], None]


def doubled_area(points: list[Point]) -> Fraction:
    """Return twice the signed area; the parts of a ring that crosses itself may cancel."""
    following = zip(points, points[1:] + points[:1], strict=True)
    return sum((ax * by - ay * bx for (ax, ay), (bx, by) in following), Fraction(0))


def cleaned(ring: Ring, note: Note) -> Ring | None:
    """Close a ring, drop repeated points and cut off all spikes, points at which a ring turns
    back along an edge; None if fewer than three points remain. Encloses the same.
    Linear."""
    if ring.is_open:
        ends = squared_distance(ring.points[0], ring.points[-1])
        note(ring.change("closed", len(ring.points) - 1, squared_distance=ends))
    kept = _without_spikes(ring, note)
    if len(kept) < 3:
        point = ring.points[0] if ring.points else None
        note(ring.change("no-area", point=point, area=Fraction(0)))
        return None
    return Ring(
        ring.number,
        [ring.points[k] for k in kept],
        lines=ring.lines,
        indices=[ring.indices[k] for k in kept],
    )


def _without_spikes(ring: Ring, note: Note) -> list[int]:
    """Return positions of remaining points, ascending."""
    points, count = ring.points, len(ring.points)
    before = [(k - 1) % count for k in range(count)]
    after = [(k + 1) % count for k in range(count)]
    stays = [True] * count
    left = count
    asked = list(range(count - 1, -1, -1))  # taken from the end
    while asked and left >= 2:
        at = asked.pop()
        if not stays[at]:
            continue
        a, b = before[at], after[at]
        if points[at] == points[b]:
            gone = max(at, b)
            change = ring.change("repeated-point", ring.indices[gone], point=points[gone])
        elif left > 2 and _turns_back(points[a], points[at], points[b]):
            gone = at
            reach = min(
                squared_distance(points[at], points[a]), squared_distance(points[at], points[b])
            )
            change = ring.change(
                "spike", ring.indices[at], point=points[at], squared_distance=reach
            )
        else:
            continue
        note(change)
        stays[gone] = False
        left -= 1
        a, b = before[gone], after[gone]
        after[a], before[b] = b, a
        asked += [b, a]
    return [k for k in range(count) if stays[k]]


def _turns_back(a: Point, at: Point, b: Point) -> bool:
    ux, uy, vx, vy = at[0] - a[0], at[1] - a[1], b[0] - at[0], b[1] - at[1]
    return ux * vy == uy * vx and ux * vx + uy * vy < 0


def run_as(ring: Ring, is_hole: bool, note: Note) -> Ring:
    """Turn a ring as its role demands: holes clockwise, others counter-clockwise."""
    area = doubled_area(ring.points)
    if area == 0 or (area < 0) == is_hole:
        return ring
    note(ring.change("turned", area=abs(area) / 2))
    return Ring(ring.number, ring.points[::-1], lines=ring.lines, indices=ring.indices[::-1])
