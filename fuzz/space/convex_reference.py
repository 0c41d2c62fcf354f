"""Our own sums of convex polyhedra."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass

from minkref import _core
from minkref.errors import message_of
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Scale
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.convex_sum import body_of, polyhedron_of, reference_sum, scaling_of
from minkref.fuzz.targets.answer import Answer, lacking, skipped
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.space.scaling import Scaling

DYNAMIC = "convex-dynamic"
CONVEX_ROUTES = {
    "convex": "convex polyhedra: traversal of the Gaussian maps",
    DYNAMIC: "convex polyhedra: dynamic update, from one scaling to another",
}
UNIT: Scaling = ("1", "1", "1")
UNLIKE_UNIT: Scaling = ("2", "1", "1/3")
_SPACE = frozenset(("space", "rational", "non-uniform"))
CONVEX_DECLARATIONS = {
    "convex": Declaration("minkref:convex", capabilities=_SPACE | {"point", "segment"}),
    DYNAMIC: Declaration(f"minkref:{DYNAMIC}", capabilities=_SPACE | {"update"}),
}


@dataclass
class ConvexReferenceTarget:
    """`route` is a key of CONVEX_ROUTES."""

    name: str
    route: str
    most_pairs = None

    @property
    def declaration(self) -> Declaration:
        return CONVEX_DECLARATIONS[self.route]

    def sum(self, case: AnyCase) -> Answer:
        return self._updated(case, None) if self.route == DYNAMIC else self._fresh(case)

    def _fresh(self, case: AnyCase) -> Answer:
        def compute(solid: SpaceCase) -> Polyhedron:
            return reference_sum(solid.asked.P, solid.asked.Q, solid.asked.scale)

        return self._guarded(case, compute)

    def updated_sum(self, before: AnyCase, case: AnyCase) -> Answer:
        """The sum at the scaling of `case`, updated from the scaling of `before`."""
        if self.route != DYNAMIC:
            return skipped("does not declare update", self.declaration)

        return self._updated(case, before.asked.scale if isinstance(before, SpaceCase) else None)

    def _updated(self, case: AnyCase, start: Scale | None) -> Answer:
        """Without `start`, starts at a scaling that differs from the case's."""

        def step(solid: SpaceCase) -> Polyhedron:
            to = scaling_of(solid.asked.scale)
            elsewhere = UNIT if to != UNIT else UNLIKE_UNIT
            bodies = body_of(solid.asked.P), body_of(solid.asked.Q)
            moving = _core.DynamicConvexSum(*bodies, scaling_of(start) if start else elsewhere)
            moving.update(to)
            return polyhedron_of(moving.sum().surface)

        return self._guarded(case, step)

    def _guarded(self, case: AnyCase, compute: Callable[[SpaceCase], Polyhedron]) -> Answer:
        lack = lacking(self.declaration, case)
        if lack or not isinstance(case, SpaceCase):
            return skipped(lack or "in space only", self.declaration)
        start = time.perf_counter()
        try:
            solid = compute(case)
        except MemoryError as error:
            return Answer(verdict=Verdict.OUT_OF_MEMORY, message=str(error))
        except Exception as error:  # noqa: BLE001 any exception is the target's fault
            return Answer(verdict=Verdict.ERRORED, message=message_of(error))
        seconds = time.perf_counter() - start
        return Answer(solid=solid, seconds=seconds, declaration=self.declaration)

    def close(self) -> None:
        pass
