"""Ties between long numbers, and between tiny ones; and thin operands."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from random import Random

from minkref.degeneracies.solids.always import profile
from minkref.degeneracies.solids.convolution import ConvolutionFacet
from minkref.degeneracies.solids.draft import Probe, SolidDraft, SolidFacts, SolidFamily
from minkref.degeneracies.solids.fits import cavity, slot
from minkref.degeneracies.solids.placing import placed, swapped, times, under
from minkref.degeneracies.solids.proofs import face_and_edge, fills
from minkref.degeneracies.solids.ties import Tie
from minkref.degeneracies.space.vectors import vector
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.generators.any_solid import ORIGIN
from minkref.fuzz.space.generators.mapped import Matrix, determinant

BITS = 60
TINY = Fraction(1, 2**180 + 45)


def _entry(dice: Random) -> int:
    """An odd number with BITS bits and either sign."""
    size: int = (1 << (BITS - 1)) + 2 * dice.getrandbits(BITS - 2) + 1
    return size if dice.random() < 0.5 else -size


def _long_matrix(dice: Random) -> Matrix:
    while True:
        a, b, c = ((_entry(dice), _entry(dice), _entry(dice)) for _ in range(3))
        if determinant((a, b, c)):
            return a, b, c


def _fit(dice: Random) -> SolidDraft:
    return slot(dice) if dice.random() < 0.5 else cavity(dice, dice.randint(0, 2))


def _long(dice: Random, size: int) -> SolidDraft:
    """An exact fit under a matrix of long numbers."""
    moved = (vector(_entry(dice), _entry(dice), _entry(dice)) for _ in range(2))
    return under(swapped(dice, _fit(dice)), _long_matrix(dice), *moved)


def _tiny(dice: Random, size: int) -> SolidDraft:
    """The draft of `_long`, divided by a large odd number."""
    draft = _long(dice, size)
    return replace(
        draft,
        P=draft.P.scaled(TINY),
        Q=draft.Q.scaled(TINY),
        probes=tuple(Probe(times(p.p, TINY), times(p.q, TINY)) for p in draft.probes),
    )


def _all_fits(wanted: Callable[[list[Fraction]], bool]) -> Callable[[SolidFacts], list[Tie]]:
    def proof(facts: SolidFacts) -> list[Tie]:
        numbers = [c for mesh in (facts.P, facts.Q) for v in mesh.given.vertices for c in v]
        if not wanted([abs(number) for number in numbers]):
            return []
        return next((found for k in (1, 2, 3) if (found := fills(facts, k, True))), [])

    return proof


def _thin(dice: Random, size: int) -> SolidDraft:
    """A point; or a segment along an edge, or across a face."""
    body = profile(dice)
    if dice.random() < 0.3:
        return placed(dice, swapped(dice, SolidDraft(body, Polyhedron((ORIGIN,), ()))))
    a, b = (body.vertices[k] for k in dice.sample(dice.choice(body.faces), 2))
    end: Point = (b[0] - a[0], b[1] - a[1], b[2] - a[2])
    return placed(dice, swapped(dice, SolidDraft(body, Polyhedron((ORIGIN, end), ()))))


def _along_a_face(facts: SolidFacts) -> list[Tie]:
    """Finds coplanar faces of a body, if the other operand is a point."""
    if 1 in (len(facts.P.given.vertices), len(facts.Q.given.vertices)):
        return _faces_in_one_plane(facts)
    return face_and_edge(facts)


def _faces_in_one_plane(facts: SolidFacts) -> list[Tie]:
    first: dict[object, ConvolutionFacet] = {}
    for facet in facts.convolution.facets:
        other = first.setdefault(facet.key, facet)
        if other is not facet:
            return [Tie("coplanar", (other.feature, facet.feature))]
    return []


FAMILIES = (
    SolidFamily(
        "solids-long-numbers",
        f"an exact fit between coordinates of more than {BITS} bits",
        _long,
        _all_fits(lambda numbers: max(numbers) > 2**BITS),
    ),
    SolidFamily(
        "solids-tiny-numbers",
        "an exact fit between coordinates too small for most tolerances, and no doubles",
        _tiny,
        _all_fits(lambda numbers: max(numbers) < Fraction(1, 2**100)),
    ),
    SolidFamily(
        "solids-thin-operand",
        "a solid and a point, or a segment in the plane of one of its faces",
        _thin,
        _along_a_face,
    ),
)
