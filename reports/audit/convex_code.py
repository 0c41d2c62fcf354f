"""Section 6's code, asked about the audit's bodies."""

from __future__ import annotations

import random
from collections.abc import Callable

from minkref import _core
from minkref.fuzz.geometry.space import normal, primitive
from minkref.reports.audit.bodies import Body, Whole

Scaling = tuple[str, str, str]
ONCE: Scaling = ("1", "1", "1")


def reference_body(body: Body) -> _core.ConvexPolyhedron:
    points = [(str(x), str(y), str(z)) for x, y, z in body.points]
    return _core.ConvexPolyhedron(_core.Polyhedron(points, [list(f) for f in body.facets]))


def scaling(s: Whole) -> Scaling:
    return (str(s[0]), str(s[1]), str(s[2]))


def errors_mended(P: Body, Q: Body, s: Whole) -> tuple[int, int, int]:
    """Counts of fv-, vf- and ee-errors that an update from the scaling by one to s mends."""
    moving = _core.DynamicConvexSum(reference_body(P), reference_body(Q), ONCE)
    did = dict(moving.update(scaling(s)))
    return did["fv_errors"], did["vf_errors"], did["ee_errors"]


def descent(P: Body, n: Whole, Q: Body, vertex: int, form: str) -> int | None:
    """The vertex of Q at which the descent from `vertex` ends, for P's facet with normal n, under
    the printed or corrected degree; None if the descent revisits a vertex. Vertices have the
    bodies' numbers."""
    first, second = reference_body(P), reference_body(Q)
    order = sorted(range(len(Q.points)), key=Q.points.__getitem__)
    surface = first.surface()
    facet = next(
        number
        for number, ring in enumerate(surface.rings())
        if primitive(normal(*(_whole(surface.written_points()[k]) for k in ring[:3])))
        == primitive(n)
    )
    found = _core.descend(first, facet, second, order.index(vertex), ONCE, form)
    return None if found is None else order[found]


def _whole(point: Scaling) -> Whole:
    return (int(point[0]), int(point[1]), int(point[2]))


def unmended(seed: int, trials: int, draw: Callable[[random.Random], Body],
             draw_scaling: Callable[[random.Random], Whole]) -> tuple[int, int]:  # fmt: skip
    """Counts ee-errors during random updates: first all, then only ee-errors without any facet
    error of either body."""
    dice = random.Random(seed)
    edges = alone = 0
    for _ in range(trials):
        moving = _core.DynamicConvexSum(
            reference_body(draw(dice)), reference_body(draw(dice)), scaling(draw_scaling(dice))
        )
        for _ in range(10):
            did = dict(moving.update(scaling(draw_scaling(dice))))
            edges += did["ee_errors"]
            alone += did["chains_without_error"]
    return edges, alone
