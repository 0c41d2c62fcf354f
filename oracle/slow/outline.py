"""The exact union of the convex sums: boundary edges, and interior points that no open convex sum
covers.

On each line, cut the closed intervals of edges by the open intervals inside convex sums. The rest
belongs to the boundary where edges run one way, and to a tight segment where edges run both ways,
since then both sides are covered. Take a point on an edge that no open sum covers, between two
stretches that open sums cover: it makes a tight point unless the boundary or a tight segment
contains it.

Proof that this finds all: consider a point covered by the union but by no open sum. It lies on the
boundary of each convex sum that contains it, and for one such sum on an edge that comes from a
boundary edge of P or Q (README.md, "Why inner diagonals may be left out").
"""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import combinations

from .cover import Cover, Line, Place
from .exact import cross, dot
from .germ import Number
from .plane import Edge, Node, Plane


@dataclass
class Outline:
    """Boundary edges with the sum to their left, cut at all nodes; tight segments and points.
    `slits` holds each tight segment once, in one direction, cut at boundary nodes and at other
    tight segments."""

    plane: Plane = field(default_factory=Plane)
    edges: list[Edge] = field(default_factory=list)
    slits: list[Edge] = field(default_factory=list)
    points: list[Node] = field(default_factory=list)


def outline(cover: Cover) -> Outline:
    """Find the outline. Cost: as `Cover.lines`, plus edges times nodes of the result."""
    result = Outline()
    alone: set[Node] = set()
    # Denominators of points are cross(f, d) dot(d, d) < 4 longest^4: see germ.py for the shift.
    shift = 2 * (4 * cover.frame.longest**4).bit_length()
    for line in cover.lines():
        forward, backward, tight, points = stretches(line)
        for sign, parts, into in (
            (1, forward, result.edges),
            (-1, backward, result.edges),
            (1, tight, result.slits),
        ):
            for a, b in parts:
                start, end = (node(result.plane, line, place, shift) for place in (a, b))
                edge = Edge(start, end, line.d, line.offset)
                into.append(edge if sign > 0 else edge.reversed())
        for place in points:
            alone.add(node(result.plane, line, place, shift))
    result.edges = result.plane.split(result.edges)
    on_boundary = {edge.start for edge in result.edges}
    crossings = slit_crossings(result.plane, result.slits, shift)
    result.slits = result.plane.cut(result.slits, on_boundary | crossings)
    on_slits = {end for edge in result.slits for end in (edge.start, edge.end)}
    for point in sorted(alone - on_boundary - on_slits):
        if cover.in_passage(*result.plane.points[point]):
            continue
        if not any(result.plane.contains(edge, point) for edge in result.slits + result.edges):
            result.points.append(point)
    return result


def node(plane: Plane, line: Line, place: Place, shift: int) -> Node:
    (dx, dy), offset = line.d, line.offset
    _, u, den = place
    x = u * dx - offset * (dy * den)
    y = u * dy + offset * (dx * den)
    den *= dot(line.d, line.d)
    key = ((x << shift) // den, (y << shift) // den)
    plane.points.setdefault(key, (x, y, den))
    return key


def slit_crossings(plane: Plane, slits: list[Edge], shift: int) -> set[Node]:
    """Make and return the nodes where two tight segments cross, unknown to both lines."""
    found = set()
    for a, b in combinations(slits, 2):
        turn = cross(a.d, b.d)
        if turn == 0:
            continue
        x = a.offset * b.d[0] - b.offset * a.d[0]
        y = a.offset * b.d[1] - b.offset * a.d[1]
        if turn < 0:
            x, y, turn = -x, -y, -turn
        key = ((x << shift) // turn, (y << shift) // turn)
        if all(min(e.start, e.end) < key < max(e.start, e.end) for e in (a, b)):
            plane.points.setdefault(key, (x, y, turn))
            found.add(key)
    return found


Stretch = tuple[Place, Place]


def stretches(line: Line) -> tuple[list[Stretch], list[Stretch], list[Stretch], list[Place]]:
    """Return the line's boundary along d and against d, its tight segments, and places covered only
    on both sides."""
    places: dict[Number, Place] = {}
    # Per place: how many intervals along, against and inside begin there, and how many end there.
    begins: dict[Number, list[int]] = {}
    ends: dict[Number, list[int]] = {}
    for kind, intervals in enumerate((line.along, line.against, line.inside)):
        for low, high in intervals:
            for place, count in ((low, begins), (high, ends)):
                key = place[0]
                if key not in places:
                    places[key] = place
                    begins[key] = [0, 0, 0]
                    ends[key] = [0, 0, 0]
                count[key][kind] += 1
    found: tuple[list[Stretch], list[Stretch], list[Stretch]] = ([], [], [])
    alone: list[Place] = []
    along = against = inside = 0
    state = -1  # of the stretch before the place: index of its list, or -1
    since: Place | None = None
    for key in sorted(places):
        place = places[key]
        b, e = begins[key], ends[key]
        had_edge = along > 0 or against > 0
        was_inside = inside > 0
        through = inside - e[2]
        # Three lines may cross where every edge ends, and the boundary go on along each of them.
        pinched = (state == 0 and along == e[0]) or (state == 1 and against == e[1])
        along += b[0] - e[0]
        against += b[1] - e[1]
        inside += b[2] - e[2]
        has_edge = along > 0 or against > 0 or had_edge
        if was_inside and inside > 0 and through == 0 and has_edge:
            alone.append(place)
        if inside > 0:
            now = -1
        elif along > 0:
            now = 2 if against > 0 else 0
        else:
            now = 1 if against > 0 else -1
        if now != state or pinched:
            if state >= 0 and since is not None:
                found[state].append((since, place))
            state, since = now, place
    return found[0], found[1], found[2], alone
