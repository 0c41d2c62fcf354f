"""The Appendix's own program in `minkref sum` and `minkref sweep`: its walk from radius to radius,
and its answers beside the exact sums."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.arithmetic import check_arithmetic
from minkref.cli.readings import DISC_CHOICES, ROUTE, readings_of, refuse_options
from minkref.cli.row_spool import Row
from minkref.disc.disc import Disc
from minkref.errors import Refusal, refusing
from minkref.exact import digest
from minkref.fuzz.judges.plane.rounded_sums import Comparison, significant_bits
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import Operand
from minkref.verbs.paper_update import comparison_fields, decided

EXACT = "rational"
ARITHMETICS = (EXACT, "double")  # and mpfr:BITS; intervals can certify no tie
CORRECTED = {name: corrected for name, _, corrected, _ in DISC_CHOICES.rows}


class DiscWalk:
    """P followed from one radius to another by the Appendix's program. `unit`: the disc at the
    scale 1. Each step holds its answer against the exact sum."""

    def __init__(
        self,
        P: Operand,
        scaled: _core.PolygonSet,
        unit: Disc,
        first: Disc,
        arithmetic: str,
        readings: dict[str, str],
    ) -> None:
        self._P, self._unit = scaled, unit
        self._bits = significant_bits(arithmetic)
        self._square = str(first.squared_radius)
        self._where = P.name
        self._program = self._made(arithmetic, readings)

    def _made(self, arithmetic: str, readings: dict[str, str]) -> _core.DiscUpdate:
        unit = str(self._unit.squared_radius)
        return refusing(
            self._where, lambda: _core.DiscUpdate(self._P, self._square, unit, arithmetic, readings)
        )

    @property
    def seconds(self) -> float:
        return self._program.seconds

    def counts(self) -> dict[str, Any]:
        return dict(self._program.counts())

    def events(self) -> dict[str, Any]:
        """Counts of right, misplaced, missed and invented events of the array. A scale is right if
        half of its digits are, and in exact numbers all."""
        truth = self._made(EXACT, CORRECTED)
        bits = 0 if self._bits is None else self._bits // 2
        return dict(self._program.agreement(truth, bits))

    def answer(self) -> _core.DiscAnswer:
        return refusing(self._where, self._program.answer)

    def beside_exact(self, answer: _core.DiscAnswer, exact: _core.Offset) -> dict[str, Any]:
        """The form has no coordinates: answers with one form are one set."""
        if answer.canonical == exact.canonical_json():
            return comparison_fields(Comparison(True, Fraction(0)))
        witness = self._program.witness(answer)
        return comparison_fields(Comparison(False, None, *(witness or (None, None))))

    def exact(self, disc: Disc) -> _core.Offset:
        square = str(disc.squared_radius)
        return refusing(self._where, lambda: _core.offset(self._P, square, cores()))

    def row(self, scale: Fraction) -> tuple[Row, str]:
        """The row of a sweep at its next scale, and the canonical form of the answer."""
        disc = self._unit.scaled(scale)
        did = decided(lambda: dict(self._program.move_to(str(disc.squared_radius))))
        answer = decided(self.answer)
        row: Row = {
            "scale": str(scale),
            "radius": disc.radius,
            **answer_fields(answer),
            "insertions": did["insertions"],
            "deletions": did["deletions"],
            "updated": did["updated"],
            "update_seconds": did["seconds"],
            "sum_seconds": answer.seconds,
            "exact": self.beside_exact(answer, self.exact(disc)),
        }
        return row, answer.canonical


def answer_fields(answer: _core.DiscAnswer) -> dict[str, Any]:
    return {
        "digest": digest(answer.canonical),
        "components": answer.components,
        "holes": answer.holes,
        "curves": answer.canonical.count('["'),
    }


def disc_readings(
    route: str, arithmetic: str, form: str | None, chosen: list[str] | None
) -> dict[str, str] | None:
    """How the Appendix's program reads the paper; None for the other routes. Refuses options that
    the route does not have."""
    refuse_options(route, form, chosen, DISC_CHOICES)
    if route == ROUTE:
        check_arithmetic(arithmetic, names=ARITHMETICS)
        return readings_of(form, chosen, DISC_CHOICES)
    if arithmetic != EXACT:
        what = f"the route {route} is exact only"
        mend = f"add --route {ROUTE}, or leave it out"
        raise Refusal(what, f"--arithmetic {arithmetic}", mend)
    return None


def sum_by_paper(
    P: Operand,
    scaled: _core.PolygonSet,
    unit: Disc,
    disc: Disc,
    arithmetic: str,
    readings: dict[str, str],
) -> tuple[dict[str, Any], str]:
    """The fields of a document of `sum`, and the canonical form of the answer. Refuses what the
    arithmetic cannot decide."""
    walk = decided(lambda: DiscWalk(P, scaled, unit, disc, arithmetic, readings))
    answer = decided(walk.answer)
    exact = walk.exact(disc)
    told = {
        "digest": digest(exact.canonical_json()),
        "components": exact.components,
        "holes": exact.holes,
        "curves": exact.curves,
    }
    fields = {
        "compute_seconds": walk.seconds + answer.seconds,
        **answer_fields(answer),
        "area": None,
        "length": None,
        "result": json.loads(answer.canonical),
        "statistics": {**walk.counts(), **dict(answer.statistics)},
        "exact": {**told, "equal": answer.canonical == exact.canonical_json()},
        "comparison": walk.beside_exact(answer, exact),
    }
    return fields, answer.canonical
