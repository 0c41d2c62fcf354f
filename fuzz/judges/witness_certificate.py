"""Certificates of witnesses: a claim about one point with a proof, for independent checkers."""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any

from minkref.certify.plane.certificate import NoProof
from minkref.errors import Refusal, cut, message_of
from minkref.fuzz.judges.claimed import NO_FORM, Claimed, NoForm
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Reason
from minkref.oracle.checker import check as checker
from minkref.output.documents import scratch_folder
from minkref.output.terminal import escaped

MOST_VERTICES = 5000  # of both operands: a few seconds to make, and to check in Python
LIMITS = 60.0, 1e9, 2.0**28  # of seconds, of tests, of bytes


@dataclass(frozen=True)
class WitnessCertificate:
    """A certificate, the case, and the claim in words; or a reason for having no certificate.
    Files are called `name`, with two endings."""

    name: str
    claim: str = ""
    text: str = ""
    case: str = ""
    why_none: str = ""

    @property
    def file(self) -> str | None:
        """The name of the certificate's file, or None."""
        return f"{self.name}.cert.json" if self.text else None

    @property
    def files(self) -> dict[str, str]:
        """The files' contents by name."""
        both = {f"{self.name}.cert.json": self.text, f"{self.name}.case.json": self.case}
        return both if self.text else {}

    def document(self) -> dict[str, str | None]:
        """The member `certificate` for documents of `verify`."""
        return {"file": self.file, "claim": self.claim or None, "why_none": self.why_none or None}


def certificate_of(finding: Finding, name: str) -> WitnessCertificate | None:
    """Certifies a finding's witness and runs the checker in Python on the certificate, whose files
    will be called `name`. None for a finding without witness. The claim leaves out tolerances:
    the point alone counts. Exact; costs a point, not a sum."""
    witness, case = finding.outcome.witness, finding.case
    if witness is None or case.P is None or case.Q is None:
        return None
    try:
        claimed = _claimed(finding)
        said = f"{finding.outcome.target}, {', '.join(finding.outcome.kinds)}: {claimed.words}"
        title = escaped(cut(said))
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


def is_true(case: Any, claim: Any) -> bool:
    """Asks a judge without proofs about a certificate's claim on one point of a sum. Takes JSON
    values."""
    room = "space" if "scaling" in claim else "plane"
    judged: bool = import_module(f"minkref.fuzz.judges.{room}.witness_claims").is_true(case, claim)
    return judged


def _room_of(case: CaseResult) -> str:
    """Names the folder for this kind of case."""
    if case.path is not None:
        return "motion"
    if case.offset is not None:
        return "disc"
    return "space" if case.dimension == 3 else "plane"
