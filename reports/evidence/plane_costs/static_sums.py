"""Times the static sum by the paper's route and by CGAL's reduced convolution, interleaved."""

from __future__ import annotations

import multiprocessing
from multiprocessing.connection import Connection
from statistics import median
from typing import Any

from minkref import _core
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.fuzz.plane.case import Case
from minkref.reports.evidence.framework.comparing import available_cgal
from minkref.reports.evidence.framework.operands import REAL_PAIRS, case_of, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.3, 0.3)
ALONE = True

REPETITIONS = Counts(3, 7, 7)


def _send_seconds(case: Case, out: Connection) -> None:
    out.send(_core.minkowski_sum(case.P, case.Q, case.scale).seconds)


def ours_in_child(case: Case) -> float:
    """Seconds of our sum in a forked child: cold caches and heap, as the oracle's child has."""
    context = multiprocessing.get_context("fork")
    receiver, sender = context.Pipe(duplex=False)
    child = context.Process(target=_send_seconds, args=(case, sender))
    child.start()
    sender.close()
    seconds = float(receiver.recv())
    child.join()
    return seconds


def spread(times: list[float]) -> dict[str, Any]:
    return {"median": median(times), "least": min(times), "most": max(times), "all": times}


def run(findings: Findings, size: Size) -> None:
    if not available_cgal(findings, "cgal-reduced"):
        return
    tell_absent(findings, "monkey", "bird", "neuron")
    repetitions = size.of(REPETITIONS)
    with CgalOracle("reduced", seconds=60) as oracle:
        for first, second in REAL_PAIRS:
            case = case_of(first, second, "1")
            ours, theirs, warm = [], [], []
            oracle.sum(case.scaled_P_json, case.Q_json)
            for _ in range(repetitions):
                ours.append(ours_in_child(case))
                answer = oracle.sum(case.scaled_P_json, case.Q_json)
                if answer.status == "result" and answer.seconds is not None:
                    theirs.append(answer.seconds)
                warm.append(_core.minkowski_sum(case.P, case.Q, case.scale).seconds)
            if len(theirs) < repetitions:
                findings.target(case.name.text, False, "answers of CGAL", answer.reason)
                continue
            ratio = median(ours) / median(theirs)
            findings.figures[case.name.text] = {
                "repetitions": repetitions,
                "ours": spread(ours),
                "ours, in a warm process": spread(warm),
                "cgal-reduced": spread(theirs),
                "ratio": ratio,
                "ratios of the pairs of runs": [a / b for a, b in zip(ours, theirs, strict=True)],
            }
            reached = f"{ratio:.2f} ({median(ours):.4f} s to {median(theirs):.4f} s)"
            findings.target(f"{case.name.text}, ours to CGAL's", ratio <= 1, "at most 1", reached)
    findings.note("CGAL's exact numbers are lazy: its time leaves out evaluating coordinates; ours "
                  "has the canonical form in it")  # fmt: skip
