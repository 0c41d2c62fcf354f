"""Certificates of witnesses: a claim about one point, with its proof, for checkers that share
nothing with the suite."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Protocol

from minkref import _core
from minkref.certify.disc.disc_sum_certificate import DiscSumCertificate
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.certify.plane.certificate import Certificate, NoProof
from minkref.certify.plane.union_certificate import UnionCertificate
from minkref.errors import cut, message_of
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Reason, Witness
from minkref.motion.scale_ranges import ScaleRange
from minkref.oracle.checker import check as checker
from minkref.output.documents import scratch_folder

MOST_VERTICES = 5000  # of both operands: a few seconds to make, and to check in Python
NO_FORM = "no form of certificate for this"
LIMITS = 60.0, 1e9, 2.0**28  # of seconds, of tests, of bytes


class NoForm(Exception):
    """No certificate can state the witness."""


class AnyCertificate(Protocol):
    def case(self) -> str: ...

    def text(self, case: str, title: str = "", producer: str = "") -> str: ...


@dataclass(frozen=True)
class WitnessCertificate:
    """A certificate, its case, and the claim in words; or the reason why there is none. `name`: of
    the files without their endings."""

    name: str
    claim: str = ""
    text: str = ""
    case: str = ""
    why_none: str = ""

    @property
    def file(self) -> str | None:
        """The name of the certificate's file; None if there is none."""
        return f"{self.name}.cert.json" if self.text else None

    @property
    def files(self) -> dict[str, str]:
        """The files' contents by name."""
        both = {f"{self.name}.cert.json": self.text, f"{self.name}.case.json": self.case}
        return both if self.text else {}

    def document(self) -> dict[str, str | None]:
        """As the JSON document of `verify` has it."""
        return {"file": self.file, "claim": self.claim or None, "why_none": self.why_none or None}


def certificate_of(finding: Finding, name: str) -> WitnessCertificate | None:
    """The certificate of a finding's witness, verified by the checker in Python; `name`: of its
    files. None for a finding without a witness. The tolerance is left out: the claim is about the
    point itself. Exact; the cost is a point's, not the sum's."""
    witness, case = finding.outcome.witness, finding.case
    if witness is None or case.P is None or case.Q is None:
        return None
    try:
        claim, certificate = _claimed(finding, case, witness)
        title = f"{finding.outcome.target}, {', '.join(finding.outcome.kinds)}: {claim}"
        text, beside = certificate.text(f"{name}.case.json", title), certificate.case()
        _check(text, beside, name)
    except NoForm as reason:
        return WitnessCertificate(name, why_none=str(reason))
    except NoProof as reason:
        return WitnessCertificate(name, why_none=f"{NO_FORM}: {reason}")
    except Exception as error:  # noqa: BLE001 a fault of ours costs no report
        return WitnessCertificate(name, why_none=f"a fault of minkref: {cut(message_of(error))}")
    return WitnessCertificate(name, claim, text, beside)


def _check(text: str, case: str, name: str) -> None:
    """Raises RuntimeError if the checker in Python does not verify the certificate."""
    with scratch_folder() as folder:
        (folder / f"{name}.case.json").write_text(case, encoding="utf-8")
        (path := folder / f"{name}.cert.json").write_text(text, encoding="utf-8")
        code, why, _ = checker.verdict(path, None, LIMITS, checker.FILES)
    if code != checker.VERIFIED:
        raise RuntimeError(f"a certificate that is not verified: {why}")


