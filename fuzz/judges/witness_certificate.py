"""Certificates of witnesses: a claim about one point, with its proof, for checkers that share
nothing with the suite."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module

from minkref.certify.plane.certificate import NoProof
from minkref.errors import Refusal, cut, message_of
from minkref.fuzz.judges.claimed import NO_FORM, Claimed, NoForm
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Reason
from minkref.oracle.checker import check as checker
from minkref.output.documents import scratch_folder

MOST_VERTICES = 5000  # of both operands: a few seconds to make, and to check in Python
LIMITS = 60.0, 1e9, 2.0**28  # of seconds, of tests, of bytes


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
        claimed = _claimed(finding)
        title = f"{finding.outcome.target}, {', '.join(finding.outcome.kinds)}: {claimed.words}"
        certificate = claimed.certificate
        text, beside = certificate.text(f"{name}.case.json", title), certificate.case()
        _check(text, beside, name)
    except NoForm as reason:
        return WitnessCertificate(name, why_none=str(reason))
    except NoProof as reason:
        return WitnessCertificate(name, why_none=f"{NO_FORM}: {reason}")
    except Exception as error:  # noqa: BLE001 a fault of ours costs no report
        if isinstance(error, Refusal) and error.code == "too-large":
            return WitnessCertificate(name, why_none=error.what)
        return WitnessCertificate(name, why_none=f"a fault of minkref: {cut(message_of(error))}")
    return WitnessCertificate(name, claimed.words, text, beside)


def _check(text: str, case: str, name: str) -> None:
    """Raises RuntimeError if the checker in Python does not verify the certificate."""
    with scratch_folder() as folder:
        (folder / f"{name}.case.json").write_text(case, encoding="utf-8")
        (path := folder / f"{name}.cert.json").write_text(text, encoding="utf-8")
        code, why, _ = checker.verdict(path, None, LIMITS, checker.FILES)
    if code != checker.VERIFIED:
        raise RuntimeError(f"a certificate that is not verified: {why}")


def _claimed(finding: Finding) -> Claimed:
    """Raises NoForm, and NoProof where the producer finds none."""
    witness, case = finding.outcome.witness, finding.case
    assert witness is not None
    if Reason.ACCEPTED_INVALID in finding.outcome.reasons:
        raise NoForm("an operand is invalid, and has no sum")
    if witness.feature is not None:
        raise NoForm("the witness is about features")
    if case.size[0] > MOST_VERTICES:
        raise NoForm(f"the operands have more than {MOST_VERTICES:,} vertices")
    module = import_module(f"minkref.fuzz.judges.{_room_of(case)}.witness_claims")
    claimed: Claimed = module.claimed(case, witness)
    return claimed


def _room_of(case: CaseResult) -> str:
    """The folder that certifies witnesses about this kind of case; loaded when it is needed."""
    if case.path is not None:
        return "motion"
    if case.offset is not None:
        return "disc"
    return "space" if case.dimension == 3 else "plane"
