"""The flags for cases with polyhedra of any shape, a part of the flags for convex bodies: a case's
facts decide each flag. flags.json says what each means."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from minkref.degeneracies.plane.flags import at_limits, far_apart, far_out, is_no_double
from minkref.degeneracies.solids.draft import SolidFacts
from minkref.degeneracies.solids.mesh import Mesh
from minkref.degeneracies.solids.proofs import edges_of, face_and_edge
from minkref.fuzz.geometry.space import Whole


def flags_of_solids(facts: SolidFacts) -> list[str]:
    """All flags that hold, in alphabetical order. Exact."""
    return sorted(name for name, holds in FLAGS_OF_SOLIDS.items() if holds(facts))


def _of_one(holds: Callable[[Mesh], bool]) -> Callable[[SolidFacts], bool]:
    return lambda facts: holds(facts.P) or holds(facts.Q)


def _numbers(facts: SolidFacts) -> Iterator[Fraction]:
    return (c for mesh in (facts.P, facts.Q) for v in mesh.given.vertices for c in v)


def _opposite(facts: SolidFacts) -> bool:
    return any((-x, -y, -z) in facts.Q.normals for x, y, z in facts.P.normals)


def _parallel_edges(facts: SolidFacts) -> bool:
    first, second = ({_upwards(e.along) for e in edges_of(m)} for m in (facts.P, facts.Q))
    return bool(first & second)


def _upwards(way: Whole) -> Whole:
    return max(way, (-way[0], -way[1], -way[2]))


def _has_flat_vertex(mesh: Mesh) -> bool:
    return any(mesh.is_flat(k) for k in range(len(mesh.given.vertices)) if k in mesh.faces_at)


def _has_split_facet(mesh: Mesh) -> bool:
    """Whether two faces at an edge lie in one plane."""
    return any(mesh.normals[e.left] == mesh.normals[e.right] for e in mesh.edges)


def _wound_zero_times(facts: SolidFacts) -> bool:
    return any(
        facts.contacts(probe)[0] == "overlap" and facts.euler(probe) == 0 for probe in facts.probes
    )


FLAGS_OF_SOLIDS: dict[str, Callable[[SolidFacts], bool]] = {
    "facet-along-edge": lambda facts: bool(face_and_edge(facts)),
    "flat-vertices": _of_one(_has_flat_vertex),
    "large-translation": _of_one(
        lambda mesh: len(mesh.given.vertices) > 1 and far_out(mesh.given.vertices)
    ),
    "limits": lambda facts: at_limits(_numbers(facts)),
    "magnitudes": lambda facts: far_apart((*_numbers(facts), facts.scale)),
    "opposite-facets": _opposite,
    "parallel-edges": _parallel_edges,
    "parallel-facets": lambda facts: bool({*facts.P.normals} & {*facts.Q.normals}),
    "scale-is-no-float": lambda facts: is_no_double(facts.scale),
    "split-facets": _of_one(_has_split_facet),
    "winding-zero": _wound_zero_times,
}
