"""Sums with a factor for each axis by all routes, beside the slow engine and CGAL."""

from __future__ import annotations

from collections import Counter
from typing import Any

from minkref.fuzz.cgal.executables import target_names
from minkref.fuzz.judges.plane import slow_points, slow_sums, slow_tight_passages
from minkref.fuzz.plane.judgement import TRUTHS
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.reports.evidence.framework.comparing import Bench
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.plane_scaling.scaled_pairs import SEED, scaled_pairs

MINUTES = Minutes(0.25, 6, 12)

PAIRS = Counts(30, 2_000, 3_000)
BATCH = 20
JUDGES = {
    "sums": slow_sums.judge,
    "tight passages": slow_tight_passages.judge,
    "points": slow_points.judge,
}
MOST_PAIRS = 400  # of vertices, for the slow engine


def work(job: tuple[range, int, list[str]]) -> dict[str, Any]:
    """Judges a batch of pairs, as a worker process."""
    chosen, count, cgal = job
    tally: Counter[str] = Counter()
    faults: list[str] = []
    with Bench([*TRUTHS, "minkref:dynamic", "minkref:index", *cgal], seconds=20) as bench:
        for index, case in enumerate(scaled_pairs(count)):
            if index not in chosen:
                continue
            tally["pairs"] += 1
            tally["pairs with holes"] += case.P.ring_count + case.Q.ring_count > 2
            for name, outcome in bench.verdicts(case).items():
                tally[f"{name} {outcome.verdict}"] += 1
                witness = outcome.witness
                if outcome.verdict in (Verdict.PASS, Verdict.SKIPPED):
                    continue
                proven = witness is not None and holds(
                    case.P_json, case.Q_json, case.scale, witness
                )
                if name in cgal:
                    tally["faults of CGAL"] += 1
                    tally["faults of CGAL, proven"] += proven
                else:
                    faults.append(f"{case.name.text} {name}: {outcome.verdict}")
            if case.vertex_pairs > MOST_PAIRS:
                continue
            tally["pairs that the slow engine judged"] += 1
            for name, judge in JUDGES.items():
                ruling = judge(case)
                tally[f"slow {name}"] += ruling.compared
                faults += [f"{case.name.text} {name}: {message}" for message in ruling.messages]
    return {"tally": tally, "faults": faults}


def run(findings: Findings, size: Size) -> None:
    count = size.of(PAIRS)
    cgal = [name for name in target_names() if not name.endswith("-raw")]
    if not cgal:
        findings.target("methods of CGAL", False, "at least 1", 0)
    tally: Counter[str] = Counter()
    faults: list[str] = []
    jobs = [(range(k, min(k + BATCH, count)), count, cgal) for k in range(0, count, BATCH)]
    for batch in in_processes(work, jobs, what=f"batches of {BATCH} pairs"):
        tally.update(batch["tally"])
        faults += batch["faults"]
    findings.figures |= {"seed": SEED, "tally": dict(sorted(tally.items())), "faults": faults[:40]}
    findings.equal("pairs asked", count, tally["pairs"])
    findings.none("answers of ours, or of the slow engine, that differ", len(faults))
    proven = tally["faults of CGAL, proven"]
    wrong = sum(n for name, n in tally.items() if name.startswith("cgal-") and "wrong" in name)
    findings.equal("wrong sums of CGAL with a witness that holds", wrong, proven)
    for name in cgal:
        findings.note(f"{name}: {tally[f'{name} pass']} equal, {tally[f'{name} wrong']} wrong")
