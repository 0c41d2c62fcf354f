"""Proofs that a pair belongs to a family: searches among the facets of its convolution."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from itertools import combinations, product

from minkref.degeneracies.solids.convolution import ConvolutionFacet
from minkref.degeneracies.solids.draft import Probe, SolidFacts
from minkref.degeneracies.solids.mesh import Mesh, SolidEdge
from minkref.degeneracies.solids.overlaps import has_point, overlapping, share_area
from minkref.degeneracies.solids.ties import Tie
from minkref.degeneracies.space.vectors import direction
from minkref.fuzz.geometry.space import Point, Whole, cross, dot
from minkref.fuzz.space.meeting import Contact

Proof = Callable[[SolidFacts], list[Tie]]
FILLS: tuple[list[Contact], ...] = (  # at the scale, at the two below, and at the two above
    ["touch", "empty", "empty", "overlap", "overlap"],
    ["touch", "overlap", "overlap", "empty", "empty"],
)


def faces_alone(facts: SolidFacts) -> list[ConvolutionFacet]:
    """The facets made from a face of one body and a vertex of the other."""
    return [f for f in facts.convolution.facets if 1 in (len(f.P), len(f.Q))]


def coplanar(
    facts: SolidFacts, least: int, wanted: Callable[[list[ConvolutionFacet]], bool]
) -> list[Tie]:
    """Facets in one plane at all scales, at least so many, that overlap at the scale."""
    groups = defaultdict(list)
    for facet in faces_alone(facts):
        groups[facet.key].append(facet)
    found = []
    for group in groups.values():
        if len(group) >= least and wanted(group):
            chosen = overlapping(facts.convolution, group, facts.scale, least)
            if chosen and wanted(chosen):
                found.append(Tie("coplanar", tuple(f.feature for f in chosen)))
    return found


def of_both(group: list[ConvolutionFacet]) -> bool:
    """Whether the group has a face of P, and a face of Q."""
    return any(len(f.P) > 2 for f in group) and any(len(f.Q) > 2 for f in group)


def facing(facts: SolidFacts) -> Iterator[tuple[ConvolutionFacet, ConvolutionFacet]]:
    """Yields pairs of facets with opposite normals that are coplanar at this scale only."""
    at = defaultdict(list)
    for facet in faces_alone(facts):
        at[facet.normal, facet.offset(facts.scale)].append(facet)
    for (n, offset), group in sorted(at.items()):
        if n > (0, 0, 0):
            for one, other in product(group, at.get(((-n[0], -n[1], -n[2]), -offset), ())):
                if one.level[0] + other.level[0]:
                    yield one, other


def facing_with_area(facts: SolidFacts) -> list[Tie]:
    found = []
    for one, other in facing(facts):
        if share_area(facts.convolution, one, other, facts.scale):
            found.append(Tie("facing", (one.feature, other.feature)))
    return found


def facing_at(facts: SolidFacts, x: Point) -> list[Tie]:
    """Returns one tie for each plane through x in which two facets that hold x face each other."""
    found: dict[Whole, Tie] = {}
    for one, other in facing(facts):
        if one.normal not in found and all(
            f.is_level_with(x, facts.scale) and has_point(facts.convolution, f, x, facts.scale)
            for f in (one, other)
        ):
            found[one.normal] = Tie("facing", (one.feature, other.feature))
    return list(found.values())


def fills(facts: SolidFacts, planes: int, with_area: bool) -> list[Tie]:
    """Proves that around the first probe facets face each other in so many planes at the scale,
    with a common area or without; and that a gap exists on only one side of the scale."""
    first = facts.probes[0]
    if facts.contacts(first) not in FILLS:
        return []
    shown = facing_at(facts, first.at(facts.scale))
    if len(shown) != planes or (with_area and not facing_with_area(facts)):
        return []
    return shown


def face_and_edge(facts: SolidFacts) -> list[Tie]:
    """A face of one body along a convex edge of the other, which lies highest along the face's
    normal: two adjacent facets in one plane."""
    found = []
    strict = {facet.feature for facet in facts.convolution.facets}
    for name, faces, edges in (
        ("facet-and-edge", facts.P, facts.Q),
        ("edge-and-facet", facts.Q, facts.P),
    ):
        for (face, n), edge in product(
            zip(faces.given.faces, faces.normals, strict=True), edges_of(edges)
        ):
            if dot(n, edge.along) or not edge.is_convex:
                continue
            swap = name == "edge-and-facet"
            ends = [((v,), face) if swap else (face, (v,)) for v in edge.ends]
            if all(end in strict for end in ends):
                found.append(Tie(name, ((edge.ends, face) if swap else (face, edge.ends),)))
    return found


def edges_of(mesh: Mesh) -> list[SolidEdge]:
    """The segment itself, of a segment."""
    points = mesh.given.vertices
    if not mesh.given.is_thin:
        return mesh.edges
    if len(points) == 1:
        return []
    along = direction(b - a for a, b in zip(*points, strict=True))
    return [SolidEdge((0, 1), along, -1, -1, True)]


def parallel_edges(facts: SolidFacts) -> list[Tie]:
    """Parallel convex edges whose arcs on the Gaussian map overlap: their possible facet has no
    area."""
    P, Q = facts.P, facts.Q
    found = []
    for e, f in product(P.edges, Q.edges):
        if e.is_convex and f.is_convex and cross(e.along, f.along) == (0, 0, 0):
            arcs = _arc(P, e), _arc(Q, f)
            ends = [n for arc in arcs for n in arc]
            middles = [(a[0] + b[0], a[1] + b[1], a[2] + b[2]) for a, b in combinations(ends, 2)]
            if any(all(_between(arc, n) for arc in arcs) for n in middles):
                found.append(Tie("parallel-edges", ((e.ends, f.ends),)))
    return found


def _arc(mesh: Mesh, edge: SolidEdge) -> tuple[Whole, Whole]:
    return mesh.normals[edge.left], mesh.normals[edge.right]


def _between(arc: tuple[Whole, Whole], n: Whole) -> bool:
    """Whether a vector in the plane of an arc, shorter than half a turn, lies strictly inside."""
    first, last = arc
    across = cross(first, last)
    return dot(across, cross(first, n)) > 0 and dot(across, cross(n, last)) > 0


def one_line(facts: SolidFacts) -> list[Tie]:
    """Three or more planes of facets through one line at all scales, and through the first probe at
    the scale, where each facet holds the probe; the facets do not all share one side."""
    x, s = facts.probes[0].at(facts.scale), facts.scale
    here: dict[tuple[object, ...], ConvolutionFacet] = {}
    for facet in facts.convolution.facets:
        if facet.is_level_with(x, s) and has_point(facts.convolution, facet, x, s):
            here.setdefault(facet.key, facet)
    lines: dict[tuple[object, ...], dict[object, ConvolutionFacet]] = defaultdict(dict)
    for one, other in combinations(here.values(), 2):
        if any(cross(one.normal, other.normal)):
            line = lines[_line(one, other)]
            line[one.key], line[other.key] = one, other
    return [
        Tie("one-line", tuple(f.feature for f in line.values()))
        for line in lines.values()
        if len(line) > 2 and not _one_side(line.values())
    ]


def _line(one: ConvolutionFacet, other: ConvolutionFacet) -> tuple[object, ...]:
    """The line common to two planes: its direction, and its moment, a polynomial in the scale."""
    across = cross(one.normal, other.normal)
    along = max(direction(across), direction((-across[0], -across[1], -across[2])))
    k = next(k for k in range(3) if across[k])
    unit = Fraction(along[k], across[k])
    moments = tuple(
        unit * (a * other.level[power] - b * one.level[power])
        for power in (0, 1)
        for a, b in zip(one.normal, other.normal, strict=True)
    )
    return along, moments


def _one_side(facets: Iterable[ConvolutionFacet]) -> bool:
    return bool(set.intersection(*(set(sides_of(f)) for f in facets)))


def sides_of(facet: ConvolutionFacet) -> list[tuple[tuple[int, ...], tuple[int, ...]]]:
    """A facet's sides: an edge of one body, its lesser end first, at a vertex of the other."""
    if len(facet.Q) == 1:
        return [(edge, facet.Q) for edge in _ring(facet.P)]
    if len(facet.P) == 1:
        return [(facet.P, edge) for edge in _ring(facet.Q)]
    return [(facet.P, (q,)) for q in facet.Q] + [((p,), facet.Q) for p in facet.P]


def _ring(face: tuple[int, ...]) -> list[tuple[int, int]]:
    return [(min(a, b), max(a, b)) for a, b in zip(face, (*face[1:], face[0]), strict=True)]


def contacts_at(facts: SolidFacts, probes: Iterable[Probe]) -> list[Contact]:
    """At the scale itself, one for each probe."""
    return [facts.contacts(probe)[0] for probe in probes]
