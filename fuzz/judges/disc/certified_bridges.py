"""Checks bridge certificates (docs/certificates-features.md) in doubles; draws some."""

from __future__ import annotations

import json
import math
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certify.disc.bridge_certificate import BridgeCertificate
from minkref.fuzz.features.feature_draws import drawn_set, set_of

ROUNDED = 1e-9  # of the radius
ELSEWHERE = Fraction(1, 9)  # of the radius: away from an event
Spot = tuple[float, float]
Value = dict[str, Any]


def drawn_certificate(seed: int, number: int) -> BridgeCertificate | None:
    """Draws claims at event radii or beside; None without claim."""
    _, shape = drawn_set(seed, number)
    P = set_of(shape)
    found = _core.features(P)
    if not found.radii:
        return None
    near = Fraction(found.radius(1 + number % found.radii)[0]).limit_denominator(1000)
    radius = (near or Fraction(1, 7)) * (1 + ELSEWHERE * (number % 4 - 1))
    certificate = BridgeCertificate(P, radius)
    certificate.bridges(found)
    certificate.touches()
    return certificate if certificate.claims else None


def is_true(certificate: Value, case: Value) -> bool:
    """Whether named features lie at radius distance, other edges not nearer."""
    rings = [
        [_spot(point) for point in ring]
        for polygon in case["P"]["polygons"]
        for ring in (polygon["outer"], *(polygon.get("holes") or []))
    ]
    edges = [(a, b) for ring in rings for a, b in zip(ring, ring[1:] + ring[:1], strict=True)]
    radius = math.sqrt(Fraction(certificate["square"]))
    return all(_holds(claim, edges, radius) for claim in certificate["claims"])


def _holds(claim: Value, edges: list[tuple[Spot, Spot]], radius: float) -> bool:
    if claim["claim"] == "bridge":
        p, u, w = map(_spot, claim["box"])
        centre = p[0] + (u[0] + w[0]) / 2, p[1] + (u[1] + w[1]) / 2
        slack, named = math.hypot(*u) + math.hypot(*w), [claim["left"], claim["right"]]
    else:
        centre, slack, named = _spot(claim["centre"]), 0.0, claim["features"]
    slack += ROUNDED * (radius + math.hypot(*centre))
    far = [_distance(centre, *edge) for edge in edges]
    own = [math.dist(centre, edges[n][0]) if kind == "vertex" else far[n] for kind, n in named]
    return min(far) >= radius - slack and all(abs(one - radius) <= slack for one in own)


def made(certificate: BridgeCertificate) -> tuple[Value, Value]:
    """Certificate and case as JSON values."""
    return json.loads(certificate.text("case.json")), json.loads(certificate.case())


def _spot(point: Any) -> Spot:
    x, y = (float(Fraction(c)) for c in point)
    return x, y


def _distance(p: Spot, a: Spot, b: Spot) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)
    t = min(max(t, 0.0), 1.0)
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)
