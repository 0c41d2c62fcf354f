"""Bodies with difficult shapes: many facets at a vertex, facets with many corners, symmetry, a body
and its own image, flat vertices."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from random import Random

from minkref.degeneracies.space.at_a_scaling import facet_and_edge, facet_pair
from minkref.degeneracies.space.bodies import (
    any_scaling,
    box,
    changed,
    far_scalings,
    hull,
    larger,
    mapped,
    orbit,
    placed,
    polygon,
    prism,
    pyramid,
    reflected,
    scattered,
    swapped,
)
from minkref.degeneracies.space.body import Body
from minkref.degeneracies.space.coincidences import (
    facets_along_edges,
    parallel_edges,
    parallel_facets,
)
from minkref.degeneracies.space.draft import Coincidence, SpaceDraft, SpaceFacts, SpaceFamily
from minkref.degeneracies.space.vectors import vector
from minkref.exact import digest
from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point

MANY = 8  # facets at a vertex, corners of a facet
MOST_CORNERS = 120
SOLIDS: tuple[tuple[tuple[tuple[int, int, int], ...], bool], ...] = (  # points; mirrored
    (((1, 1, 1),), False),  # tetrahedron
    (((1, 1, 1),), True),  # cube
    (((1, 0, 0),), True),  # octahedron
    (((1, 1, 0),), True),  # cuboctahedron
    (((2, 2, 2), (4, 0, 0)), True),  # rhombic dodecahedron
    (((0, 5, 8),), False),  # an icosahedron, its golden section 8 : 5
    (
        ((25, 25, 25), (-25, -25, -25), (0, 40, 16)),
        False,
    ),  # a pentagonal dodecahedron: 1, 1 + h, 1 - h^2, h = 3/5
    (((0, 1, 2),), True),  # truncated octahedron
)


def _corners(size: int) -> int:
    return max(MANY, min(size, MOST_CORNERS))


def _many_sided(dice: Random, size: int) -> list[tuple[int, int]]:
    """A polygon of at least MANY corners."""
    corners = _corners(size)
    while True:
        ring = polygon(dice, corners + corners // 3)
        if len(ring) >= MANY:
            return ring


def _pyramids(dice: Random, size: int) -> SpaceDraft:
    """A pyramid, and another, perhaps upside down, a prism or a box."""
    P = pyramid(dice, _many_sided(dice, size // 2))
    kind = dice.randrange(4)
    if kind == 0:
        Q = pyramid(dice, _many_sided(dice, size // 2))
    elif kind == 1:
        Q = larger(P, (Fraction(dice.randint(1, 3)),) * 3)
    elif kind == 2:
        Q = box(*(dice.randint(1, 9) for _ in range(3)))
    else:
        Q = prism(polygon(dice, max(3, size // 4)), dice.randint(1, 5))
    if dice.random() < 0.5:
        Q = reflected(Q)
    s = any_scaling(dice) if dice.random() < 0.6 else (Fraction(dice.randint(1, 3)),) * 3
    return changed(dice, swapped(dice, SpaceDraft(P, Q, s, dice.randrange(3))))


def _many_facets(facts: SpaceFacts) -> list[Coincidence]:
    """Coincidences of a body with many facets at a vertex."""
    if max(facts.P.degree, facts.Q.degree) < MANY:
        return []
    here = facts.sum()
    return [*parallel_facets(here), *facets_along_edges(here), *parallel_edges(here)]


def _prisms(dice: Random, size: int) -> SpaceDraft:
    """Over polygons that are the same but for a factor along each axis, or not at all."""
    ring = _many_sided(dice, size // 3)
    height = dice.randint(1, 9)
    P = prism(ring, height)
    s = any_scaling(dice)
    kind = dice.randrange(3)
    if kind == 0:
        Q = larger(P, s)
    elif kind == 1:
        Q = prism(_many_sided(dice, size // 3), dice.randint(1, 9))
    else:
        Q = reflected(larger(P, s))
    return changed(dice, SpaceDraft(P, Q, s, dice.randrange(3), far_scalings(dice)[:1]))


def _many_corners(facts: SpaceFacts) -> list[Coincidence]:
    return [
        each for each in parallel_facets(facts.sum()) if len(each.P) >= MANY and len(each.Q) >= MANY
    ]


def _image(body: Polyhedron, dice: Random) -> Polyhedron:
    """Moved, and perhaps larger."""
    return placed(body, [dice.randint(-9, 9) for _ in range(3)])


def _some_body(dice: Random, size: int) -> Polyhedron:
    kind = dice.randrange(4)
    if kind == 0:
        return pyramid(dice, polygon(dice, max(3, size // 2)))
    if kind == 1:
        return prism(polygon(dice, max(3, size // 4)), dice.randint(1, 6))
    return scattered(dice, size // 2)


def _itself(dice: Random, size: int) -> SpaceDraft:
    P = _some_body(dice, size)
    t = dice.choice((Fraction(1), Fraction(1), Fraction(2), Fraction(1, 3), Fraction(7, 5)))
    draft = SpaceDraft(P, _image(P, dice), (t,) * 3, dice.randrange(3), far_scalings(dice)[:1])
    return _turned_alike(dice, draft)


def _turned_alike(dice: Random, draft: SpaceDraft) -> SpaceDraft:
    """Shears both bodies alike; Q stays P, moved, or reflected and moved."""
    a, b, c = (dice.choice((1, 2, 3)) for _ in range(3))

    def shear(v: Point) -> Point:
        return a * v[0] + v[1], b * v[1] + v[2], c * v[2]

    return replace(draft, P=mapped(draft.P, shear), Q=mapped(draft.Q, shear))


def _reflection(dice: Random, size: int) -> SpaceDraft:
    draft = _itself(dice, size)
    return replace(draft, Q=reflected(draft.Q))


def _is_itself(facts: SpaceFacts) -> list[Coincidence]:
    """Checks that every facet of the sum is a facet plus the same facet."""
    if not _same_moved(facts.P.vertices, facts.Q.vertices):
        return []
    shown = parallel_facets(facts.sum())
    everywhere = len(shown) == len(facts.P.facets) == len(facts.sum().parents)
    return shown if everywhere else []


def _is_reflection(facts: SpaceFacts) -> list[Coincidence]:
    """Checks that each facet of SP lies opposite a facet of Q, while P is not its own
    reflection."""
    image = sorted((-x, -y, -z) for x, y, z in facts.P.vertices)
    if not _same_moved(image, facts.Q.vertices) or _same_moved(image, facts.P.vertices):
        return []
    pairs = facts.facet_pairs(sign=-1)
    if len(pairs) < len(facts.P.facets):
        return []
    return [Coincidence("opposite-facets", p.corners, q.corners) for p, q in pairs]


def _same_moved(first: list[Point], second: list[Point]) -> bool:
    """Whether two ascending lists differ by a translation."""
    if len(first) != len(second):
        return False
    moves = {
        tuple(a - b for a, b in zip(p, q, strict=True)) for p, q in zip(first, second, strict=True)
    }
    return len(moves) == 1


def _symmetric(dice: Random, size: int) -> SpaceDraft:
    """Solids from the list, or hulls of any point's orbit."""

    def solid() -> Polyhedron:
        if dice.random() < 0.7:
            points, mirrored = dice.choice(SOLIDS)
            found = hull(orbit((vector(*point) for point in points), mirrored))
        else:
            point = vector(*(dice.randint(0, 9) for _ in range(3)))
            found = hull(orbit([point], dice.random() < 0.3))
        return larger(found, (Fraction(1, dice.randint(1, 3)),) * 3)

    t = (Fraction(dice.randint(1, 4), dice.randint(1, 3)),) * 3
    return SpaceDraft(solid(), solid(), t, dice.randrange(3))


