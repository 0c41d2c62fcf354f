"""The printed interval of Sec. 4.2.3 against the corrected one on the paper's pairs."""

from __future__ import annotations

from minkref import _core
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import MODELS, READERS, REFERENCE, Findings

SUBJECT = (
    "The interval of scales in which two edges meet, as printed ([max{B_a0, B_b0}, min{B_a1, "
    "B_b1}], on exact roots) against the corrected one, over all pairs of edges of monkey + bird "
    "and disc1 + neuron."
)
MINUTES = (0.6, 0.1)
DEPENDS = (*REFERENCE, *READERS, *MODELS)

#: pairs that meet on an interval; of them right as printed, each of the four solves having a root
COUNTED = {("disc1", "neuron"): (76_761, 0), ("monkey", "bird"): (1_535_530, 320_918)}


def run(findings: Findings, quick: bool) -> None:
    for names, (meeting, right) in COUNTED.items():
        if quick and names != ("disc1", "neuron"):
            continue
        P, Q = (operand(name) for name in names)
        counts = dict(_core.compare_forms(P.set, Q.set))
        title = f"{P.name} + {Q.name}"
        findings.figures[title] = counts
        share = counts["printed_right"] / max(counts["intersecting"], 1)
        findings.law(
            f"{title}: the printed rule is not the right one",
            counts["printed_right"] < counts["intersecting"],
            f"fewer than {counts['intersecting']}", f"{counts['printed_right']} ({share:.1%})",
        )  # fmt: skip
        if tell_absent(findings, *names):
            got = (counts["intersecting"], counts["printed_right_by_roots"])
            findings.target(
                f"{title}: meeting pairs, of them right where each solve has a root",
                got == (meeting, right), f"{meeting}, {right}", f"{got[0]}, {got[1]}",
            )  # fmt: skip
    findings.note(
        "where a solve is an identity or has no solution the printed text gives no bound; taken "
        "so, it is right on some pairs more (`printed_right`)"
    )
