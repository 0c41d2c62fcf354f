"""Answers from CGAL's methods, judged by the slow engine alone."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from minkref.fuzz.cgal.oracle import CgalOracle, OracleNotFoundError, method_of_target
from minkref.fuzz.judges.plane.slow_operands import slow_operand, slow_operands, slow_scale
from minkref.fuzz.plane.case import Case
from minkref.oracle import slow

SECONDS = 60.0


class CgalClaims:
    """One server for each target found (`cgal-reduced-raw`: with every hole); for one process."""

    def __init__(self, methods: Iterable[str]) -> None:
        self._oracles: dict[str, CgalOracle] = {}
        for name in methods:
            method, raw = method_of_target(name)
            try:
                self._oracles[name] = CgalOracle(method, raw=raw, seconds=SECONDS)
            except OracleNotFoundError:
                continue

    def against(self, case: Case) -> list[dict[str, Any]]:
        """Returns for each method its `outcome` on the sum at the case's scale: `equal`,
        `different` (with a point inside the difference, and both sets), `no set`, or the call's
        status."""
        P, Q = slow_operands(case)
        scale = slow_scale(case)
        rows = []
        for method, oracle in self._oracles.items():
            answer = oracle.sum(case.scaled_P_json, case.Q_json)
            row: dict[str, Any] = {"method": method, "case": case.name.text, "point": None}
            rows.append(row)
            if answer.rings_json is None:
                row["outcome"] = answer.status
                continue
            try:
                claimed = slow_operand(answer.rings_json)
                claim = slow.check_claim(P, Q, scale, claimed)
            except slow.InputError:
                row["outcome"] = "no set"
                continue
            row["outcome"] = "equal" if claim.equal else "different"
            if claim.point is not None:
                row["point"] = [str(x) for x in claim.point]
                row["in_truth"] = claim.in_truth
                row["claim"] = _polygons(claimed.polygons)
                row["truth"] = _polygons(slow.minkowski_sum(P, Q, scale).polygons)
        return rows


def _polygons(polygons: list[slow.Polygon]) -> list[list[list[list[str]]]]:
    return [
        [[[str(x), str(y)] for x, y in ring] for ring in (part.outer, *part.holes)]
        for part in polygons
    ]
