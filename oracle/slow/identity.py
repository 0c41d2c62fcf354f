"""Matches holes and components just below a scale with holes and components just above
(docs/definitions.md, "Identity").

At the scale itself the open set falls into parts; each part belongs to one component below and to
one above.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from .plane import Edge
from .samples import place_of, sample
from .state import State
from .walks import Component, components

Change = Literal["same", "touch", "birth", "death", "merge", "split", "merge and split"]


@dataclass(frozen=True)
class Link:
    """Components just below, parts at the scale and components just above that belong together.
    Hole 0 means the outside; components count from 0, in canonical order."""

    below: list[int]
    at: list[int]
    above: list[int]

    @property
    def change(self) -> Change:
        if not self.below:
            return "birth"
        if not self.above:
            return "death"
        if len(self.below) == len(self.above) == 1:
            return "same" if len(self.at) == 1 else "touch"
        if len(self.above) == 1:
            return "merge"
        return "split" if len(self.below) == 1 else "merge and split"


Triple = tuple[int, int, int]  # a sample's indices below, at and above


def linked(triples: list[Triple], counts: Triple) -> list[Link]:
    """Return the connected groups; a component or part without a triple stands alone."""
    groups = [({i}, set[int](), set[int]()) for i in range(counts[0])]
    groups += [(set[int](), {i}, set[int]()) for i in range(counts[1])]
    groups += [(set[int](), set[int](), {i}) for i in range(counts[2])]
    for triple in triples:
        touched = [g for g in groups if any(i in g[k] for k, i in enumerate(triple))]
        groups = [g for g in groups if g not in touched]
        a, b, c = (set[int]().union(*(g[k] for g in touched)) for k in range(3))
        groups.append((a, b, c))
    return sorted(
        (Link(sorted(a), sorted(b), sorted(c)) for a, b, c in groups),
        key=lambda link: (link.below, link.at, link.above),
    )


def hole_links(below: State, at: State, above: State) -> list[Link]:
    """Link holes, with the outside as hole 0."""
    triples: list[Triple] = [(0, 0, 0)]
    for index, part in enumerate(at.complement):
        point = sample(at.outline.plane, part, at.outline.edges, at.side.unit, ())
        i, j = (place_of(side, side.complement, point) for side in (below, above))
        # A part inside no hole belongs to the outside, which no ring surrounds.
        triples.append((0 if i is None else i + 1, index + 1, 0 if j is None else j + 1))
    states = (below, at, above)
    return linked(triples, tuple(len(each.complement) + 1 for each in states))  # type: ignore[arg-type]


def component_links(below: State, at: State, above: State) -> list[Link]:
    """Link the interior's components. Cuts tight segments out first: the regions on both sides may
    be separate just below or above the scale."""
    triples: list[Triple] = []
    parts, edges = sub_parts(at)
    for part in parts:
        point = sample(at.outline.plane, part, edges, at.side.unit, at.outline.points)
        i, k, j = (place_of(side, side.interior, point) for side in (below, at, above))
        assert i is not None and k is not None and j is not None, "the interior lost a sample"
        triples.append((i, k, j))
    states = (below, at, above)
    return linked(triples, tuple(len(each.interior) for each in states))  # type: ignore[arg-type]


def sub_parts(at: State) -> tuple[list[Component], list[Edge]]:
    """Return the interior's components without tight segments, and all edges, cut at all nodes."""
    if not at.outline.slits:
        return at.interior, at.outline.edges
    slits = [way for slit in at.outline.slits for way in (slit, slit.reversed())]
    edges = at.outline.plane.split(at.outline.edges + slits)
    return components(at.outline.plane, edges)[0], edges
