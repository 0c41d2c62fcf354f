"""`minkref certify P Q` in the plane: a sum, an event, an interval without events, a point."""

from __future__ import annotations

from fractions import Fraction

from minkref import _core
from minkref.certify.plane.certificate import Certificate, NoProof
from minkref.errors import Refusal
from minkref.plane.operand import read_operand
from minkref.verbs.certificate_output import CertificateFiles
from minkref.verbs.certify import CertifyInPlane
from minkref.verbs.certify_answer import Proof, certify
from minkref.verbs.certify_theorem import check_theorem


def run(request: CertifyInPlane) -> None:
    files = CertificateFiles.of(request.output, "-o")
    _check(request)
    if request.theorem is not None:
        check_theorem(request.theorem, _is_of_one_scale(request))
    certify(request, files, lambda: _proof(request), request.theorem)


def _proof(request: CertifyInPlane) -> Proof:
    first, second = read_operand(request.P), read_operand(request.Q)

    def make() -> Certificate:
        axes = request.scale if isinstance(request.scale, tuple) else None
        certificate = Certificate(first.set, second.set, axes)
        try:
            _claim(certificate, request)
        except NoProof as error:
            mend = "`minkref events P Q --kind boundary` (or arrangement) lists the events"
            if error.mend is not None:
                mend = error.mend
            elif request.point is not None:
                mend = "`minkref certify P Q --scale S` proves the whole sum"
            where = f"{first.name} and {second.name}"
            raise Refusal(str(error), where, mend, "no-proof") from error
        if request.theorem is not None:
            _refuse_without_theorem(certificate)
        return certificate

    return Proof([first.file, second.file], make)


def _refuse_without_theorem(certificate: Certificate) -> None:
    """Refuses a point of a sum with a point or a segment: pieces of regions have a theorem."""
    thin = not all(operand.is_region for operand in (certificate.P, certificate.Q))
    if thin and any(claim["claim"] == "point" for claim in certificate.claims):
        what = "there is no theorem about points of a sum with a point or a segment"
        raise Refusal(what, "--theorem", "leave it out: the certificate needs none", "no-proof")


def _check(request: CertifyInPlane) -> None:
    """Refuses options that do not go together."""
    begins, ends = request.from_scale is not None, request.to_scale is not None
    event, degeneracy = request.event is not None, request.degeneracy is not None
    if begins != ends and not event and not degeneracy:
        raise Refusal("an interval has two ends", "options", "give both --from and --to")
    if request.events and not (begins and ends):
        raise Refusal("events are those between two scales", "--events", "give --from and --to")
    if request.all_passages and (request.point is not None or not _is_of_one_scale(request)):
        raise Refusal("passages are those of a sum", "--all-passages", "give --scale, or leave it")
    if request.all_passages and request.theorem is not None:
        what = "there is no theorem about all passages of a sum"
        raise Refusal(what, "--theorem", "leave one of both out", "no-proof")
    of_sum = request.scale is not None or request.point is not None
    alone = event + degeneracy + ends + of_sum <= 1
    if not alone or (begins and not (event or ends)):
        mend = "choose --scale S [--point X,Y], --event S [--from A], [--events] --from A --to B, "
        raise Refusal("these options do not go together", "options", mend + "or --degeneracy S")


def _is_of_one_scale(request: CertifyInPlane) -> bool:
    others = (request.event, request.from_scale, request.to_scale, request.degeneracy)
    return all(option is None for option in others)


def _claim(certificate: Certificate, request: CertifyInPlane) -> None:
    uniform = request.scale is not None and not isinstance(request.scale, tuple)
    scale = str(request.scale) if uniform else "1"
    a, b = request.from_scale, request.to_scale
    if request.event is not None:
        a = _before(certificate, request.event) if a is None else a
        if a >= request.event:
            raise Refusal("this is not below the event", "--from", "give a smaller scale")
        certificate.event(str(request.event), str(a))
    elif a is not None and b is not None:
        if a >= b:
            raise Refusal("the interval is empty", "--to", "give a larger scale than --from")
        claim = certificate.events if request.events else certificate.interval
        claim(str(a), str(b))
    elif request.degeneracy is not None:
        certificate.degeneracy(str(request.degeneracy))
    elif request.point is not None:
        _claim_point(certificate, scale, request.point)
    else:
        certificate.sum(scale, passages=True, complete=request.all_passages)


def _claim_point(certificate: Certificate, scale: str, point: tuple[str, str]) -> None:
    """In the sum, or not."""
    found = _core.decide(certificate.P, certificate.Q, scale, *point)
    claim = certificate.outside if found["contact"] == "empty" else certificate.point
    claim(scale, point)


def _before(certificate: Certificate, scale: Fraction) -> Fraction:
    """The event of the boundary before this one, or half of the scale."""
    dynamic = _core.DynamicSum(certificate.P, certificate.Q, None, str(scale))
    earlier = [Fraction(row[0]) for row in dynamic.boundary_events()]
    return max((s for s in earlier if s < scale), default=scale / 2)
