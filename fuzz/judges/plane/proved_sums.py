"""Sums and decisions of points against the programs that are extracted from proofs in Coq: what
they answer is proved to be right (docs/proved.md)."""

from __future__ import annotations

import json
from typing import Any

from minkref import _core, proved_program
from minkref.exact import digest
from minkref.fuzz.judges.plane.slow_points import points_of
from minkref.fuzz.judges.ruling import Ruling, scales_of
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Reason, Witness


def judge(case: Case) -> Ruling:
    """Judges digest, components and holes at the case's scale, a random scale and scales of events,
    and random points and points on the sum's boundary."""
    ruling = Ruling()
    for scale in scales_of(case, _core.DynamicSum(case.P, case.Q)):
        ours = _core.minkowski_sum(case.P, case.Q, scale)
        theirs = proved_program.whole_sum(case.P_json, case.Q_json, scale)
        same = ruling.compare(
            f"the sum at {scale}, digest, components and holes",
            (digest(ours.region.canonical_json()), ours.components, ours.holes),
            (theirs["digest"], theirs["components"], theirs["holes"]),
        )
        if not same:
            _explain(ruling, case, scale, ours, theirs)
    points = [(str(x), str(y)) for x, y in points_of(case)]
    if points:
        answers = proved_program.points(case.P_json, case.Q_json, case.scale, points)
        for x, is_in in zip(points, answers, strict=True):
            found = _core.decide(case.P, case.Q, case.scale, *x)["contact"] != "empty"
            wrong = Reason.EXTRA if found else Reason.MISSING
            if not ruling.compare(f"that ({', '.join(x)}) is in the sum", found, is_in, wrong):
                ruling.witness = _witness(case, case.scale, x, is_in)
    return ruling


def _explain(
    ruling: Ruling, case: Case, scale: str, ours: _core.Sum, theirs: dict[str, Any]
) -> None:
    """A point of one of the sums that the proved program decides; else another form of one set."""
    text = json.dumps({"polygons": theirs["polygons"]})
    beside = _core.difference(ours.region, _core.read_text(text, "json", "the judge's sum"))
    if beside is None:
        reason = Reason.COMPONENT
    else:
        x = beside["point"]
        (is_in,) = proved_program.points(case.P_json, case.Q_json, scale, [x])
        ruling.witness = _witness(case, scale, x, is_in)
        reason = Reason.MISSING if is_in else Reason.EXTRA
    if reason not in ruling.reasons:
        ruling.reasons.append(reason)


def _witness(case: Case, scale: str, x: tuple[str, str], is_in: bool) -> Witness:
    found = _core.decide(case.P, case.Q, scale, *x) if is_in else {}
    p, q = (tuple(found[name]) if found.get(name) else None for name in "pq")
    return Witness(x, is_in, p, q, scale)
