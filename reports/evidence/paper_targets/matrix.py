"""The paper's programs beside CGAL and the exact routes, in one matrix of `minkref verify`: all
possible questions asked, each wrong answer with a witness."""

from __future__ import annotations

from typing import Any

from minkref.fuzz.libraries.paper.program_name import PREFIX
from minkref.reports.evidence.framework.command import counts_of, told, verify
from minkref.reports.evidence.framework.comparing import available_cgal
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import FOLDER
from minkref.reports.evidence.paper_targets.chosen_cases import exists, plane_cases, space_cases

RESTS_ON = ("fuzz/adapters/", "fuzz/libraries/")
MINUTES = Minutes(0.3, 2, 20)

EXACT = f"{PREFIX}@rational,corrected"
PROGRAMS = tuple(
    f"{PREFIX}@{name}" for name in ("mpfr:53", "mpfr:200", "double", "double,static", "rational")
)
CGAL = ("cgal-reduced", "cgal-triangulation", "cgal-nef")
OURS = ("minkref:paper", "minkref:dynamic", "minkref:convex", "minkref:edges")
CASES, SOLIDS, SECONDS = Counts(20, 100, None), Counts(6, 30, None), 60
# Questions beyond every program: events of sums without area or with many pairs of edges, laws
# without consequence for a case, verbs of no program.
NO_QUESTION = (
    "does not declare", "no events are known", "more than", "the law says nothing",
    "as large as the window",
)  # fmt: skip


def run(findings: Findings, size: Size) -> None:
    cgal = available_cgal(findings, *CGAL)
    targets = [EXACT, *PROGRAMS, *OURS, *cgal]
    words = ["--seed", 61, "--jobs", 2, "--no-models", "--shrink-calls", 0]
    words += ["--report", FOLDER / "paper_targets"]
    cases, solids = size.of(CASES), size.of(SOLIDS)
    if cases is None or solids is None:
        words += ["--suite", "all", "--seconds", SECONDS]
    else:
        names = [*plane_cases(cases), *space_cases(solids)]
        asked = [f"{verb}({name})" for verb in ("update", "pair-events") for name in names[:4]]
        updates = filter(exists, asked)
        words += [word for name in (*names, *updates) for word in ("--case", name)]
    _, value = verify(*targets, *words, seconds=3600)
    for target in value["targets"]:
        counts = counts_of(value, target["name"])
        findings.figures[target["name"]] = told(counts)
        findings.note(f"{target['name']}: {told(counts)}")
    findings.figures["cases"] = sum(group["cases"] for group in value["groups"])
    _judge(findings, value)


def _judge(findings: Findings, value: dict[str, Any]) -> None:
    exact = counts_of(value, EXACT)
    findings.law(f"{EXACT}: passes", exact.get("pass", 0) > 0, "some", exact.get("pass", 0))
    amiss = {verdict: n for verdict, n in exact.items() if verdict not in GOOD}
    findings.none(f"{EXACT}: answers that are wrong or break down", told(amiss) and [told(amiss)])
    papers = [finding for finding in value["findings"] if finding["target"].startswith(PREFIX)]
    wrong = [finding for finding in papers if finding["verdict"] == "wrong"]
    findings.law("wrong answers of the paper's programs", bool(wrong), "some", len(wrong))
    without = [finding["reproduce"] for finding in wrong if not finding["witness"]]
    findings.none("wrong answers without a witness", without)
    broken = [
        f"{finding['verdict']}: {finding['reproduce']}"
        for finding in papers
        if finding["verdict"] not in ("wrong", "gave-up")
    ]
    findings.none("answers of the paper's programs that break down", broken)
    left_out = [
        f"{row['target']}: {reason}, {count}"
        for row in value["matrix"]
        if row["target"].startswith(PREFIX)
        for reason, count in row["skips"].items()
        if not any(words in reason for words in NO_QUESTION)
    ]
    findings.none("cases that the paper's programs could have been asked, and were not", left_out)


GOOD = ("pass", "pass-within", "gave-up", "skipped")
