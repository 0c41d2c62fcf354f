"""Tight passages against the slow engine, which has them from the definition."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.fuzz.judges.plane.slow_operands import slow_operands, slow_scale
from minkref.fuzz.judges.ruling import Ruling, scales_of
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Reason
from minkref.oracle import slow


def judge(case: Case) -> Ruling:
    """Points and polylines in canonical order, at random scales and at scales of events."""
    ruling = Ruling()
    P, Q = slow_operands(case)
    uniform = case.is_uniform
    scales = scales_of(case, _core.DynamicSum(case.P, case.Q)) if uniform else [case.scale]
    for scale in scales:
        truth = slow.minkowski_sum(P, Q, Fraction(scale) if uniform else slow_scale(case)).tight
        expected = [[(str(x), str(y)) for x, y in piece] for piece in truth]
        ours = [points for points, _ in _core.tight_passages(case.P, case.Q, scale)]
        ruling.compare(
            f"tight passages at {scale}", ours, expected,
            Reason.PASSAGE_MISSED if len(ours) < len(expected) else Reason.PASSAGE_INVENTED,
        )  # fmt: skip
    return ruling
