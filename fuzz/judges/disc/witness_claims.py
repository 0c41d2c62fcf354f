"""Certifies witnesses about sets grown with a disc."""

from __future__ import annotations

import json
from fractions import Fraction

from minkref import _core
from minkref.certify.disc.disc_sum_certificate import DiscSumCertificate
from minkref.fuzz.judges.claimed import Claimed, NoForm, place_text
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Witness


def claimed(case: CaseResult, witness: Witness) -> Claimed:
    """Claims how far the point is from the set. Raises NoForm for joins, erosions and lines, and
    NoProof for a point or a segment."""
    asked, radius = json.loads(case.offset or "")["offset"], Fraction(witness.radius or "0")
    if witness.manner is not None:
        raise NoForm("joins or caps that are not round")
    if radius <= 0:
        raise NoForm("erosions by a disc")
    if "polygons" not in asked:
        raise NoForm("lines that are grown")
    certificate = DiscSumCertificate(_core.PolygonSet.from_json(json.dumps(asked)), radius**2)
    certificate.point((witness.point[0], witness.point[1]))
    (claim,) = certificate.claims
    if (claim["distance"] <= 0) != witness.in_truth:
        raise RuntimeError("the certificate says otherwise")
    than = ("nearer than", "at", "farther than")[claim["distance"] + 1]
    return Claimed(f"{place_text(witness)} is {than} the distance {radius}", certificate)