def _is_symmetric(facts: SpaceFacts) -> list[Coincidence]:
    """Under all rotations of the tetrahedron; and faces meet in four places at least."""
    for body in (facts.P, facts.Q):
        if orbit(body.vertices, False) != set(body.vertices):
            return []
    here = facts.sum()
    shown = [*parallel_facets(here), *facets_along_edges(here), *parallel_edges(here)]
    return shown if len(shown) >= 4 else []


def _flat(dice: Random, size: int) -> SpaceDraft:
    """Facets cut into triangles, some around an inner vertex, and vertices inside edges."""
    base = dice.choice((facet_pair, facet_and_edge))
    draft = changed(dice, base(dice, size))
    P, Q = (in_triangles(dice, body) for body in (draft.P, draft.Q))
    return replace(draft, P=P, Q=Q if dice.random() < 0.7 else draft.Q)


def in_triangles(dice: Random, body: Polyhedron) -> Polyhedron:
    """The same set, with flat vertices inside facets and inside edges, vertices numbered in another
    order."""
    vertices = list(body.vertices)
    middles: dict[frozenset[int], list[int]] = {}
    faces: list[Face] = []
    for face in body.faces:
        ring: list[int] = []
        for a, b in pairwise((*face, face[0])):
            ends = frozenset((a, b))
            if ends not in middles:
                middles[ends] = []
                if dice.random() < 0.4:
                    t = Fraction(1, dice.randint(2, 5))
                    middles[ends] = [len(vertices)]
                    vertices.append(_between(vertices[a], vertices[b], t))
            ring += [a, *middles[ends]]
        if dice.random() < 0.5:
            inside = len(vertices)
            x, y, z = (
                sum(c) / len(face) for c in zip(*(body.vertices[k] for k in face), strict=True)
            )
            vertices.append((x, y, z))
            faces += [(a, b, inside) for a, b in pairwise((*ring, ring[0]))]
        else:
            faces.append(tuple(ring))
    order = list(range(len(vertices)))
    dice.shuffle(order)
    dice.shuffle(faces)
    return Polyhedron(
        tuple(vertices[order.index(k)] for k in range(len(vertices))),
        tuple(tuple(order[k] for k in face) for face in faces),
    )


