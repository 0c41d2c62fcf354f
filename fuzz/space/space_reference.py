"""Our own sums of polyhedra of any shape."""

from __future__ import annotations

import time
from dataclasses import dataclass

from minkref import _core
from minkref.errors import message_of
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.exact_sum import DEFINITION, EDGES, exposed_sum, polyhedron_of_planes
from minkref.fuzz.targets.answer import Answer, lacking, skipped
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Verdict

SPACE_DEFINITION = "definition-space"  # `definition` is the route in the plane
SPACE_ROUTES = {
    "edges": "polyhedra of any shape: the edges of the reduced convolution",
    SPACE_DEFINITION: "polyhedra of any shape: union of the sums of all pairs of convex pieces",
}
_BY_NAME = {"edges": EDGES, SPACE_DEFINITION: DEFINITION}
_TAKES = frozenset(
    ("space", "non-convex", "holes", "components", "touching", "point", "segment", "rational")
) | {"non-uniform"}
SPACE_DECLARATIONS = {
    route: Declaration(f"minkref:{route}", capabilities=_TAKES) for route in SPACE_ROUTES
}


@dataclass
class SpaceReferenceTarget:
    """`route` is a key of SPACE_ROUTES."""

    name: str
    route: str
    most_pairs = None

    @property
    def declaration(self) -> Declaration:
        return SPACE_DECLARATIONS[self.route]

    def sum(self, case: AnyCase) -> Answer:
        declared = self.declaration
        lack = lacking(declared, case)
        if lack or not isinstance(case, SpaceCase):
            return skipped(lack or "in space only", declared)
        pair, start = case.asked, time.perf_counter()
        try:
            planes = exposed_sum(pair.P, pair.Q, pair.scale, _BY_NAME[self.route])
        except _core.LimitExceeded as error:
            return skipped(message_of(error), declared)
        except MemoryError as error:
            return Answer(verdict=Verdict.OUT_OF_MEMORY, message=str(error))
        except Exception as error:  # noqa: BLE001 any exception is the target's fault
            return Answer(verdict=Verdict.ERRORED, message=message_of(error))
        seconds = time.perf_counter() - start
        solid = polyhedron_of_planes(planes)
        return Answer(solid=solid, seconds=seconds, declaration=declared)

    def close(self) -> None:
        pass
