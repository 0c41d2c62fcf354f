"""A robot of uncertain size on a path: the scales at which the robot does not overlap an obstacle.

The convolution plays no part: the module tries every edge of one operand at every vertex of the
other, and the code decides by triangles whether robot and obstacle overlap at a place.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations, pairwise

from minkref import _core
from minkref.fuzz.geometry.plane import cross, dot, minus, plus
from minkref.fuzz.plane.families.drawing import reflected, shape_text
from minkref.reports.audit.edges import Interval
from minkref.reports.audit.plane import Place, Ring, rings_of

Moving = tuple[str, Place, Place, Place]  # from s p + q along d, or along s d for an S-edge


def operands(polygons: Sequence[Ring]) -> _core.PolygonSet:
    """Polygons without holes."""
    return _core.PolygonSet.from_json(shape_text([[ring] for ring in polygons]))


def overlaps(robot: _core.PolygonSet, obstacle: _core.PolygonSet, s: Fraction, at: Place) -> str:
    """empty, touching or overlapping: the robot of scale s at a place."""
    return str(_core.decide(reflected(robot), obstacle, str(s), *map(str, at))["contact"])


def moving_edges(robot: _core.PolygonSet, obstacle: _core.PolygonSet) -> list[Moving]:
    """Every edge of one operand at every vertex of the other."""
    P, Q = rings_of(reflected(robot)), rings_of(obstacle)
    corners = {"S": [v for ring in Q for v in ring], "T": [v for ring in P for v in ring]}
    found: list[Moving] = []
    for kind, rings in (("S", P), ("T", Q)):
        for ring in rings:
            for k, b in enumerate(ring):
                a = ring[k - 1]
                d = minus(b, a)
                for v in corners[kind]:
                    found.append((kind, a, v, d) if kind == "S" else (kind, v, a, d))
    return found


def contacts(
    robot: _core.PolygonSet, obstacle: _core.PolygonSet, a: Place, b: Place
) -> set[Fraction]:
    """Scales at which a step from a to b starts or stops meeting an edge of the reduced
    convolution, by the code for two edges. Whole coordinates."""
    P = reflected(robot)
    rings = {"S": (rings_of(P), rings_of(obstacle)), "T": (rings_of(obstacle), rings_of(P))}
    step = ("T", tuple(int(x) for x in (0, 0, *a, *minus(b, a))))
    pairs = []
    for kind, _, edge_ring, edge, corner_ring, corner in _core.reduced_convolution(P, obstacle):
        edges, corners = rings[kind]
        ring, v = edges[edge_ring], corners[corner_ring][corner]
        p, d = ring[edge], minus(ring[(edge + 1) % len(ring)], ring[edge])
        row = (*p, *v, *d) if kind == "S" else (*v, *p, *d)
        pairs.append((step, (kind, tuple(map(int, row)))))
    found = set()
    for _, empty, low, high in _core.pair_intervals(pairs):
        if not empty:
            found |= {Fraction(x) for x in (low, high) if x is not None}
    return found


def candidates(edges: Sequence[Moving], path: Sequence[Place]) -> list[Fraction]:
    """Scales s > 0 at which an end of a moving edge reaches the line of a path step, or the height
    of the step's end if both are parallel, or at which a path vertex reaches an edge's line. Each
    scale is the root of a linear equation."""
    found = set()
    steps = list(pairwise(path)) or [(path[0], path[0])]
    for kind, p, q, d in edges:
        ends = [(p, q), (plus(p, d), q) if kind == "S" else (p, plus(q, d))]
        for a, b in steps:
            step = minus(b, a)
            conditions = [(_turned(d), (a, b)), (_turned(step), (a,))]
            if dot(_turned(d), step) == 0:
                conditions.append((step, (a, b)))
            for normal, known in conditions:
                for u, v in ends:
                    slope = dot(normal, u)
                    found |= {dot(normal, minus(x, v)) / slope for x in known if slope}
    return sorted(s for s in found if s > 0)


def concurrencies(edges: Sequence[Moving], a: Place, b: Place) -> set[Fraction]:
    """Scales s > 0 at which two edges' lines and the line through a and b share a point: roots of a
    determinant, linear in s."""
    step = _turned(minus(b, a))
    rows = [(_turned(d), dot(_turned(d), p), dot(_turned(d), q)) for _, p, q, d in edges]
    found = set()
    for (m, u, v), (n, w, x) in combinations(rows, 2):
        first, second = cross(step, n), cross(step, m)
        slope = w * second - u * first
        if slope:
            found.add((v * first - x * second - dot(step, a) * cross(m, n)) / slope)
    return {s for s in found if s > 0}


def is_valid(
    robot: _core.PolygonSet,
    obstacle: _core.PolygonSet,
    edges: Sequence[Moving],
    path: Sequence[Place],
    s: Fraction,
) -> bool:
    """Whether the robot at scale s overlaps the obstacle nowhere on the path; touching is allowed.
    Edges bound the open set of overlaps, so one place between any two crossings decides."""
    places = [path[0]] if len(path) == 1 else list(_places(edges, path, s))
    rows = [(str(x), str(y)) for x, y in places]
    return "overlapping" not in _core.decide_many(reflected(robot), obstacle, str(s), rows)


def _places(edges: Sequence[Moving], path: Sequence[Place], s: Fraction) -> Iterator[Place]:
    for a, b in pairwise(path):
        step = minus(b, a)
        cuts = {Fraction(0), Fraction(1)}
        for kind, p, q, d in edges:
            start = s * p[0] + q[0], s * p[1] + q[1]
            span = (s * d[0], s * d[1]) if kind == "S" else d
            across = dot(_turned(span), step)
            if across:
                cuts.add(dot(_turned(span), minus(start, a)) / across)
            else:
                ends = start, plus(start, span)
                cuts |= {dot(step, minus(x, a)) / dot(step, step) for x in ends}
        inside = sorted(t for t in cuts if 0 <= t <= 1)
        for t in (*inside, *((x + y) / 2 for x, y in pairwise(inside))):
            yield a[0] + t * step[0], a[1] + t * step[1]


def valid_scales(
    robot: _core.PolygonSet, obstacle: _core.PolygonSet, path: Sequence[Place]
) -> list[Interval]:
    """Components of the set of valid scales: closed in (0, oo), ascending. Decides at every
    candidate and between any two."""
    edges = moving_edges(robot, obstacle)
    marks = candidates(edges, path)
    inner = [(a + b) / 2 for a, b in pairwise(marks)]
    probes: list[tuple[Fraction | None, Fraction | None, Fraction]] = [
        *((s, s, s) for s in marks),
        *((a, b, s) for (a, b), s in zip(pairwise(marks), inner, strict=True)),
        (None, marks[0] if marks else None, marks[0] / 2 if marks else Fraction(1)),
    ]
    if marks:
        probes.append((marks[-1], None, marks[-1] + 1))
    found: list[Interval] = []
    joined = False
    for low, high, s in sorted(probes, key=lambda probe: probe[2]):
        if not is_valid(robot, obstacle, edges, path, s):
            joined = False
        elif joined and found[-1] is not None:
            found[-1] = (found[-1][0], high)
        else:
            found.append((low, high))
            joined = True
    return found


def _turned(d: Place) -> Place:
    return d[1], -d[0]
