"""The alpha-shape: the set and its tiles, hulls of the nearest points of places up to a radius."""

from __future__ import annotations

from fractions import Fraction

from .chord import Chord, chord_of
from .levels import Levels, Sets
from .number import Number, number, order
from .outline import cross


def shape_counts(levels: Levels, square: Fraction) -> tuple[int, int]:
    """Components and holes of P with all chords up to a squared radius. Tiles count as cells: a
    polygon and its sides for each place, a chord for each saddle, the sweep of each part. Euler's
    formula then gives holes."""
    graph = levels.graph
    last = levels.below(square)
    while last + 1 < levels.infinity and order(levels.squares[last + 1], number(square)) <= 0:
        last += 1
    sites = graph.outline.sites
    names = {site.part for site in sites}
    if not names:  # a point or a segment
        return 1, 0
    sets = Sets(max(names) + 1)
    euler = len(names) - graph.outline.holes
    for place, level in zip(graph.places, levels.of_place, strict=True):
        if level <= last:
            k = len(place.feet)
            euler += 1 - k
            for site in place.sites:
                sets.join(sites[min(place.sites)].part, sites[site].part)
    for part in graph.parts:
        if levels.level(part.low) <= last:
            sets.join(*(sites[k].part for k in part.pair))
            euler += levels.level(part.high) <= last
    components = len(sets.groups(names))
    return components, components - euler


def doubled_area(levels: Levels) -> Number:
    """Twice the area of all tiles; by the laws of chords, of hull and holes without the set."""
    total = number(0)
    for place in levels.graph.places:
        feet = [chord_of(levels, (foot.left, foot.left), place)[0] for foot in place.feet]
        for (ax, ay), (bx, by) in zip(feet, [*feet[1:], feet[0]], strict=True):
            total = total + (ax - place.x) * (by - place.y) - (ay - place.y) * (bx - place.x)
    for part in levels.graph.parts:
        if part.high[0] == "place":
            places = levels.graph.places
            high = chord_of(levels, part.pair, places[part.high[1]])
            if part.low[0] == "place":
                low = chord_of(levels, part.pair, places[part.low[1]])
            else:
                x, y = levels.graph.outline.wedges[part.low[1]].at
                low = ((number(x), number(y)),) * 2
            total = total + _between(low, high)
    return total


def _between(a: Chord, b: Chord) -> Number:
    """Twice the area swept by a chord between two positions."""
    (p, q), (u, v) = a, b
    twice = (v[0] - p[0]) * (u[1] - q[1]) - (v[1] - p[1]) * (u[0] - q[0])
    return twice if twice.sign() >= 0 else -twice


def doubled_room(levels: Levels) -> Fraction:
    """Twice the area of the hull, and of the holes, without the set's."""
    outline = levels.graph.outline
    corners = {corner.at for corner in outline.corners}
    total = sum((cross(p.at, q.at) for p, q in outline.gaps), Fraction(0))
    for edge in outline.edges:
        total -= cross(edge.a, edge.b)
        if all(edge.over(p) <= 0 for p in corners):
            total += cross(edge.a, edge.b)
    return total
