"""Signs that the float filter hands on, and that plain doubles get wrong."""

from __future__ import annotations

from collections import Counter

from minkref import _core
from minkref.reports.evidence.framework.part import REFERENCE, Findings

SUBJECT = (
    "Sign decisions that the float filter handed on and that plain doubles get wrong: at least "
    "1,000, and none that the filter decided wrongly."
)
MINUTES = (0.1, 0.1)
DEPENDS = REFERENCE

WANTED = 1000
BATCH = 100_000
MOST_BATCHES = 50


def run(findings: Findings, quick: bool) -> None:
    total: Counter[str] = Counter()
    batches = 0
    while batches < MOST_BATCHES and (
        total["doubles_wrong"] < WANTED or not (quick or batches > 9)
    ):
        batches += 1
        total.update(_core.filter_trial(batches, BATCH))
    findings.figures = {"seeds": f"1 to {batches}", "signs a seed": BATCH, **total}
    wrong = total["doubles_wrong"]
    findings.target("handed on, and wrong in doubles", wrong >= WANTED, f"at least {WANTED}", wrong)
    handed = total["handed_on"]
    findings.law("those are among the signs handed on", wrong <= handed, f"at most {handed}", wrong)
    if "filter_wrong" in total:
        bad = total["filter_wrong"]
        findings.none("signs that the filter decided wrongly", bad)
