"""The same end-to-end test through every scalar type."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.exact import approximate, digest
from minkref.fuzz.plane.case import Case
from minkref.reports.evidence.framework.operands import case_of
from minkref.reports.evidence.framework.part import Findings, Minutes, Size

MINUTES = Minutes(0.05, 0.1, 0.1)

ARITHMETICS = ("rational", "interval", "double", "mpfr:53", "mpfr:256")
CASES = (
    ("g1", "g2", "7/5"),
    ("g4", "g1", "1"),
    ("g3", "g3", "1"),
    ("dog145", "g1", "541/186"),
    ("glyph275", "g2", "1/3"),
    ("disc5", "cells1815", "1"),
)


def answer(case: Case, arithmetic: str) -> dict[str, Any]:
    """The answer for a sum in one arithmetic."""
    try:
        result = _core.minkowski_sum(case.P, case.Q, case.scale, "paper", arithmetic)
    except _core.UndecidedSign:
        return {"undecided": True}
    text = result.region.canonical_json()
    return {
        "digest": digest(text),
        "vertices": result.region.vertices,
        "components": result.components,
        "holes": result.holes,
        "area": approximate(result.region.area()),
        "seconds": round(result.seconds, 4),
    }


def run(findings: Findings, size: Size) -> None:
    rows: dict[str, dict[str, Any]] = {}
    same: dict[str, int] = dict.fromkeys(ARITHMETICS, 0)
    undecided: dict[str, int] = dict.fromkeys(ARITHMETICS, 0)
    alike = exact = 0
    for names in CASES:
        case = case_of(*names)
        row = {arithmetic: answer(case, arithmetic) for arithmetic in ARITHMETICS}
        truth = digest(
            _core.minkowski_sum(case.P, case.Q, case.scale, "winding").region.canonical_json()
        )
        exact += row["rational"]["digest"] == truth
        alike += row["double"].get("digest") == row["mpfr:53"].get("digest")
        for arithmetic, found in row.items():
            undecided[arithmetic] += "undecided" in found
            shape = ("vertices", "components", "holes")
            same[arithmetic] += all(found.get(key) == row["rational"][key] for key in shape)
            if "digest" in found:
                found["exact digest"] = found["digest"] == truth
        rows[case.name.text] = row
    findings.figures = {"cases": rows, "undecided": undecided}
    count = len(CASES)
    findings.equal("rational has the digest of route winding", count, exact)
    certified = sum(
        row["interval"].get("exact digest", False) or "undecided" in row["interval"]
        for row in rows.values()
    )
    findings.equal("interval is exact or says undecided", count, certified)
    findings.equal("mpfr at 53 bits answers as doubles do", count, alike)
    wrong = sum("undecided" in row[a] for row in rows.values() for a in ("double", "mpfr:53"))
    findings.none("sums to which plain floats give no answer", wrong)
    for arithmetic in ARITHMETICS:
        findings.target(
            f"{arithmetic}: sums with the right numbers of vertices, components, holes",
            same[arithmetic] > 0, f"at least 1 of {count}", same[arithmetic],
        )  # fmt: skip
