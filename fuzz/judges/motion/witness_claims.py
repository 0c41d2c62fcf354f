"""Certifies witnesses about parts on paths."""

from __future__ import annotations

import json
from fractions import Fraction

from minkref import _core
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.fuzz.judges.claimed import Claimed
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Witness
from minkref.motion.scale_ranges import ScaleRange


def claimed(case: CaseResult, witness: Witness) -> Claimed:
    """Claims a collision at the witness' scale, or a free path. Raises NoProof without a proof."""
    asked = json.loads(case.path or "")
    part, obstacles = (
        _core.PolygonSet.from_json(json.dumps(asked[name])) for name in ("part", "obstacles")
    )
    certificate = PathCertificate(part, obstacles, asked["path"])
    scale = Fraction(witness.scale or "1")
    claim = certificate.hit if witness.in_truth else certificate.free
    claim(ScaleRange(scale, scale, True, True), asked["contact"])
    what = "collides somewhere" if witness.in_truth else "passes"
    return Claimed(f"at the scale {scale} the part {what} on the path", certificate)
