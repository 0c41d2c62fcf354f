"""Sums of convex polygons at scales with a factor for each axis, each got from the one before
(Behar & Lien 2012, Sec. 6, in the plane)."""

from __future__ import annotations

import time
from typing import Any

from minkref import _core
from minkref.cli.row_spool import Row
from minkref.errors import Refusal, refusing
from minkref.plane.commands.sum_fields import sum_fields
from minkref.plane.operand import Operand
from minkref.plane.scaling import PlaneScale, document_of, text_of

COUNTS = ("ev_errors", "ve_errors", "descent_steps")


class ConvexWalk:
    """The sums, and what each update found and did. Beside the empty set, a point or a segment
    there is nothing to update: all counts are 0."""

    def __init__(self, P: Operand, Q: Operand, first: PlaneScale) -> None:
        """From scratch at the first scale. Refuses non-convex operands."""
        self.P, self.Q, self._where = P, Q, f"{P.name} and {Q.name}"
        start = time.perf_counter()
        self._moving: _core.DynamicPolygonSum | None = None
        for operand in (P, Q):
            if operand.set.is_region and not operand.set.is_convex:
                raise Refusal(
                    "by a factor for each axis only sums of convex polygons are updated",
                    operand.name,
                    "give convex operands, uniform scales, or ask `minkref sum` for each scale",
                    "not-convex",
                )
        if P.set.is_region and Q.set.is_region:
            self._moving = refusing(
                self._where, lambda: _core.DynamicPolygonSum(P.set, Q.set, text_of(first))
            )
        self.seconds = time.perf_counter() - start

    def counts(self) -> dict[str, Any]:
        if self._moving is None:
            return {}
        of_P, of_Q = self._moving.pairs()
        return {"edges_of_P": len(of_P), "edges_of_Q": len(of_Q)}

    def row(self, scale: PlaneScale) -> tuple[Row, _core.PolygonSet]:
        """Goes to a scale: what the step did, and the sum there."""
        at = text_of(scale)
        did: dict[str, Any] = {**dict.fromkeys(COUNTS, 0), "seconds": 0.0}
        moving = self._moving
        if moving is not None:
            did = dict(moving.update(at))
            answer = moving.sum()
        else:
            answer = refusing(self._where, lambda: _core.minkowski_sum(self.P.set, self.Q.set, at))
        row: Row = {
            "scale": document_of(scale),
            **sum_fields(answer),
            **{name: did[name] for name in COUNTS},
            "update_seconds": did["seconds"],
            "sum_seconds": answer.seconds,
        }
        return row, answer.region
