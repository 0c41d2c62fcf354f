"""Points of a union, decided set by set, and the check of a witness in plain fractions."""

from __future__ import annotations

from dataclasses import dataclass, replace

from minkref import _core
from minkref.fuzz.plane.comparison import WitnessRefuted
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.unions.asked_union import AskedUnion, together
from minkref.fuzz.verdicts.verdict import Witness

ORIGIN = '{"polygons":[{"outer":[["0","0"]],"holes":[]}]}'
POINT = _core.PolygonSet.from_json(ORIGIN)


@dataclass(frozen=True)
class UnionOf:
    """The union of a case's sets. A point's number of a set counts from 1."""

    case: AskedUnion

    def decide(self, point: tuple[str, str]) -> Witness:
        """Finds by triangles the first set with the point, or that none has it. Raises
        WitnessRefuted if plain fractions differ."""
        x, y = point
        regions = ((k, each) for k, each in enumerate(self.case.sets) if each.is_region)
        having = (
            k + 1
            for k, each in regions
            if _core.decide(each, POINT, "1", x, y)["contact"] != "empty"
        )
        number = next(having, None)
        witness = Witness(point, number is not None, of_set=number, sets=len(self.case.sets))
        if not self.holds(witness):
            raise WitnessRefuted(f"the point ({x}, {y}) on {self.case.name.text}")
        return witness

    def holds(self, witness: Witness) -> bool:
        """Whether the named set has the point, or none has it. With a tolerance, whether the whole
        square lies in the union, perhaps only of several sets, or outside of all. A union is the
        sum of all polygons and the origin, and is checked as one."""
        as_sum = Witness(witness.point, False, tolerance=witness.tolerance)
        texts = [
            text
            for text, each in zip(self.case.texts, self.case.sets, strict=True)
            if each.is_region
        ]
        if not witness.in_truth:
            return witness.of_set is None and holds(together(tuple(texts)), ORIGIN, "1", as_sum)
        if witness.of_set is None or not 0 < witness.of_set <= len(self.case.sets):
            return False
        inside = replace(as_sum, in_truth=True, p=witness.point, q=("0", "0"))
        own = self.case.texts[witness.of_set - 1]
        if not holds(own, ORIGIN, "1", replace(inside, tolerance="0")):
            return False
        return holds(together(tuple(texts)), ORIGIN, "1", inside)


def some_point(case: AskedUnion) -> Witness:
    """A vertex of the first region; without a region the origin, outside."""
    region = next((each for each in case.sets if each.is_region), None)
    if region is None:
        return UnionOf(case).decide(("0", "0"))
    x, y = shape_of(region)[0][0][0]
    return UnionOf(case).decide((str(x), str(y)))
