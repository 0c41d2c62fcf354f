"""The boundary rings of a union of convex polygons. A boundary point (x, y, w), whole numbers in
lowest terms, stands for (x / w, y / w)."""

from __future__ import annotations

from fractions import Fraction
from functools import cmp_to_key
from math import gcd

from plain_geometry import Ring

Node = tuple[int, int, int]
Cycle = list[Node]
Stretch = tuple[Node, Node]  # of the boundary; the union lies on its left
Ratio = tuple[int, int]  # numerator and positive denominator
Interval = tuple[Ratio, Ratio]
Covered = list[list[Interval] | None]  # of each edge; None where it is covered wholly
Line = tuple[int, int, int]  # a x + b y + c, positive on the left
WHOLE: Interval = ((0, 1), (1, 1))
BY_BEGINNING = cmp_to_key(
    lambda one, other: one[0][0] * other[0][1] - other[0][0] * one[0][1]  # type: ignore[index]
)


def node(x: int, y: int, w: int) -> Node:
    common = gcd(x, y, w)
    return (x // common, y // common, w // common)


def node_turn(a: Node, b: Node, c: Node) -> int:
    """The sign of the turn, times something positive."""
    bx, by = b[0] * a[2] - a[0] * b[2], b[1] * a[2] - a[1] * b[2]
    cx, cy = c[0] * a[2] - a[0] * c[2], c[1] * a[2] - a[1] * c[2]
    return bx * cy - by * cx


def cycle_area(cycle: Cycle) -> Fraction:
    """Twice the signed area."""
    points = [(Fraction(x, w), Fraction(y, w)) for x, y, w in cycle]
    return sum(
        (p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1], strict=True)),
        Fraction(0),
    )


def lines_of(piece: Ring) -> list[Line]:
    return [
        (p[1] - q[1], q[0] - p[0], (q[1] - p[1]) * p[0] - (q[0] - p[0]) * p[1])
        for p, q in zip(piece, piece[1:] + piece[:1], strict=True)
    ]


def box_of(ring: Ring) -> tuple[int, int, int, int]:
    xs, ys = [p[0] for p in ring], [p[1] for p in ring]
    return (min(xs), min(ys), max(xs), max(ys))


