"""Predicates that vanish where edges of the convolution start or stop meeting."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from minkref import _core
from minkref.certify.case_text import ring_numbers
from minkref.certify.plane.predicate import Point, Predicate, Vertices

Edge = tuple[str, int, int, int, int, int]  # as _core.reduced_convolution has it
Ends = tuple[Point, Point]


def coincidences(
    P: _core.PolygonSet, Q: _core.PolygonSet, vertices: Vertices, scale: Fraction
) -> list[Predicate]:
    """One or more for each pair, parallel and triple event at the scale: an end of an edge on the
    line of another, three lines in a point. Exact; costs as `_core.ArrangementEvents`."""
    rings = ring_numbers(P), ring_numbers(Q)
    text = str(scale)
    events = _core.ArrangementEvents(P, Q, text, text)
    edges = [ends_of(edge, rings) for edge in events.edges()]
    found: dict[Predicate, None] = {}
    for _, kind, _, members, at, _ in events.rows(events.of_kind("arrangement")):
        involved = [edges[member] for member in members]
        place = Fraction(at[0]), Fraction(at[1])
        if kind == "triple":
            found[_three_lines(involved)] = None
        else:
            found.update(dict.fromkeys(_ends_on_lines(involved, vertices, scale, place)))
    return list(found)


def _three_lines(edges: Sequence[Ends]) -> Predicate:
    return ("concurrent", tuple(edges[:3]))


def _ends_on_lines(
    edges: Sequence[Ends], vertices: Vertices, scale: Fraction, place: tuple[Fraction, Fraction]
) -> Iterator[Predicate]:
    """Yields predicates for an end at the meeting point of two edges, on the other edge's line. If
    the end stays on the line at all scales, two ends meet, seen from a third point off that
    line."""
    first, second = edges
    for edge, other in ((first, second), (second, first)):
        for end in edge:
            if vertices.at(end, scale) != place:
                continue
            on_line: Predicate = ("orientation", (end, *other))
            if vertices.sign_between(on_line, scale, scale + 1) != 0:
                yield on_line
                continue
            for there in other:
                if there != end and vertices.at(there, scale) == place:
                    yield from _meeting(end, there, vertices, scale)


def _meeting(end: Point, there: Point, vertices: Vertices, scale: Fraction) -> Iterator[Predicate]:
    others = [
        *((None, i) for i in range(len(vertices.Q))),
        *((i, 0) for i in range(len(vertices.P))),
    ]
    for other in others:
        seen: Predicate = ("orientation", (end, there, other))
        if vertices.sign_between(seen, scale, scale + 1) != 0:
            yield seen
            return


def ends_of(edge: Edge, rings: tuple[Sequence[range], Sequence[range]]) -> Ends:
    """Returns the points s p + q at an edge's ends; `rings`: each ring's vertex numbers, in P and
    Q."""
    kind, _, edge_ring, start, vertex_ring, vertex = edge
    of_edge, of_vertex = rings if kind == "S" else rings[::-1]
    ring, j = of_edge[edge_ring], of_vertex[vertex_ring][vertex]
    ends = ring[start], ring[(start + 1) % len(ring)]
    a, b = ((i, j) if kind == "S" else (j, i) for i in ends)
    return a, b
