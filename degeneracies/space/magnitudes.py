"""Nearly parallel facets, and coordinates and factors that are huge, tiny, or both: exact signs
decide these cases, doubles do not."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from random import Random

from minkref.degeneracies.space.always import FAMILIES as ALWAYS
from minkref.degeneracies.space.at_a_scaling import (
    direction_pair,
    edge_meets_facet,
    facet_and_edge,
    facet_pair,
    facets_meet,
    on_top,
)
from minkref.degeneracies.space.bodies import (
    any_scaling,
    below,
    changed,
    hull,
    larger,
    placed,
    swapped,
)
from minkref.degeneracies.space.body import Corners
from minkref.degeneracies.space.coincidences import facets_along_edges, only_here, parallel_facets
from minkref.degeneracies.space.draft import Coincidence, SpaceDraft, SpaceFacts, SpaceFamily
from minkref.degeneracies.space.vectors import crossed, inverse, product, shrunk, stretched, vector
from minkref.fuzz.geometry.space import Point

LEAST_BITS, MOST_BITS = 20, 200
SIGNIFICAND = 53
HUGE = Fraction(10) ** 250
FAR = Fraction(10) ** 200
LONG = 10**6  # ratio of a needle's length, or a plate's width, to its thickness


def _nearly(dice: Random, size: int) -> SpaceDraft:
    """A facet of SP, and a facet of Q with one corner slightly off the facet's plane. Where doubles
    have digits for this distance, the bodies lie far from the origin."""
    bits = dice.randint(LEAST_BITS, MOST_BITS)
    u, v, normal = direction_pair(dice)
    s = any_scaling(dice)
    P = on_top(dice, [vector(0, 0, 0), u, v], normal, size)
    down = shrunk(normal, s)
    a, b = (stretched(w, s) for w in (u, v))
    off = Fraction(1, 2**bits) / max(abs(c) for c in down)
    x, y, z = (c - off * n for c, n in zip(b, down, strict=True))
    others = below(dice, down, max(2, size // 2 - 3), 12)
    draft = changed(
        dice, SpaceDraft(P, hull([vector(0, 0, 0), a, (x, y, z), *others]), s, dice.randrange(3))
    )
    if bits > SIGNIFICAND:
        return draft
    far = [dice.choice((-1, 1)) * (2 ** (SIGNIFICAND + 4 - bits) + dice.randint(0, 99)) for _ in s]
    return replace(draft, P=placed(draft.P, far), Q=placed(draft.Q, far[::-1]))


def _nearly_parallel(facts: SpaceFacts) -> list[Coincidence]:
    """Facets at an angle below 2^-20, but not parallel, each with its own facet in the sum; doubles
    get a sign wrong between one facet and an edge of the other."""
    alone, alone_in_Q = (
        {pair[k] for pair in facts.sum().parents if len(pair[k]) > 2 and len(pair[1 - k]) < 3}
        for k in (0, 1)
    )
    wrong = _wrong_pairs(facts)
    shown = []
    for facet, n in zip(facts.P.facets, facts.directions_of_P(), strict=True):
        for other in facts.Q.facets:
            p, q = facet.corners, other.corners
            across, along = crossed(n, other.normal), product(n, other.normal)
            near = along > 0 and 0 < product(across, across) * 4**LEAST_BITS < along**2
            if near and p in alone and q in alone_in_Q and _meet(wrong, p, q):
                shown.append(Coincidence("nearly-parallel-facets", p, q))
    return shown


def _wrong_pairs(facts: SpaceFacts) -> list[tuple[Corners, Corners]]:
    """The faces of P and of Q with a wrong sign in doubles."""
    signs = zip(facts.pairs_of_signs(), facts.signs(), facts.signs_in_doubles(), strict=True)
    return [pair for pair, exact, found in signs if exact != found]


def _meet(pairs: list[tuple[Corners, Corners]], p: Corners, q: Corners) -> bool:
    """Whether a pair consists of one facet and an edge of the other."""
    return any(set(face) <= set(p) and set(other) <= set(q) for face, other in pairs)


def _huge(dice: Random, size: int) -> SpaceDraft:
    """Gives P or Q a huge or tiny size, or both, along all axes or along each differently; the
    factors compensate."""
    base = dice.choice((facet_pair, facet_and_edge, *(family.draw for family in ALWAYS)))
    draft = base(dice, size)
    exponents = [dice.randint(290, 300) * dice.choice((1, -1)) for _ in range(3)]
    if dice.random() < 0.4:
        exponents = [exponents[0]] * 3
    kind = dice.randrange(4)
    first, both = (
        _powers([e * (kind in those) for e in exponents]) for those in ((0, 1), (0, 2, 3))
    )
    s = stretched(stretched(draft.scaling, both), inverse(first))
    others = tuple(stretched(stretched(at, both), inverse(first)) for at in draft.others)
    P, Q = larger(draft.P, first), larger(draft.Q, both)
    return replace(draft, P=P, Q=Q, scaling=s, others=others)


def _powers(exponents: list[int]) -> Point:
    x, y, z = (Fraction(10) ** e for e in exponents)
    return x, y, z


def _is_huge(facts: SpaceFacts) -> list[Coincidence]:
    """Some coordinates or their reciprocals, or factors, beyond what a sum of squares in doubles
    can take, and faces that meet exactly; doubles have signs wrong."""
    sizes = [abs(c) for c in facts.numbers if c]
    if max(sizes) < HUGE and 1 / min(sizes) < HUGE and not _far_factors(facts):
        return []
    here = facts.sum()
    shown = [*parallel_facets(here), *facets_along_edges(here)]
    return shown if facts.wrong_in_doubles() else []


def _far_factors(facts: SpaceFacts) -> bool:
    return any(max(f, 1 / f) > FAR for f in facts.scaling)


def _thin(dice: Random, size: int) -> SpaceDraft:
    """A needle along an edge that lies in a plate's plane at the scaling."""
    u, v, normal = direction_pair(dice)
    s = any_scaling(dice)
    length = LONG * 10 ** dice.randint(1, 24)
    section = [below(dice, u, 1, 3)[0] for _ in range(3)]
    along = [length * x for x in u]
    needle = hull([*section, *(tuple(map(sum, zip(p, along, strict=True))) for p in section)])
    flat = [stretched(w, s) for w in (u, v)]
    corners = [
        [a * length * x + b * length * y for x, y in zip(*flat, strict=True)]
        for a, b in {(dice.randint(-3, 3), dice.randint(-3, 3)) for _ in range(max(4, size // 3))}
    ]
    thickness = shrunk(normal, s)
    plate = hull([*corners, *([a - b for a, b in zip(c, thickness, strict=True)] for c in corners)])
    return changed(dice, swapped(dice, SpaceDraft(needle, plate, s, dice.randrange(3))))


def _is_thin(facts: SpaceFacts) -> list[Coincidence]:
    """Whether one body is a needle, close to its longest line, and the other a plate, thin across a
    facet but wide in two directions, by volume; and whether edges of one are parallel to facets of
    the other at this scaling only."""
    for needle, plate in ((facts.P, facts.Q), (facts.Q, facts.P)):
        is_needle = needle.square_of_girth * LONG**2 < needle.square_of_diameter
        is_plate = (
            plate.square_of_thickness * LONG**2 < plate.square_of_diameter
            and plate.volume**2 * 10**4 > plate.square_of_thickness * plate.square_of_diameter**2
        )
        if is_needle and is_plate:
            return only_here(facts, facets_along_edges(facts.sum()))
    return []


def _far_away(dice: Random, size: int) -> SpaceDraft:
    """Far from the origin, by more than doubles hold beside the bodies' size."""
    draft = changed(dice, dice.choice((facet_pair, facet_and_edge))(dice, size))
    moves = [
        [dice.choice((-1, 1)) * (10 ** dice.randint(15, 40) + dice.randint(0, 999)) for _ in "xyz"]
        for _ in "PQ"
    ]
    return replace(draft, P=placed(draft.P, moves[0]), Q=placed(draft.Q, moves[1]))


def _is_far_away(facts: SpaceFacts) -> list[Coincidence]:
    if min(map(abs, facts.numbers)) < 10**13 or not facts.wrong_in_doubles():
        return []
    return facets_meet(facts) or edge_meets_facet(facts)


FAMILIES = (
    SpaceFamily(
        "facets-nearly-parallel",
        "facets at an angle of less than 2^-20, down to 2^-200, that doubles cannot tell apart",
        _nearly,
        _nearly_parallel,
    ),
    SpaceFamily(
        "magnitudes-in-space",
        "bodies and factors of the size of 1e300 and of 1e-300",
        _huge,
        _is_huge,
    ),
    SpaceFamily(
        "bodies-far-out",
        "bodies so far from the origin that doubles lose their shape",
        _far_away,
        _is_far_away,
    ),
    SpaceFamily(
        "needle-and-plate",
        "a needle and a plate, a million times as long as thick, that are parallel at one scaling",
        _thin,
        _is_thin,
    ),
)
