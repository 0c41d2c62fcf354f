"""The history of holes and components, by bridges and chambers: as the radius shrinks, ever shorter
bridges join chambers; as the radius grows, ever longer bridges join polygons."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import groupby
from math import sqrt
from typing import Any

from .boundary import Boundary
from .bridges import Bridge, bridges
from .chambers import Chambers
from .event import NEAR, Found
from .joined import Joined
from .largest import holds_more
from .meeting import Gate, Meeting
from .surd import Surd, order, surd

Row = tuple[Mapping[str, Any], Found]


def history_faults(boundary: Boundary, rows: Sequence[Row]) -> list[str]:
    """Find faults in `rows`: all changes listed by `minkref events P disc --kind topology`, each
    with its event from event_faults. Exact, except that doubles decide whether a chamber without a
    listed end has room for a hole. O(n^3) for n edges."""
    across = sorted(bridges(boundary), key=lambda bridge: bridge.square)
    holes = _Holes(boundary, across, rows)
    return [*holes.faults(), *_join_faults(boundary, across, rows)]


def told(row: Mapping[str, Any]) -> str:
    x, y = row["place"]
    return f"{row['kind']} at ({x:.9g}, {y:.9g}), radius {row['radius']['low']:.9g}"


class _Holes:
    def __init__(self, boundary: Boundary, across: Sequence[Bridge], rows: Sequence[Row]) -> None:
        self._boundary, self._across, self._rows = boundary, across, rows
        self._chambers = Chambers(boundary, across)
        self._parts = Joined(len(self._chambers.faces))
        self._hole_of: dict[int, int] = {}  # of a part, by root; 0 for the outside
        self._ends: dict[int, Row] = {}
        self._births: dict[int, tuple[Row, int]] = {}  # and the hole from which each hole splits
        self._known: set[int] = set()  # holes whose ends were found

    def faults(self) -> Iterator[str]:
        yield from self._read()
        yield from self._place_ends()
        yield from self._look_into_empty_chambers()
        for square, group in groupby(reversed(self._across), key=lambda bridge: bridge.square):
            yield from self._pass(square, list(group))
        for hole, (row, _) in self._births.items():
            yield f"{told(row[0])}: hole {hole} is not born there"
        for hole in self._ends.keys() - set(self._hole_of.values()) - self._known:
            yield f"hole {hole} is none"

    def _read(self) -> Iterator[str]:
        for row in self._rows:
            changes = row[0]["changes"]
            for hole in changes["ended"]:
                if hole in self._ends:
                    yield f"{told(row[0])}: hole {hole} ended before"
                self._ends[hole] = row
            for each in changes["born"]:
                if each["hole"] in self._births:
                    yield f"{told(row[0])}: hole {each['hole']} is born twice"
                self._births[each["hole"]] = row, each["of"]

    def _place_ends(self) -> Iterator[str]:
        """Place holes that end inside chambers."""
        for face in range(len(self._chambers.faces)):
            if self._chambers.is_outer(face):
                self._hole_of[face] = 0
        for hole, (row, found) in self._ends.items():
            if found.kind != "maximum":
                continue
            faces = [
                face for face in range(len(self._chambers.faces))
                if self._hole_of.get(face) != 0 and self._chambers.holds(face, found.at)
            ]  # fmt: skip
            if len(faces) != 1 or faces[0] in self._hole_of:
                yield f"{told(row)}: hole {hole} ends in no chamber of its own"
                continue
            self._hole_of[faces[0]] = hole
            self._known.add(hole)

    def _look_into_empty_chambers(self) -> Iterator[str]:
        longest: dict[int, Fraction] = {}
        for bridge in self._across:
            for face in self._sides(bridge):
                longest[face] = max(bridge.square, longest.get(face, Fraction(0)))
        for face, ring in enumerate(self._chambers.faces):
            reach = sqrt(float(longest.get(face, 0)))
            if face not in self._hole_of and holds_more(ring, self._chambers.walls(face), reach):
                yield f"a hole ends beyond the radius {reach:.6g} near {ring[0]}, and is not listed"

    def _sides(self, bridge: Bridge) -> tuple[int, int]:
        """Return the chambers to the left and to the right."""
        return (self._chambers.left_of(bridge.a, bridge.b),
                self._chambers.left_of(bridge.b, bridge.a))  # fmt: skip

    def _pass(self, square: Fraction, across: Sequence[Bridge]) -> Iterator[str]:
        """Open all bridges with one length."""
        gates = []
        for bridge in across:
            left, right = (self._parts.root(face) for face in self._sides(bridge))
            gates.append(Gate(bridge, left, right))
        for meeting in Meeting.all_of(gates, self._hole_of):
            if not meeting.holes:
                hole = yield from self._flat_end(square, meeting)
            else:
                hole = yield from self._split(meeting)
            for gate in meeting.gates:
                self._parts.join(gate.left, gate.right)
            root = self._parts.root(meeting.gates[0].left)
            for part in meeting.parts:
                self._hole_of.pop(part, None)
            if hole is not None:
                self._hole_of[root] = hole

    def _flat_end(self, square: Fraction, meeting: Meeting) -> Generator[str, None, int | None]:
        """End a hole at a flat ridge: nothing around the meeting lies farther away."""
        here = [
            hole for hole, (_, found) in self._ends.items()
            if hole not in self._known and found.square.rational == square
            and meeting.gates_at(found.at, self._slack(found))
        ]  # fmt: skip
        if len(here) != 1:
            yield f"{len(here)} holes end at the flat ridge at {meeting.where}, and one does"
            return None
        self._known.add(here[0])
        return here[0]

    def _slack(self, found: Found) -> float:
        return NEAR * max(1.0, *(abs(float(c)) for c in found.at))

    def _end(self, hole: int) -> Surd | None:
        return None if hole == 0 else self._ends[hole][1].square

    def _split(self, meeting: Meeting) -> Generator[str, None, int | None]:
        """Check births: each hole here, except the last to end, leaves the hole that ends last."""
        if len(meeting.holes) == 1:
            return next(iter(meeting.holes))
        square = meeting.gates[0].bridge.square
        here = [hole for hole in meeting.holes if not self._is_born_at(hole, square)]
        if len(here) != 1:
            told_of = f"of the holes {sorted(meeting.holes)} at {meeting.where}"
            yield f"{told_of} {len(here)} go on, and one does"
            return here[0] if here else None
        elder = here[0]
        for hole in meeting.holes:
            if hole == elder:
                continue
            (row, found), of = self._births.pop(hole)
            if of != elder or self._is_later(hole, elder):
                yield f"{told(row)}: hole {hole} leaves hole {elder}, not {of}"
            slack = self._slack(found)
            wanted = meeting.cut_off_at(hole, elder, slack)
            if (
                wanted is None
                or max(abs(float(c) - w) for c, w in zip(found.at, wanted, strict=True)) > slack
            ):
                yield f"{told(row)}: hole {hole} is not cut off there, but at {wanted}"
        return elder

    def _is_born_at(self, hole: int, square: Fraction) -> bool:
        return hole in self._births and self._births[hole][0][1].square.rational == square

    def _is_later(self, hole: int, elder: int) -> bool:
        end, own = self._end(elder), self._end(hole)
        return own is None or (end is not None and order(own, end) > 0)


def _join_faults(
    boundary: Boundary, across: Sequence[Bridge], rows: Sequence[Row]
) -> Iterator[str]:
    joined = Joined(boundary.polygons)
    of_point: dict[Any, list[int]] = {}
    points = {p for bridge in across for p in (bridge.a, bridge.b)} | set(boundary.vertices)
    for p in points:
        place = surd(p[0]), surd(p[1])
        at = [e.polygon for e in boundary.edges if e.rounded_distance(*map(float, p)) < 1e-6
              and _is_on(e, place)]  # fmt: skip
        of_point[p] = at
        for polygon in at:
            joined.join(at[0], polygon)  # they touch
    pending = [row for row in rows if row[0]["changes"]["joined"]]
    for square, group in groupby(across, key=lambda bridge: bridge.square):
        gates = list(group)
        before = {k: joined.root(k) for k in range(boundary.polygons)}
        wanted = Joined(boundary.polygons)
        for k, root in before.items():
            wanted.join(k, root)
        rank = sum(wanted.join(of_point[g.a][0], of_point[g.b][0]) for g in gates)
        here = [row for row in pending if row[1].square.rational == square]
        pending = [row for row in pending if row not in here]
        for row, found in here:
            x, y = map(float, found.at)
            slack = NEAR * max(1.0, abs(x), abs(y))
            ends = [
                {before[of_point[g.a][0]], before[of_point[g.b][0]]}
                for g in gates if g.is_at(x, y, slack)
            ]  # fmt: skip
            for a, b in row["changes"]["joined"]:
                if {before[a], before[b]} not in ends or not joined.join(a, b):
                    yield f"{told(row)}: polygons {a} and {b} do not join there"
                rank -= 1
        if rank:
            yield f"{rank} more components join at the squared radius {square}"
        for g in gates:
            joined.join(of_point[g.a][0], of_point[g.b][0])
    for row, _ in pending:
        yield f"{told(row)}: no components join there"


def _is_on(edge: Any, place: Any) -> bool:
    (ax, ay), (dx, dy) = edge.a, edge.along
    vx, vy = place[0].a - ax, place[1].a - ay
    return bool(vx * dy == vy * dx and 0 <= vx * dx + vy * dy <= edge.squared_length)
