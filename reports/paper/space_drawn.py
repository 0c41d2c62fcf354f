"""Fig. 4 and 5: contacts of parallel faces, the degree of incompatibility, and the chain of edges
compatible with an edge. Numbers are exact; only the drawings are rounded."""

from __future__ import annotations

from fractions import Fraction

from minkref.fuzz.geometry.plane import dot, minus
from minkref.reports.audit.bodies import Body, Whole, compatible_pairs, hull
from minkref.reports.audit.space import events_of_facets, facet
from minkref.reports.audit.space_pictures import facets_picture
from minkref.reports.drawing import Label, Layer, Segment, picture
from minkref.reports.paper.entry import Claim, Picture

Place = tuple[int, int]
UP, DOWN = ((0, 3), (-3, -2), (3, -2)), ((0, -3), (3, 2), (-3, 2))
COPLANAR = 4  # the scale
WIDTH = 300


def figure_4() -> tuple[list[Picture], list[Claim]]:
    """The two triangles of a six-pointed star; one triangle rises with the scale."""
    rising = facet("vf", [(0, 0, 1)], [(x, y, 0) for x, y in DOWN])
    still = facet("vf", [(0, 0, 0)], [(x, y, COPLANAR) for x, y in UP])
    events = events_of_facets(rising, still)
    contacts = len(events["edge"]) // 2
    at = Fraction(COPLANAR)
    drawn = facets_picture([rising.corners(at)], [still.corners(at)], "two triangles")
    return [Picture(f"two faces of the convolution at s = {COPLANAR}", drawn)], [
        Claim("contacts are marked as c1 through c6", "Fig. 4", "edge events at one scale, exact",
              f"{contacts} at s = {COPLANAR}",
              contacts == 6 and set(events["edge"]) == {at}),
        Claim("no vertices are involved in this event", "Fig. 4", "vertex events, exact",
              f"{len(events['vertex'])} vertex events",
              not events["vertex"]),
    ]  # fmt: skip


RING: tuple[Place, ...] = ((0, 0), (5, -2), (9, 1), (10, 5), (7, 8), (2, 7), (-1, 4))
NORMAL, START = (1, 2), 1


def degree(v: int) -> tuple[int, int]:
    """The height of a vertex's higher ring neighbour above the line through the vertex with the
    face's normal, and that neighbour. At most 0 if vertex and face are compatible."""
    near = ((v - 1) % len(RING), (v + 1) % len(RING))
    return max((dot(NORMAL, minus(RING[w], RING[v])), w) for w in near)


def figure_5() -> tuple[list[Picture], list[Claim]]:
    way = [START]
    while degree(way[-1])[0] > 0:
        way.append(degree(way[-1])[1])
    farthest = max(range(len(RING)), key=lambda k: dot(NORMAL, RING[k]))
    P, Q = _bodies()
    chain = _chain(P, Q)
    return [
        Picture("the degree of incompatibility of f and v, its witness v v', and the vertex u that "
                "fits", _drawn_descent(way)),
        Picture("the arc g(e) between the facets of e, over the Gaussian map of Q (seen from the "
                "centre, on a plane): arcs of compatible edges are thick", _drawn_chain(P, Q)),
    ], [
        Claim("Using gradient decent, we will find the compatible vertex u for f", "Fig. 5",
              "the witness leads upwards, with a signed degree, to the farthest vertex",
              f"after {len(way) - 1} edges at the vertex that is farthest along the normal"
              if way[-1] == farthest else "it ends elsewhere", way[-1] == farthest),
        Claim("The edges with which e is compatible must form a path", "Sec. 6",
              "the compatible edges of one edge, by supports",
              f"a path of {len(chain)} edges" if chain else "they form none", bool(chain)),
    ]  # fmt: skip