def _claimed(finding: Finding, case: CaseResult, witness: Witness) -> tuple[str, AnyCertificate]:
    """The claim in words, and the certificate. Raises NoForm, and NoProof where the producer finds
    none."""
    if Reason.ACCEPTED_INVALID in finding.outcome.reasons:
        raise NoForm(f"{NO_FORM}: an operand is invalid, and has no sum")
    if witness.feature is not None:
        raise NoForm(f"{NO_FORM}: the witness is about features")
    if case.size[0] > MOST_VERTICES:
        raise NoForm(f"the operands have more than {MOST_VERTICES:,} vertices")
    question = next((ask for asked, ask in QUESTIONS if asked(case)), None)
    if question is not None:
        return question(json.loads(case.literal or ""), witness)
    if case.dimension == 3:
        raise NoForm(f"{NO_FORM}: points of sums in space")
    return _sum_in_plane(case, witness)


def _sum_in_plane(case: CaseResult, witness: Witness) -> tuple[str, AnyCertificate]:
    if witness.boundary:
        raise NoForm(f"{NO_FORM}: the sum of the boundaries is meant")
    assert case.P is not None and case.Q is not None
    scale = witness.scale or case.scale
    axes = scale.split(",") if "," in scale else None
    operands = _core.PolygonSet.from_json(case.P), _core.PolygonSet.from_json(case.Q)
    certificate = Certificate(*operands, axes)
    claim = certificate.point if witness.in_truth else certificate.outside
    claim("1" if axes else scale, (witness.point[0], witness.point[1]))
    side = "inside" if witness.in_truth else "outside"
    return f"{_place(witness)} is {side} the sum at {scale}", certificate


def _union(asked: Any, witness: Witness) -> tuple[str, AnyCertificate]:
    sets = [_core.PolygonSet.from_json(json.dumps(one)) for one in asked["sets"]]
    if any(one.rings() and not one.is_region for one in sets):
        raise NoForm(f"{NO_FORM}: a set is a point or a segment")
    certificate = UnionCertificate(sets)
    certificate.point(witness.point)
    (claim,) = certificate.claims
    holders = [*claim["inside"], *claim["on"]]
    if bool(holders) != witness.in_truth:
        raise RuntimeError("the certificate says otherwise")
    whose = f"in set {holders[0]}" if holders else "in none of the sets"
    return f"{_place(witness)} is {whose}", certificate


def _offset(asked: Any, witness: Witness) -> tuple[str, AnyCertificate]:
    radius = Fraction(witness.radius or "0")
    if witness.manner is not None:
        raise NoForm(f"{NO_FORM}: joins or caps that are not round")
    if radius <= 0:
        raise NoForm(f"{NO_FORM}: erosions by a disc")
    if "polygons" not in asked["offset"]:
        raise NoForm(f"{NO_FORM}: lines that are grown")
    grown = _core.PolygonSet.from_json(json.dumps(asked["offset"]))
    certificate = DiscSumCertificate(grown, radius**2)
    certificate.point((witness.point[0], witness.point[1]))
    (claim,) = certificate.claims
    if (claim["distance"] <= 0) != witness.in_truth:
        raise RuntimeError("the certificate says otherwise")
    than = ("nearer than", "at", "farther than")[claim["distance"] + 1]
    return f"{_place(witness)} is {than} the distance {radius}", certificate


def _path(asked: Any, witness: Witness) -> tuple[str, AnyCertificate]:
    part, obstacles = (
        _core.PolygonSet.from_json(json.dumps(asked[name])) for name in ("part", "obstacles")
    )
    certificate = PathCertificate(part, obstacles, asked["path"])
    scale = Fraction(witness.scale or "1")
    claim = certificate.hit if witness.in_truth else certificate.free
    claim(ScaleRange(scale, scale, True, True), asked["contact"])
    what = "collides somewhere" if witness.in_truth else "passes"
    return f"at the scale {scale} the part {what} on the path", certificate


def _place(witness: Witness) -> str:
    return f"({', '.join(witness.point)})"


Ask = Callable[[Any, Witness], tuple[str, AnyCertificate]]
QUESTIONS: tuple[tuple[Callable[[CaseResult], Any], Ask], ...] = (
    (lambda case: case.path, _path),
    (lambda case: case.union, _union),
    (lambda case: case.offset, _offset),
)