class Union:
    """The stages of the union; each fault replaces a stage."""

    def boundary(self, pieces: list[Ring]) -> list[Stretch]:
        """The edges of all pieces except covered parts."""
        lines = [lines_of(piece) for piece in pieces]
        boxes = [box_of(piece) for piece in pieces]
        found: list[Stretch] = []
        for i, piece in enumerate(pieces):
            x0, y0, x1, y1 = boxes[i]
            covered: Covered | None = [[] for _ in piece]
            for j, (u0, v0, u1, v1) in enumerate(boxes):
                if j != i and u0 <= x1 and x0 <= u1 and v0 <= y1 and y0 <= v1:
                    covered = self.cover(piece, lines[j], j < i, covered)
                    if covered is None:
                        break
            if covered is not None:
                for k, intervals in enumerate(covered):
                    if intervals is None:
                        continue
                    a, b = piece[k], piece[(k + 1) % len(piece)]
                    found += [self.stretch(a, b, *rest) for rest in self.uncovered(intervals)]
        return found

    def cover(
        self, piece: Ring, lines: list[Line], earlier: bool, covered: Covered
    ) -> Covered | None:
        """Adds the part of each edge that another piece covers; None if nothing stays uncovered. If
        edges lie on each other and run the same way, the earlier edge stays."""
        rows: list[tuple[list[int], bool]] = []
        for a, b, c in lines:
            row = [a * x + b * y + c for x, y in piece]
            highest = max(row)
            if highest < 0 or (highest == 0 and row.count(0) < 2):
                return covered
            if highest == 0 or min(row) <= 0:
                rows.append((row, highest == 0))
        if not rows:
            return None
        n = len(piece)
        for k, intervals in enumerate(covered):
            if intervals is not None:
                ends = [(row[k], row[(k + 1) % n], opposite) for row, opposite in rows]
                interval = self.clipped(ends, earlier)
                if interval == WHOLE:
                    covered[k] = None
                elif interval is not None:
                    intervals.append(interval)
        return covered if any(intervals is not None for intervals in covered) else None

    def clipped(self, ends: list[tuple[int, int, bool]], earlier: bool) -> Interval | None:
        """The part of an edge that the lines leave, computed from the lines' values at the edge's
        ends. `opposite` says that the piece lies on the line's other side, so that edges on the
        line run opposite ways."""
        (ln, ld), (hn, hd) = (0, 1), (1, 1)
        for f0, f1, opposite in ends:
            if f0 <= 0 and f1 <= 0:
                if f0 or f1 or not (opposite or earlier):
                    return None
            elif f0 <= 0:
                if -f0 * ld > ln * (f1 - f0):
                    ln, ld = -f0, f1 - f0
            elif f1 <= 0 and f0 * hd < hn * (f0 - f1):
                hn, hd = f0, f0 - f1
        return ((ln, ld), (hn, hd)) if ln * hd < hn * ld else None

    def uncovered(self, intervals: list[Interval]) -> list[Interval]:
        """The uncovered parts of [0, 1]."""
        left: list[Interval] = []
        reached: Ratio = (0, 1)
        for low, high in sorted(intervals, key=BY_BEGINNING):
            if low[0] * reached[1] > reached[0] * low[1]:
                left.append((reached, low))
            if high[0] * reached[1] > reached[0] * high[1]:
                reached = high
        if reached[0] < reached[1]:
            left.append((reached, (1, 1)))
        return left

    def stretch(self, a: tuple[int, int], b: tuple[int, int], low: Ratio, high: Ratio) -> Stretch:
        return (self.place(a, b, low), self.place(a, b, high))

    def place(self, a: tuple[int, int], b: tuple[int, int], at: Ratio) -> Node:
        n, d = at
        return node(a[0] * d + n * (b[0] - a[0]), a[1] * d + n * (b[1] - a[1]), d)

    def cycles(self, stretches: list[Stretch]) -> list[Cycle]:
        """Closed rings without repeated points."""
        following: dict[Node, list[Node]] = {}
        for a, b in stretches:
            following.setdefault(a, []).append(b)
        found: list[Cycle] = []
        for first in list(following):
            while following[first]:
                walk: Cycle = [first]
                place = {first: 0}
                while walk:
                    at = walk[-1]
                    choices = following.get(at)
                    if not choices:
                        self.loose_end()
                        break
                    before = walk[-2] if len(walk) > 1 else None
                    after = choices[0] if len(choices) == 1 else self.choice(before, at, choices)
                    choices.remove(after)
                    if after in place:
                        start = place[after]
                        found.append(walk[start:])
                        for gone in walk[start + 1 :]:
                            del place[gone]
                        del walk[start + 1 :]
                        if start == 0:
                            break
                    else:
                        place[after] = len(walk)
                        walk.append(after)
        return found

    def loose_end(self) -> None:
        raise ValueError("the boundary has a loose end")

    def choice(self, before: Node | None, at: Node, choices: list[Node]) -> Node:
        """The next node clockwise after the way back, so that two edges bound one wedge."""
        if before is None:
            return choices[0]
        best = choices[0]
        for other in choices[1:]:
            if self.clockwise_first(before, at, other, best):
                best = other
        return best

    def clockwise_first(self, back: Node, at: Node, one: Node, other: Node) -> bool:
        """Whether `one` comes before `other`, turning clockwise from `back` about `at`."""
        right_one, right_other = node_turn(at, back, one) < 0, node_turn(at, back, other) < 0
        if right_one != right_other:
            return right_one
        return node_turn(at, one, other) < 0

    def straightened(self, cycle: Cycle) -> Cycle:
        """Removes the nodes at which a cycle does not turn."""
        n = len(cycle)
        return [
            p for k, p in enumerate(cycle) if node_turn(cycle[k - 1], p, cycle[(k + 1) % n]) != 0
        ]