def _drawn_descent(way: list[int]) -> str:
    v, witness, last = RING[way[0]], RING[way[1]], RING[way[-1]]
    height = Fraction(dot(NORMAL, minus(witness, v)), dot(NORMAL, NORMAL))
    foot = tuple(float(witness[i] - height * NORMAL[i]) for i in (0, 1))
    along = (float(-NORMAL[1]), float(NORMAL[0]))
    line = (v[0] - 2 * along[0], v[1] - 2 * along[1], v[0] + 4 * along[0], v[1] + 4 * along[1])
    marks = [
        Layer("witness", point=place, labels=[Label(place, name, move=(7, 15))])
        for place, name in (((float(x), float(y)), name)
                            for (x, y), name in ((v, "v"), (witness, "v'"), (last, "u")))
    ]  # fmt: skip
    layers = [
        Layer("second", [[[(float(x), float(y)) for x, y in RING]]]),
        Layer("first-edge", segments=[line]),
        Layer("hidden-edge", segments=[(float(witness[0]), float(witness[1]), foot[0], foot[1])]),
        *marks,
    ]
    return picture(layers, "the degree of incompatibility", WIDTH)


def _bodies() -> tuple[Body, Body]:
    """A roof whose ridge turns over a cap with many facets."""
    P = hull([(-9, -2, 0), (9, -3, 0), (8, 4, 0), (-8, 3, 0), (-4, 0, 5), (4, 1, 5)])
    cap = [(x, y, -(x * x + y * y)) for x in (-3, -1, 1, 3) for y in (-3, -1, 1, 3)]
    tilted = [(7 * x + y, 6 * y - x, 5 * z + 2 * x * y) for x, y, z in cap]
    return P, hull([*tilted, (0, 0, -400)])


RIDGE = (4, 5)


def _ends(P: Body, Q: Body) -> tuple[int, int]:
    """Q's vertices compatible with the facets on both sides of the ridge."""
    pairs = compatible_pairs(P, Q)
    first, second = (pairs.fv[f] for f in P.edges[RIDGE])
    (start,), (end,) = first, second
    return start, end


def _compatible(P: Body, Q: Body) -> set[tuple[int, int]]:
    return {other for edge, other in compatible_pairs(P, Q).ee if edge == RIDGE}


def _chain(P: Body, Q: Body) -> list[int]:
    """The chain's vertices, edge after edge; empty if the edges form no path."""
    left = _compatible(P, Q)
    place, end = _ends(P, Q)
    way = [place]
    while place != end:
        step = next((edge for edge in left if place in edge), None)
        if step is None:
            return []
        left.remove(step)
        place = step[0] if step[1] == place else step[1]
        way.append(place)
    return [] if left else way[1:]


def _flat(n: Whole) -> tuple[float, float]:
    return n[0] / n[2], n[1] / n[2]


def _arc(body: Body, edge: tuple[int, int]) -> Segment | None:
    """The segment between both facet normals, if both look upwards."""
    normals = [body.normals[f] for f in body.edges[edge]]
    if any(n[2] <= 0 for n in normals):
        return None
    first, second = map(_flat, normals)
    return (*first, *second)


def _drawn_chain(P: Body, Q: Body) -> str:
    thick = _compatible(P, Q)
    arcs = {edge: _arc(Q, edge) for edge in Q.edges}
    ridge = _arc(P, RIDGE)
    if ridge is None:
        raise ValueError("the roof looks downwards")
    layers = [
        Layer("convolution", segments=[a for e, a in arcs.items() if a and e not in thick]),
        Layer("second-edge", segments=[a for e, a in arcs.items() if a and e in thick]),
        Layer("first-edge", segments=[ridge]),
    ]
    names = ("g(f-)", "g(f+)")
    for place, name in zip((ridge[:2], ridge[2:]), names, strict=True):
        layers.append(Layer("witness", point=place, labels=[Label(place, name, move=(7, -5))]))
    return picture(layers, "an arc over a Gaussian map", WIDTH)
