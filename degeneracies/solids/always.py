"""Facets and edges that are parallel, coplanar or collinear at every scale."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from minkref.degeneracies.solids.draft import Probe, SolidDraft, SolidFacts, SolidFamily
from minkref.degeneracies.solids.placing import placed, swapped
from minkref.degeneracies.solids.proofs import (
    coplanar,
    face_and_edge,
    of_both,
    one_line,
    parallel_edges,
)
from minkref.degeneracies.solids.ties import Tie
from minkref.degeneracies.space.vectors import vector
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.generators import machined
from minkref.fuzz.space.generators.any_solid import walls
from minkref.fuzz.space.hull import convex_hull


def box(dice: Random, most: int = 3) -> Polyhedron:
    return machined.plate(*(dice.randint(1, most) for _ in range(3)))


def profile(dice: Random) -> Polyhedron:
    """With right angles, and not convex."""
    kind = dice.randrange(4)
    if kind == 0:
        return machined.l_solid(dice, 4)
    if kind == 1:
        return machined.u_solid(dice, dice.randint(1, 3), 2)
    if kind == 2:
        return machined.square_ring(dice.randint(1, 2), dice.randint(1, 2), walls(dice, 2), 2)
    return machined.cup(dice.randint(1, 2), dice.randint(1, 2), 2, walls(dice, 2), 1)


def _coplanar(dice: Random, size: int) -> SolidDraft:
    other = profile(dice) if dice.random() < 0.5 else box(dice)
    return placed(dice, swapped(dice, SolidDraft(profile(dice), other)))


def _edge_along_facet(dice: Random, size: int) -> SolidDraft:
    """An upright edge and walls; or a body with faces in any direction, along one of its faces."""
    if dice.random() < 0.5:
        prism = machined.dented_prism(dice, dice.randint(5, 7), 5)
        return placed(dice, swapped(dice, SolidDraft(prism, box(dice))))
    body, roof = profile(dice), _roof(dice)
    return placed(dice, swapped(dice, SolidDraft(body, roof)))


def _roof(dice: Random) -> Polyhedron:
    """A wedge with a level ridge."""
    a, b, c = (dice.randint(1, 4) for _ in range(3))
    ridge = ((dice.randint(0, 1), b, c), (a + 1, b, c))
    base = ((0, 0, 0), (a + 2, 0, 0), (0, 2 * b + 1, 0), (a + 2, 2 * b, 0))
    return convex_hull(vector(*point) for point in (*base, *ridge))


def _parallel_edges(dice: Random, size: int) -> SolidDraft:
    """Prisms over different polygons along one direction; or ridges."""
    P = machined.dented_prism(dice, dice.randint(5, 7), 5)
    Q = _roof(dice) if dice.random() < 0.3 else machined.dented_prism(dice, 6, 4)
    return placed(dice, SolidDraft(P, Q))


def _on_one_base(dice: Random, size: int) -> SolidDraft:
    """Two gears, or a gear and a bracket with bores, with their lids level."""
    teeth = max(3, min(size // 8, 40))
    P = machined.gear(dice, teeth, 10, dice.randint(1, 3))
    if dice.random() < 0.5:
        Q = machined.gear(dice, 3, 10, dice.randint(1, 3))
    else:
        Q = machined.bracket(dice, 1, 3)
    return placed(dice, SolidDraft(P, Q))


def _tent(dice: Random, start: int, end: int) -> Polyhedron:
    """A ridge from (start, 0, 0) to (end, 0, 0), with the body below."""
    wide, deep = dice.randint(1, 4), dice.randint(1, 4)
    points = ((x, y, z) for x in (start, end) for y, z in ((0, 0), (-wide, -deep), (wide, -deep)))
    return convex_hull(vector(*point) for point in points)


def _one_line(dice: Random, size: int) -> SolidDraft:
    """Two or three tents in a row, with different slopes and their ridges on one line."""
    length, gap = dice.randint(1, 3), dice.randint(1, 2)
    tents = _tent(dice, 0, length)
    for k in range(1, dice.randint(2, 3)):
        start = k * (length + gap)
        tents = tents.with_faces_of(_tent(dice, start, start + length))
    wide, high = dice.randint(1, 3), dice.randint(1, 3)
    bar = machined.plate(gap + 1, wide, high)
    # The first tent's ridge, when moved, reaches past the start of the second tent's ridge.
    probe = Probe(vector(Fraction(2 * gap + 1, 2), wide, high), vector(length, 0, 0))
    return placed(dice, swapped(dice, SolidDraft(bar, tents, probes=(probe,))))


def _three_in_one_plane(facts: SolidFacts) -> list[Tie]:
    return coplanar(facts, 3, lambda group: True)


FAMILIES = (
    SolidFamily(
        "solids-coplanar-facets",
        "facets of both bodies in one plane of the convolution, at all scales",
        _coplanar,
        lambda facts: coplanar(facts, 2, of_both),
    ),
    SolidFamily(
        "solids-edge-along-facet",
        "a facet of one body along an edge of the other, at least one of them not convex",
        _edge_along_facet,
        face_and_edge,
    ),
    SolidFamily(
        "solids-parallel-edges",
        "parallel convex edges of both bodies, whose facet has no area",
        _parallel_edges,
        parallel_edges,
    ),
    SolidFamily(
        "solids-on-one-base",
        "three facets of the convolution or more in one plane at all scales: gears and brackets",
        _on_one_base,
        _three_in_one_plane,
    ),
    SolidFamily(
        "solids-one-line",
        "three facets or more through one line at all scales: ridges in a row",
        _one_line,
        one_line,
    ),
)
