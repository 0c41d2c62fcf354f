"""Sums in space with an operand that is not convex, or by a route for such operands."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from minkref import _core
from minkref.errors import Refusal, choice, refusing
from minkref.exact import digest
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling
from minkref.space.sum_surface import SumSurface, sum_surface

#: docs/space-sums.md; sums.py has the routes for convex polyhedra.
GENERAL_ROUTES = ("edges", "definition")
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class GeneralSum:
    """A general sum. `convex`: the set if convex, else None; `statistics`: the route's counts."""

    P: SpaceOperand
    Q: SpaceOperand
    scaling: Scaling
    set: _core.PolyhedralSet
    convex: _core.ConvexPolyhedron | None
    statistics: dict[str, int] | None
    seconds: float

    def canonical_json(self) -> str:
        """Write canonical JSON; a convex set takes the form of a convex polyhedron
        (docs/definitions.md)."""
        if self.convex is not None:
            return self.convex.surface().canonical_json()
        return self.set.canonical_json()

    @property
    def digest(self) -> str:
        return digest(self.canonical_json())

    def mesh(self, triangles: bool = False) -> _core.Polyhedron:
        """Make a closed mesh. With whole faces the mesh is not manifold where the set touches
        itself; with triangles the mesh is manifold, by its vertices' numbers."""
        if self.convex is None:
            return self.surface.boundary.mesh(triangles)
        surface = self.convex.surface()
        return surface.cut_into_triangles() if triangles else surface

    @cached_property
    def surface(self) -> SumSurface:
        return sum_surface(self.set, self.P, self.Q, self.scaling)


def chosen_space_route(
    P: SpaceOperand, Q: SpaceOperand, route: str | None, of_convex: tuple[str, ...]
) -> str:
    """Return `route`, or by default the first route that the operands allow. Refuses an unknown
    route, and a convex route with an operand that is not convex."""
    if route is not None and route not in (*of_convex, *GENERAL_ROUTES):
        mend = f"in space: {choice(route, (*of_convex, *GENERAL_ROUTES))}"
        raise Refusal(f"there is no route {route!r} in space", "--route", mend)
    general = [o for o in (P, Q) if o.body is None and not o.is_thin]
    if not general or any(o.surface.vertices == 0 for o in (P, Q)):
        return route or of_convex[0]
    if route in of_convex:
        raise Refusal(
            f"{general[0].name} is no convex polyhedron, and the route {route} is for these",
            f"--route {route}",
            f"choose one of {', '.join(GENERAL_ROUTES)}",
            "not-convex",
        )
    return route or GENERAL_ROUTES[0]


def general_sum(
    P: SpaceOperand,
    Q: SpaceOperand,
    scaling: Scaling,
    route: str,
    threads: int = 1,
    progress: Progress | None = None,
) -> GeneralSum:
    """Compute S P ⊕ Q, exactly. Refuses two operands without volume; the route `definition` refuses
    a plane polygon."""
    where = f"{P.name} and {Q.name}"
    if not (P.is_solid or Q.is_solid):
        mend = "beside a plane polygon, a segment or a point give a polyhedron"
        raise Refusal("neither operand has volume", where, mend, "not-solid")
    first, second = P.surface, Q.surface
    start = time.perf_counter()
    statistics: dict[str, int] | None = None
    if route == "definition":
        why = "the route definition takes no plane polygon"
        refuse_polygon(why, "choose the route edges", P, Q)
        found = refusing(where, lambda: _core.definition_sum_in_space(first, second, scaling))
    else:
        found, statistics = refusing(
            where, lambda: _core.edge_sum_with_statistics(first, second, scaling, threads, progress)
        )
    seconds = time.perf_counter() - start
    return GeneralSum(P, Q, scaling, found, found.convex(), statistics, seconds)


def refuse_polygon(why: str, mend: str, *operands: SpaceOperand) -> None:
    for operand in operands:
        if operand.surface.faces == 1:
            raise Refusal(why, operand.name, mend, "not-solid")
