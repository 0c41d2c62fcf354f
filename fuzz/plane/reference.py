"""Our own routes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.errors import message_of
from minkref.fuzz.cases.any_case import AnyCase
from minkref.fuzz.geometry.region import region_of_sum
from minkref.fuzz.plane.case import Case
from minkref.fuzz.targets.answer import REGIONS, Answer, skipped
from minkref.fuzz.targets.declaration import PLANE, Declaration
from minkref.fuzz.verdicts.verdict import Verdict

DYNAMIC, INDEX = "dynamic", "index"
ROUTES = {
    **_core.ROUTES,
    DYNAMIC: "dynamic update, from one scale to another",
    INDEX: "read off the boundary of the swept sum, built for all scales of a window",
}
OFFSETTING = ("definition", "paper", INDEX)  # routes to a set grown by a disc
MOST_PAIRS = {"definition": 7_000, DYNAMIC: 40_000, INDEX: 40_000}
UPDATING = {
    route: Declaration(f"minkref:{route}", capabilities=PLANE | {"update"})
    for route in (DYNAMIC, INDEX)
}


@dataclass
class ReferenceTarget:
    name: str
    route: str

    @property
    def most_pairs(self) -> int | None:
        return MOST_PAIRS.get(self.route)

    @property
    def declaration(self) -> Declaration:
        return UPDATING.get(self.route, REGIONS)

    def sum(self, case: AnyCase) -> Answer:
        if not isinstance(case, Case):
            return skipped(
                "does not declare space, rejects-invalid, path, union, offset or features"
            )
        if self.route in UPDATING:
            return self.updated_sum(case, case)
        return self._guarded(
            lambda: _core.minkowski_sum(case.P, case.Q, case.scale, self.route, "rational")
        )

    def offset(self, P: _core.PolygonSet, squared_radius: str, inward: bool) -> Answer:
        """The canonical text of P grown or, inward, eroded by a disc."""
        if self.route not in OFFSETTING or (inward and self.route == INDEX):
            return skipped(f"does not declare {'inset' if inward else 'offset'}")
        try:
            if self.route == INDEX:
                text = _core.disc_index(P).canonical_json(squared_radius)
            else:
                of = _core.inset if inward else _core.offset
                text = of(P, squared_radius, 1, self.route).canonical_json()
        except MemoryError as error:
            return Answer(verdict=Verdict.OUT_OF_MEMORY, message=str(error))
        except Exception as error:  # noqa: BLE001 any exception is the target's fault
            return Answer(verdict=Verdict.ERRORED, message=message_of(error))
        return Answer(curves=text)

    def updated_sum(self, before: Case, case: Case) -> Answer:
        """The sum at the scale of `case`, reached by steps from the scale of `before`, or read off
        an index over the scales between."""
        if self.route not in UPDATING:
            return skipped("does not declare update")

        def step() -> _core.Sum:
            if not (before.is_uniform and case.is_uniform):
                return self._by_axes(before, case)
            least, most = sorted((before.scale, case.scale), key=Fraction)
            if self.route == INDEX:
                return _core.ScaleIndex(case.P, case.Q, least, most).sum(case.scale)
            moving = _core.DynamicSum(case.P, case.Q, least, most)
            moving.move_to(before.scale)
            moving.move_to(case.scale)
            return moving.sum()

        return self._guarded(step)

    def _by_axes(self, before: Case, case: Case) -> _core.Sum:
        """With a factor for each axis: the update of convex operands, else the sum of `S P` and Q
        at 1."""
        if self.route == DYNAMIC and case.P.is_convex and case.Q.is_convex:
            convex = _core.DynamicPolygonSum(case.P, case.Q, before.scale)
            convex.update(case.scale)
            return convex.sum()
        P = case.P.scaled(case.scale)
        if self.route == INDEX:
            return _core.ScaleIndex(P, case.Q, "1", "1").sum("1")
        moving = _core.DynamicSum(P, case.Q, "1", "1")
        moving.move_to("1")
        return moving.sum()

    def _guarded(self, compute: Callable[[], _core.Sum]) -> Answer:
        try:
            answer = compute()
        except MemoryError as error:
            return Answer(verdict=Verdict.OUT_OF_MEMORY, message=str(error))
        except Exception as error:  # noqa: BLE001 any exception is the target's fault
            return Answer(verdict=Verdict.ERRORED, message=message_of(error))
        return Answer(region_of_sum(answer), seconds=answer.seconds)

    def close(self) -> None:
        pass
