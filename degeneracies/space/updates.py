"""Sums updated from one scaling to another, where facet errors and edge errors do not come together
(Behar & Lien 2012, Theorem 1)."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from random import Random

from minkref.degeneracies.space.bodies import changed, hull, lattice_point, scattered
from minkref.degeneracies.space.draft import ONE, Coincidence, SpaceDraft, SpaceFacts, SpaceFamily
from minkref.fuzz.geometry.space import Point

Corners = tuple[int, ...]
# Two tetrahedra and a scaling that gives each facet of both another vertex, and keeps all pairs of
# edges.
EXCHANGED = (
    ((1, -5, 5), (-2, -5, 3), (2, 4, 1), (-2, 2, -4)),
    ((5, 4, -2), (-4, -4, -3), (5, -3, 1), (-4, 1, -5)),
)
STRETCHED = 5


@dataclass(frozen=True)
class Pairs:
    """The compatible pairs at a scaling in general position: the vertex of Q for each facet of P,
    the vertex of P for each facet of Q, the pairs of edges."""

    fv: dict[Corners, int]
    vf: dict[Corners, int]
    ee: set[tuple[Corners, Corners]]

    @classmethod
    def at(cls, facts: SpaceFacts, scaling: Point) -> Pairs | None:
        """Returns None if faces meet in a special position."""
        pairs = cls({}, {}, set())
        for p, q in facts.sum(scaling).parents:
            if len(p) > 2 and len(q) == 1:
                pairs.fv[p] = q[0]
            elif len(p) == 1 and len(q) > 2:
                pairs.vf[q] = p[0]
            elif len(p) == len(q) == 2:
                pairs.ee.add((p, q))
            else:
                return None
        return pairs


def _change(facts: SpaceFacts) -> tuple[Pairs, Pairs] | None:
    """Before and after."""
    before, after = Pairs.at(facts, facts.others[0]), Pairs.at(facts, facts.scaling)
    return (before, after) if before and after else None


def _one_kind(dice: Random, size: int) -> SpaceDraft:
    """Two small bodies, and a scaling by some factors from another."""
    P, Q = (scattered(dice, min(6, max(4, size // 4)), 5) for _ in "PQ")
    x, y, z = (Fraction(dice.randint(1, 9)) for _ in range(3))
    return changed(dice, SpaceDraft(P, Q, (x, y, z), dice.randrange(3), (ONE,)))


def _edges_without_facets_of_P(facts: SpaceFacts) -> list[Coincidence]:
    """Pairs of edges disappear, no facet of P gets another vertex, but facets of Q do: the result
    lists these facets, each with its former vertex."""
    change = _change(facts)
    if change is None:
        return []
    before, after = change
    if before.fv != after.fv or before.ee <= after.ee:
        return []
    return [
        Coincidence("compatible", (p,), q) for q, p in sorted(before.vf.items()) if after.vf[q] != p
    ]


def _exchanged(dice: Random, size: int) -> SpaceDraft:
    """The known pair, with slightly moved corners, in other coordinates."""
    grid = dice.choice((1, 4, 7, 12))
    P, Q = (
        hull(
            [
                [grid * c + e for c, e in zip(p, lattice_point(dice, grid // 4), strict=True)]
                for p in points
            ]
        )
        for points in EXCHANGED
    )
    t = Fraction(dice.randint(8 * STRETCHED, 12 * STRETCHED), 10) if grid > 1 else Fraction(5)
    return changed(dice, SpaceDraft(P, Q, (t, t, Fraction(1)), 2, (ONE,)))


def _facets_without_edges(facts: SpaceFacts) -> list[Coincidence]:
    """Each facet of both bodies gets another vertex, and all pairs of edges stay."""
    change = _change(facts)
    if change is None:
        return []
    before, after = change
    stays = any(before.fv[f] == v for f, v in after.fv.items()) or any(
        before.vf[f] == v for f, v in after.vf.items()
    )
    if stays or before.ee != after.ee:
        return []
    shown = [Coincidence("compatible", p, (q,)) for p, q in sorted(before.fv.items())]
    return shown + [Coincidence("compatible", (p,), q) for q, p in sorted(before.vf.items())]


FAMILIES = (
    SpaceFamily(
        "edge-error-without-facet-of-p",
        "a change of scaling that changes pairs of edges and no facet of P, but a facet of Q",
        _one_kind,
        _edges_without_facets_of_P,
    ),
    SpaceFamily(
        "all-facets-change-no-edges",
        "a change of scaling after which all facets have other vertices, and no edges other ones",
        _exchanged,
        _facets_without_edges,
    ),
)
