"""A solid and itself, a solid and its reflection, and surfaces cut up needlessly."""

from __future__ import annotations

from fractions import Fraction
from itertools import combinations
from random import Random

from minkref.degeneracies.solids.draft import SolidDraft, SolidFacts, SolidFamily
from minkref.degeneracies.solids.placing import placed, swapped
from minkref.degeneracies.solids.refined import refined
from minkref.degeneracies.solids.ties import Tie
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.generators import machined
from minkref.fuzz.space.generators.any_solid import ORIGIN, any_of_one, walls
from minkref.fuzz.space.generators.assembled import hollow_box

SHOWN = 4  # ties of one kind


def _solid(dice: Random) -> Polyhedron:
    kind = dice.randrange(4)
    if kind == 0:
        return hollow_box(dice, 2)[0]
    if kind == 1:
        return machined.cup(1, dice.randint(1, 2), 1, walls(dice, 2), 1)
    return any_of_one(dice)


def _itself(dice: Random, size: int) -> SolidDraft:
    solid = _solid(dice)
    return placed(dice, SolidDraft(solid, solid))


def _reflection(dice: Random, size: int) -> SolidDraft:
    solid = _solid(dice)
    return placed(dice, SolidDraft(solid, solid.reflected(ORIGIN)))


def _same(facts: SolidFacts) -> list[Tie]:
    """Each face on itself, and sums of two vertices each way."""
    P, Q = facts.P.given, facts.Q.given
    if P.faces != Q.faces or len(_steps(facts, 1)) != 1:
        return []
    pairs = combinations(range(len(P.vertices)), 2)
    meets = [Tie("vertices-meet", (((a,), (b,)), ((b,), (a,)))) for a, b in pairs]
    faces = [Tie("parallel-facets", ((face, face),)) for face in P.faces]
    return [*faces[:SHOWN], *meets[:SHOWN]]


def _opposite(facts: SolidFacts) -> list[Tie]:
    """Each face against itself, and each vertex: their sums are one point."""
    P, Q = facts.P.given, facts.Q.given
    if len(P.vertices) != len(Q.vertices) or len(_steps(facts, -1)) != 1:
        return []
    meets = Tie("vertices-meet", tuple(((k,), (k,)) for k in range(len(P.vertices))))
    number = {frozenset(face): face for face in Q.faces}
    faces = [Tie("opposite-facets", ((face, number[frozenset(face)]),)) for face in P.faces]
    return [meets, *faces[:SHOWN]]


def _steps(facts: SolidFacts, turn: int) -> set[Point]:
    """Differences from the vertices of sP, perhaps reflected, to the vertices of Q: all the
    same."""
    s, found = facts.scale * turn, set()
    for p, q in zip(facts.P.given.vertices, facts.Q.given.vertices, strict=True):
        x, y, z = (b - s * a for a, b in zip(p, q, strict=True))
        found.add((x, y, z))
    return found


def _refined(dice: Random, size: int) -> SolidDraft:
    plain = (_solid(dice), machined.plate(*(dice.randint(1, 3) for _ in range(3))))
    P, Q = (refined(dice, solid) for solid in plain)
    return placed(dice, swapped(dice, SolidDraft(P, Q, Fraction(1), (), plain)))


def _flat(facts: SolidFacts) -> list[Tie]:
    found = [
        Tie("flat-vertex", (((k,), ()) if mesh is facts.P else ((), (k,)),))
        for mesh in (facts.P, facts.Q)
        for k in range(len(mesh.given.vertices))
        if mesh.is_flat(k)
    ]
    return found if any(p for ((p, _),) in (tie.features for tie in found)) else []


FAMILIES = (
    SolidFamily(
        "solids-with-itself",
        "P + P: every face on itself, and most sums of vertices twice",
        _itself,
        _same,
    ),
    SolidFamily(
        "solids-with-reflection",
        "P + (-P): all vertices meet their own in one point",
        _reflection,
        _opposite,
    ),
    SolidFamily(
        "solids-refined",
        "faces cut up, flat vertices, vertices in the middle of edges: the sum is the same",
        _refined,
        _flat,
    ),
)
