"""Seeded random pairs: our three routes, and every method of CGAL, faults with witnesses."""

from __future__ import annotations

import json
from collections import Counter
from fractions import Fraction
from typing import Any

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.plane import contains, read_shape
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.judgement import TRUTHS
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.run.naming import load_in_plane
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict
from minkref.reports.evidence.framework.comparing import Bench
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 1, 3)

SEED = 2012
PAIRS = Counts(200, 3_000, 10_000)  # fewer pairs spread evenly over all
ROUTES = TRUTHS
BATCH = 50


def shape(case: Case) -> dict[str, int]:
    """The make-up of the pair: holes, the most vertices of an outer ring, the extent."""
    polygons = [p for text in (case.P_json, case.Q_json) for p in json.loads(text)["polygons"]]
    outers = [polygon["outer"] for polygon in polygons]
    sides = [
        max(int(v[axis]) for v in ring) - min(int(v[axis]) for v in ring)
        for ring in outers
        for axis in (0, 1)
    ]
    return {
        "holes": sum(len(polygon["holes"]) for polygon in polygons),
        "most holes": max(len(polygon["holes"]) for polygon in polygons),
        "most vertices": max(map(len, outers)),
        "extent": max(sides),
    }


def refutes(outcome: Outcome) -> bool:
    """Whether the result contradicts the witness at the witness point. (Badly made rings are
    themselves a fault.)"""
    if set(outcome.reasons) <= {Reason.NOT_CLOSED, Reason.SELF_INTERSECTING}:
        return bool(outcome.reasons)
    if outcome.witness is None or outcome.got is None:
        return False
    x, y = outcome.witness.point
    return contains(read_shape(outcome.got), (Fraction(x), Fraction(y))) != outcome.witness.in_truth


def fault(case: Case, outcome: Outcome) -> dict[str, Any]:
    """A disagreement, its witness checked again with plain fractions."""
    proven = (
        outcome.witness is not None
        and holds(case.P_json, case.Q_json, case.scale, outcome.witness)
        and refutes(outcome)
    )
    return {
        "case": case.name.text,
        "target": outcome.target,
        "verdict": str(outcome.verdict),
        "reasons": [str(reason) for reason in outcome.reasons],
        "witness": outcome.witness.document() if outcome.witness else None,
        "proven": proven,
        "message": outcome.message,
    }


def work(job: tuple[range, list[str]]) -> dict[str, Any]:
    """Judges a batch of pairs, as a worker process."""
    indices, targets = job
    tally: Counter[str] = Counter()
    faults = []
    agreed = hole_free = compared = 0
    most: dict[str, int] = {}
    with Bench(targets, seconds=20) as bench:
        for index in indices:
            case = load_in_plane(CaseName(f"random:{SEED}:{index}", "random"))
            form = shape(case)
            hole_free += form["holes"] == 0
            most = {key: max(value, most.get(key, 0)) for key, value in form.items()}
            verdicts = bench.verdicts(case)
            skipped = (name for name, o in verdicts.items() if o.verdict is Verdict.SKIPPED)
            compared += form["holes"] > 0 and "cgal-reduced" not in skipped
            agreed += all(verdicts[route].verdict is Verdict.PASS for route in ROUTES)
            for name, outcome in verdicts.items():
                tally[f"{name} {outcome.verdict}"] += 1
                if outcome.verdict not in (Verdict.PASS, Verdict.SKIPPED):
                    faults.append(fault(case, outcome))
    counts = {"agreed": agreed, "free": hole_free, "holes compared": compared}
    return {"tally": tally, "faults": faults, "counts": counts, "most": most}


def run(findings: Findings, size: Size) -> None:
    pairs = size.of(PAIRS)
    entries = [entry for entry in ALL_TARGETS.entries() if entry.name.startswith("cgal-")]
    cgal = [entry.name for entry in entries if entry.available and not entry.name.endswith("-raw")]
    if not cgal:
        findings.target("methods of CGAL", False, "at least 1", 0)
    for entry in entries:
        if entry.available:
            findings.figures["cgal_version"] = entry.version
    chosen = range(0, PAIRS.full, PAIRS.full // pairs)
    jobs = [(chosen[k : k + BATCH], [*ROUTES, *cgal]) for k in range(0, pairs, BATCH)]
    tally: Counter[str] = Counter()
    faults: list[dict[str, Any]] = []
    counts: Counter[str] = Counter()
    most: dict[str, int] = {}
    for batch in in_processes(work, jobs, what=f"batches of {BATCH} pairs"):
        tally.update(batch["tally"])
        faults += batch["faults"]
        counts.update(batch["counts"])
        most = {key: max(value, most.get(key, 0)) for key, value in batch["most"].items()}
    faults.sort(key=lambda fault: (int(fault["case"].rpartition(":")[2]), fault["target"]))
    wrong = [fault for fault in faults if fault["verdict"] == "wrong"]
    agreed, hole_free = counts["agreed"], counts["free"]
    kinds = Counter(f"{f['target']} {', '.join(f['reasons']) or f['verdict']}" for f in faults)
    findings.figures |= {
        "seed": SEED,
        "pairs": pairs,
        "pairs without holes": hole_free,
        "pairs with holes that cgal-reduced took": counts["holes compared"],
        "largest": {key: value for key, value in most.items() if key != "holes"},
        "tally": dict(sorted(tally.items())),
        "kinds of fault": dict(sorted(kinds.items())),
        "first faults": faults[:40],
    }
    findings.equal("pairs on which the three routes agree", pairs, agreed)
    proven = sum(fault["proven"] for fault in wrong)
    findings.equal("wrong results with a witness that holds", len(wrong), proven)
    undecided = sum(fault["verdict"] == "undecided" for fault in faults)
    findings.none("disagreements left undecided", undecided)
    least = pairs * 3 // 10
    findings.target("pairs without holes", hole_free >= least, f"at least {least}", hole_free)
    bounds = most["most vertices"] <= 12 and most["most holes"] <= 3 and most["extent"] <= 12
    reached = f"{most['most vertices']}, {most['most holes']}, {most['extent']}"
    findings.law("most vertices, holes, extent", bounds, "at most 12, 3, 12", reached)
    for line, count in sorted(kinds.items()):
        findings.note(f"{line}: {count}")
