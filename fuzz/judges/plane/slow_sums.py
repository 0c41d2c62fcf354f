"""Sums by every route against the slow engine, at random scales and at scales of events."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.geometry.plane import is_uniform, scale_factors
from minkref.fuzz.judges.plane.slow_operands import slow_operand, slow_operands
from minkref.fuzz.judges.ruling import Ruling, scales_of
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Reason, Witness
from minkref.oracle import slow


def judge(case: Case) -> Ruling:
    """Digest, components, holes, by the routes paper, winding, definition, dynamic and index, and
    by updates of the full convolution with its winding numbers."""
    ruling = Ruling()
    P, Q = slow_operands(case)
    if not case.is_uniform:
        _compare(ruling, P, Q, case.scale, _by_axes(case))
        return ruling
    dynamic = _core.DynamicSum(case.P, case.Q)
    full = _core.DynamicSum(case.P, case.Q, None, None, "winding")
    index = _core.ScaleIndex(case.P, case.Q)
    for scale in scales_of(case, dynamic):
        dynamic.move_to(scale)
        full.move_to(scale)
        sums = {route: _core.minkowski_sum(case.P, case.Q, scale, route) for route in _core.ROUTES}
        sums["dynamic"] = dynamic.sum()
        sums["dynamic, by winding numbers"] = full.sum()
        sums["index"] = index.sum(scale)
        _compare(ruling, P, Q, scale, sums)
    return ruling


def _by_axes(case: Case) -> dict[str, _core.Sum]:
    """The sums with a factor for each axis; of convex operands also by update."""
    sums = {r: _core.minkowski_sum(case.P, case.Q, case.scale, r) for r in _core.ROUTES}
    if case.P.is_convex and case.Q.is_convex:
        moving = _core.DynamicPolygonSum(case.P, case.Q, "1")
        moving.update(case.scale)
        sums["dynamic"] = moving.sum()
    return sums


def _compare(
    ruling: Ruling, P: slow.Operand, Q: slow.Operand, scale: str, sums: dict[str, _core.Sum]
) -> None:
    """With a factor for each axis, P is scaled already."""
    truth = slow.minkowski_sum(P, Q, Fraction(scale) if is_uniform(scale) else Fraction(1))
    expected = (truth.digest, truth.components, truth.holes)
    for route, ours in sums.items():
        text = ours.region.canonical_json()
        same = ruling.compare(
            f"route {route} at {scale}, digest, components and holes",
            (digest(text), ours.components, ours.holes),
            expected,
        )
        if not same:
            _explain(ruling, P, Q, scale, text, ours, truth)


def _explain(
    ruling: Ruling,
    P: slow.Operand,
    Q: slow.Operand,
    scale: str,
    text: str,
    ours: _core.Sum,
    truth: slow.Sum,
) -> None:
    uniform = is_uniform(scale)
    at = Fraction(scale) if uniform else Fraction(1)
    claim = slow.check_claim(P, Q, at, slow_operand(text))
    if claim.point is None:
        reason = Reason.COMPONENT
        if claim.equal and not claim.canonical:
            reason = Reason.NOT_CANONICAL
        elif ours.holes != truth.holes:
            reason = Reason.HOLE_LOST if ours.holes < truth.holes else Reason.HOLE_INVENTED
    else:
        reason = Reason.MISSING if claim.in_truth else Reason.EXTRA
        assert claim.proof is not None
        p, q = claim.proof.p, claim.proof.q
        if p is not None and not uniform:
            x, y = scale_factors(scale)
            p = (p[0] / x, p[1] / y)
        ruling.witness = Witness(
            _text(claim.point),
            claim.in_truth,
            _text(p) if p is not None else None,
            _text(q) if q is not None else None,
            scale,
        )
    if reason not in ruling.reasons:
        ruling.reasons.append(reason)


def _text(point: tuple[Fraction, Fraction]) -> tuple[str, str]:
    return str(point[0]), str(point[1])