def _between(a: Point, b: Point, t: Fraction) -> Point:
    x, y, z = (p + (q - p) * t for p, q in zip(a, b, strict=True))
    return x, y, z


def _has_flat(facts: SpaceFacts) -> list[Coincidence]:
    """P has vertices inside a facet and vertices inside an edge; the sum is that of the clean
    bodies at all scalings; and faces meet."""
    corners = set(facts.P.vertices)
    flat = [k for k, point in enumerate(facts.P.given.vertices) if point not in corners]
    facets_at = [_facets_through(facts.P, facts.P.given.vertices[k]) for k in flat]
    if 1 not in facets_at or 2 not in facets_at:
        return []
    clean = SpaceFacts.of(
        SpaceDraft(facts.P.clean, facts.Q.clean, facts.scaling, facts.axis, facts.others)
    )
    for at in facts.scalings:
        first, second = (
            digest(each.sum(at).found.surface.canonical_json()) for each in (facts, clean)
        )
        if first != second:
            return []
    here = facts.sum()
    return [*parallel_facets(here), *facets_along_edges(here)]


def _facets_through(body: Body, point: Point) -> int:
    return sum(
        sum(n * (c - d) for n, c, d in zip(f.normal, point, body.vertices[f.ring[0]], strict=True))
        == 0
        for f in body.facets
    )


FAMILIES = (
    SpaceFamily(
        "many-facets-at-a-vertex",
        "a vertex with eight facets or more: pyramids over polygons",
        _pyramids,
        _many_facets,
    ),
    SpaceFamily(
        "many-sided-facets",
        "parallel facets of eight corners or more: prisms over polygons",
        _prisms,
        _many_corners,
    ),
    SpaceFamily("with-itself", "a body and the same body", _itself, _is_itself),
    SpaceFamily(
        "with-its-reflection",
        "a body and its reflection in a point: all facets of the one are opposite to the other's",
        _reflection,
        _is_reflection,
    ),
    SpaceFamily(
        "symmetric-bodies",
        "bodies with all rotations of the tetrahedron, regular ones among them: ties everywhere",
        _symmetric,
        _is_symmetric,
    ),
    SpaceFamily(
        "flat-vertices",
        "facets in triangles, with vertices inside facets and inside edges",
        _flat,
        _has_flat,
    ),
)
