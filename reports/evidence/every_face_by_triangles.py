"""One interior point of every face of the arrangement, decided from the definition."""

from __future__ import annotations

import random
import time
from collections import Counter

from minkref import _core
from minkref.fuzz.verdict import Witness
from minkref.fuzz.witness import holds
from minkref.reports.evidence.framework.operands import case_of, tell_absent
from minkref.reports.evidence.framework.part import MODELS, READERS, REFERENCE, Findings

SUBJECT = (
    "monkey + bird at scale 1: one interior point of every face of the arrangement decided by "
    "pairs of triangles; the sum has exactly the faces whose points overlap."
)
MINUTES = (6, 1)
DEPENDS = (*REFERENCE, *READERS, *MODELS, "fuzz/witness.py")

SAMPLE = 20_000  # faces of a quick run
SPOT_CHECKS = 5  # decisions of each kind checked again in plain Python fractions
SEED = 7


def spot_check(findings: Findings, faces: list[tuple[str, str, bool]]) -> None:
    """Some of the decisions again, by code that shares nothing with them."""
    case = case_of("monkey", "bird", "1")
    right = tried = 0
    for wanted in (True, False):
        for x, y, _ in [face for face in faces if face[2] == wanted][:SPOT_CHECKS]:
            answer = _core.decide(case.P, case.Q, case.scale, x, y)
            inside = answer["contact"] != "empty"
            p, q = (tuple(answer[k]) if inside else None for k in ("p", "q"))
            tried += 1
            right += holds(case.P_json, case.Q_json, "1", Witness((x, y), inside, p, q))
    findings.law("decisions checked in plain fractions", right == tried, tried, right)


def run(quick: bool) -> Findings:
    findings = Findings()
    tell_absent(findings, "monkey", "bird")
    case = case_of("monkey", "bird", "1")
    faces = list(_core.face_points(case.P, case.Q, case.scale))
    every = len(faces)
    random.Random(SEED).shuffle(faces)
    faces = faces[:SAMPLE] if quick else faces
    print(f"{len(faces)} of {every} faces", flush=True)
    began = time.monotonic()
    contacts = _core.decide_many(case.P, case.Q, case.scale, [(x, y) for x, y, _ in faces])
    seconds = time.monotonic() - began
    tally = Counter(
        f"{'in the sum' if face[2] else 'outside'}, {contact}"
        for face, contact in zip(faces, contacts, strict=True)
    )
    right = tally["in the sum, overlapping"] + tally["outside, empty"]
    findings.figures = {
        "pair": case.name.text,
        "faces": every,
        "decided": len(faces),
        "seconds": round(seconds, 1),
        "tally": dict(sorted(tally.items())),
    }
    findings.law("faces decided as the sum has them", right == len(faces), len(faces), right)
    findings.target("faces", every >= 1000, "at least 1000", every)
    spot_check(findings, faces)
    return findings
