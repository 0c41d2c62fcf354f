"""Decides an interior point of every arrangement face from the definition."""

from __future__ import annotations

import time
from collections import Counter

from minkref import _core
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.witness import holds
from minkref.fuzz.verdicts.verdict import Witness
from minkref.reports.evidence.framework.operands import SCALES, case_of, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.6, 1)

DISCS = Counts(1, 2, 2)
MOST_SPOT_CHECKS = 5  # decisions per kind checked again with plain Python fractions


def spot_check(findings: Findings, case: Case, faces: list[tuple[str, str, bool]]) -> None:
    """Repeats some decisions with independent code."""
    right = tried = 0
    for wanted in (True, False):
        for x, y, _ in [face for face in faces if face[2] == wanted][:MOST_SPOT_CHECKS]:
            answer = _core.decide(case.P, case.Q, case.scale, x, y)
            inside = answer["contact"] != "empty"
            p, q = (tuple(answer[k]) if inside else None for k in ("p", "q"))
            tried += 1
            right += holds(case.P_json, case.Q_json, case.scale, Witness((x, y), inside, p, q))
    findings.equal(f"{case.name.text}: decisions checked in plain fractions", tried, right)


def check(findings: Findings, case: Case) -> None:
    faces = list(_core.face_points(case.P, case.Q, case.scale))
    began = time.monotonic()
    contacts = _core.decide_many(case.P, case.Q, case.scale, [(x, y) for x, y, _ in faces])
    seconds = time.monotonic() - began
    tally = Counter(
        f"{'in the sum' if face[2] else 'outside'}, {contact}"
        for face, contact in zip(faces, contacts, strict=True)
    )
    right = tally["in the sum, overlapping"] + tally["outside, empty"]
    findings.figures[case.name.text] = {
        "faces": len(faces),
        "seconds": round(seconds, 1),
        "tally": dict(sorted(tally.items())),
    }
    print(case.name.text, findings.figures[case.name.text], flush=True)
    findings.law(
        f"{case.name.text}: faces decided as the sum has them",
        right == len(faces) > 0,
        len(faces),
        right,
    )
    spot_check(findings, case, faces)


def run(findings: Findings, size: Size) -> None:
    tell_absent(findings, "neuron")
    for disc in ("disc1", "disc5")[: size.of(DISCS)]:
        check(findings, case_of(disc, "neuron", "1"))
    if size is not Size.QUICK:
        tell_absent(findings, "monkey", "bird")
        for scale in SCALES:
            check(findings, case_of("monkey", "bird", scale))
