"""A run made by hand: findings in the plane and in space, a crash, a tolerance, the sum of the
boundaries, a known fault, and names that try to break out of a page."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable
from copy import deepcopy
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.boundary_sum import decide_boundary
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import decide
from minkref.fuzz.run.naming import load
from minkref.fuzz.run.runner import Cell, Finding, Run
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.shrink.finding import SmallFinding
from minkref.fuzz.shrink.groups import Group, groups_of
from minkref.fuzz.space.fault_search import decided
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness

HOSTILE = "py:<script>alert('x')</script>:f\x1b[31m\x00"
TRIANGLE = [[0, 0], [1, 0], [0, 1]]
HOLED = {"outer": [[5, 2], [0, 4], [0, 0]], "holes": [[[4, 2], [1, 1], [1, 3]]]}
TETRAHEDRON = {
    "vertices": [[0, 0, 0], [0, 0, 1], [0, 1, 0], [1, 0, 0]],
    "faces": [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
}


def literal(P: Any, Q: Any, scale: str = "1") -> str:
    return json.dumps({"P": P, "Q": Q, "scale": scale})


def polygons(*given: Any) -> dict[str, Any]:
    return {"polygons": [p if isinstance(p, dict) else {"outer": p} for p in given]}


HOLE = literal(polygons(TRIANGLE), polygons(HOLED))
CONVEX = literal(polygons(TRIANGLE), polygons([[0, 0], [3, 0], [3, 2], [0, 2]]), "7/5")
SPACE = literal(
    TETRAHEDRON,
    {**TETRAHEDRON, "vertices": [[9, 0, 0], [9, 0, 3], [9, 2, 0], [10, 0, 0]]},
    "2,3/2,1",
)


@dataclass
class Made:
    run: Run
    groups: list[Group]
    value: dict[str, Any]


def finding_of(
    text: str,
    target: str,
    point: tuple[str, ...] | None = None,
    verdict: Verdict = Verdict.WRONG,
    reasons: tuple[Reason, ...] = (),
    **more: Any,
) -> Finding:
    """A finding about the case, with the true witness at `point`."""
    case = load(CaseName(text, "named"))
    result = CaseResult(0, case.name, case.scale, [], "P", "Q", case.size, literal=text)
    result.family = "holes"
    witness: Witness | None = None
    if isinstance(case, Case):
        result.P, result.Q = case.P_json, case.Q_json
        result.expected = _core.minkowski_sum(case.P, case.Q, case.scale).region.canonical_json()
        if point:
            x = (point[0], point[1])
            boundary = more.pop("boundary", False)
            witness = decide_boundary(case, x) if boundary else decide(case, x)
    else:
        result.dimension = 3
        result.P, result.Q = case.pair.P.to_json(), case.pair.Q.to_json()
        if point:
            x, y, z = (Fraction(n) for n in point)
            witness = decided(case.pair, (x, y, z))
    if witness is not None and "tolerance" in more:
        witness = replace(witness, tolerance=more.pop("tolerance"))
    return Finding(Outcome(target, verdict, reasons, witness=witness, **more), result)


@pytest.fixture
def finding() -> Callable[..., Finding]:
    return finding_of


@pytest.fixture(scope="session")
def made_once() -> Made:
    filled = (
        '{"polygons":[{"outer":[["0","0"],["1","0"],["6","2"],["5","3"],["0","5"]],"holes":[]}]}'
    )
    findings = [
        finding_of(
            HOLE,
            "pysfcgal",
            ("11/5", "5/2"),
            reasons=(Reason.HOLE_LOST,),
            got=filled,
            digest="1" * 64,
            expected_digest="2" * 64,
        ),
        finding_of(
            SPACE,
            "manifold3d",
            ("0", "0", "0"),
            reasons=(Reason.EXTRA,),
            got=json.dumps(
                {
                    **TETRAHEDRON,
                    "vertices": [[str(3 * n) for n in v] for v in TETRAHEDRON["vertices"]],
                }
            ),
        ),
        finding_of(
            CONVEX,
            HOSTILE,
            verdict=Verdict.CRASHED,
            message="<script>boo</script>\x07 & more",
            signal="SIGSEGV",
            log="</pre><script>log</script>\x1b[0m\nlast line",
        ),
        finding_of(
            CONVEX,
            "clipper2",
            ("22/5", "17/10"),
            reasons=(Reason.MISSING,),
            boundary=True,
            got='{"polygons":[]}',
            tolerance="1/1000",
        ),
        finding_of(
            HOLE,
            "cgal-reduced",
            ("11/5", "5/2"),
            verdict=Verdict.KNOWN,
            got=filled,
            reasons=(Reason.HOLE_LOST,),
            was=Verdict.WRONG,
            message="CGAL issue 5830 <b>",
        ),
    ]
    run = Run(["minkref:paper", "pysfcgal", "manifold3d", HOSTILE, "clipper2", "cgal-reduced"])
    run.groups, run.cases, run.findings, run.absent = (
        ["holes", "named"],
        Counter(holes=9, named=1),
        findings,
        2,
    )
    run.matrix[("minkref:paper", "holes")] = Cell(
        Counter({"pass": 5, "pass-within": 2, "skipped": 2}),
        Counter({"does not declare <space>": 2}),
        0.5,
    )
    run.matrix[("minkref:paper", "named")] = Cell(Counter({"pass": 1}))
    for each in findings:
        cell = run.matrix.setdefault((each.outcome.target, "named"), Cell())
        cell.verdicts[str(each.outcome.verdict)] += 1
    run.matrix[("pysfcgal", "holes")] = Cell(Counter({"pass": 3, "wrong": 4, "skipped": 1}))
    groups = groups_of(run)
    for group in groups:
        if group.example.outcome.target == "pysfcgal":
            own = group.example
            small = replace(own.case, name=CaseName(HOLE, "shrinking"))
            group.small = [SmallFinding(HOLE, small, own.outcome, 7, True, False)]
    return Made(run, groups, _document(run))


@pytest.fixture
def made(made_once: Made) -> Made:
    """A copy, which a test may change."""
    return deepcopy(made_once)


def _document(run: Run) -> dict[str, Any]:
    return {
        "version": "0.1.0",
        "seconds": 12.25,
        "exit_code": 1,
        "seed": 7,
        "targets": [
            {
                "name": name,
                "version": "1.0 <v>",
                "arithmetic": "integer-grid" if name == "clipper2" else "exact",
                "tolerance": {"absolute": "0", "relative": "1/1000" if name == "clipper2" else "0"},
                "sum": "boundary" if name == "clipper2" else "region",
                "capabilities": ["plane"],
            }
            for name in run.targets
        ],
        "absent": [{"name": "openscad", "reason": "not <installed>"}],
        "notes": ["a note & <more>"],
        "left_out": {"does not declare holes": 1},
        "groups": [{"name": name, "cases": run.cases[name]} for name in run.groups],
        "findings": [
            {"target": f.outcome.target, "message": f.outcome.message} for f in run.findings
        ],
        "shrunk": [{"target": "pysfcgal"}],
    }
