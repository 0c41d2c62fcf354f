"""The paper's pairs against CGAL's triangulation method, which shares nothing with convolutions."""

from __future__ import annotations

from minkref.fuzz.verdicts.verdict import Verdict
from minkref.reports.evidence.framework.comparing import Bench, available_cgal
from minkref.reports.evidence.framework.operands import REAL_PAIRS, case_of, tell_absent
from minkref.reports.evidence.framework.part import AGAINST_CGAL, Findings

SUBJECT = "disc1 + neuron, disc5 + neuron, monkey + bird at one scale each by CGAL's triangulation."
MINUTES = (3, 0.2)
DEPENDS = AGAINST_CGAL

TRIANGULATION = "cgal-triangulation"


def run(findings: Findings, quick: bool) -> None:
    cgal = available_cgal(findings, TRIANGULATION)
    if not cgal:
        return
    pairs = REAL_PAIRS[:1] if quick else REAL_PAIRS
    tell_absent(findings, *(name for pair in pairs for name in pair if "disc" not in name))
    with Bench(["minkref:paper", TRIANGULATION], seconds=1200, gigabytes=12) as bench:
        for first, second in pairs:
            case = case_of(first, second, "1")
            outcome = bench.verdicts(case)[TRIANGULATION]
            findings.figures[case.name.text] = {
                "verdict": str(outcome.verdict),
                "message": outcome.message,
                "seconds": outcome.seconds,
                "digest": outcome.digest,
            }
            same = outcome.verdict is Verdict.PASS
            decided = same or outcome.verdict is Verdict.WRONG
            if decided:
                findings.law(case.name.text, same, "one digest", outcome.verdict)
            else:
                findings.target(case.name.text, False, "one digest", outcome.message)
