"""Our own routes."""

from __future__ import annotations

from dataclasses import dataclass

from minkref import _core
from minkref.errors import message_of
from minkref.fuzz.cases.case import Case
from minkref.fuzz.cases.space_case import SpaceCase
from minkref.fuzz.targets.answer import Answer, skipped
from minkref.fuzz.verdicts.region import region_of_sum
from minkref.fuzz.verdicts.verdict import Verdict

ROUTES = {
    "paper": "reduced convolution, orientable loops, nesting, collision detection",
    "winding": "winding number of the full convolution of slit operands",
    "definition": "union of the sums of all pairs of triangles",
}


@dataclass
class ReferenceTarget:
    name: str
    route: str

    def sum(self, case: Case | SpaceCase) -> Answer:
        if isinstance(case, SpaceCase):
            return skipped("does not declare space")
        try:
            answer = _core.minkowski_sum(case.P, case.Q, case.scale, self.route, "rational")
        except MemoryError as error:
            return Answer(verdict=Verdict.OUT_OF_MEMORY, message=str(error))
        except Exception as error:  # noqa: BLE001 a fault of the target, whatever it is
            return Answer(verdict=Verdict.ERRORED, message=message_of(error))
        return Answer(region_of_sum(answer), seconds=answer.seconds)

    def close(self) -> None:
        pass
