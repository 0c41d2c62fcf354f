"""No false alarm: every `wrong` of a long run is checked again by the slow engine."""

from __future__ import annotations

from minkref.fuzz.judges.witness_check import confirmed
from minkref.reports.evidence.framework.command import counts_of, told, verify
from minkref.reports.evidence.framework.part import CGAL, COMPARISON, READERS, REFERENCE, Findings

SUBJECT = (
    "Twenty minutes over our routes and all CGAL targets, raw ones too: no `wrong` whose witness "
    "fails when the slow engine checks it, none against our own routes."
)
MINUTES = (24, 0.3)
DEPENDS = (*REFERENCE, *READERS, *CGAL, *COMPARISON, "oracle/slow/*.py")

SEED = 2024
SECONDS, QUICK_SECONDS = 1200, 6
ROUTES = tuple(
    f"minkref:{route}" for route in ("paper", "winding", "definition", "dynamic", "index")
)
METHODS = ("reduced", "full", "vertical", "triangulation", "ssab", "optimal", "hertel-mehlhorn")
CGAL_TARGETS = (
    *(f"cgal-{method}" for method in (*METHODS, "greene")),
    *(f"cgal-{method}-raw" for method in ("reduced", "vertical", "triangulation")),
)


def run(findings: Findings, quick: bool) -> None:
    seconds = QUICK_SECONDS if quick else SECONDS
    words = ("minkref", *ROUTES, *CGAL_TARGETS, "--no-models", "--seconds", seconds, "--seed", SEED)
    _, value = verify(*words, "--jobs", 2, "--shrink-calls", 0, seconds=seconds)
    for target in value["targets"]:
        findings.figures[target["name"]] = told(counts_of(value, target["name"]))
    wrong = [finding for finding in value["findings"] if finding["verdict"] == "wrong"]
    large = [finding for finding in wrong if finding["P"]["set"] is None]
    checked = [finding for finding in wrong if finding["P"]["set"] is not None]
    refuted = [finding for finding in checked if not confirmed(finding)]
    findings.figures["wrong"] = len(wrong)
    findings.none("wrongs whose operands the document leaves out", len(large))
    findings.none(f"of {len(checked)} witnesses, refuted by the slow engine", len(refuted))
    for finding in refuted:
        findings.note(f"{finding['target']}: {finding['reproduce']}")
    ours = [finding for finding in value["findings"] if finding["target"] in ROUTES]
    findings.none("findings against our own routes", len(ours))
    undecided = sum(counts_of(value, t).get("undecided", 0) for t in (*ROUTES, *CGAL_TARGETS))
    findings.none("undecided", undecided)
