"""Pairs of solids from all families, small enough for the slow engine to compute their whole
sum."""

from __future__ import annotations

from collections.abc import Iterator

from minkref import _core
from minkref.certify.space.solid_certificate import SolidCertificate
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.general_pairs import GeneralPair, general_pair


def solid_pairs(seed: int) -> Iterator[GeneralPair]:
    """Pairs from each family in turn, without end; both operands have a volume."""
    index = 0
    while True:
        pair = general_pair(seed, index)
        if not (pair.P.is_thin or pair.Q.is_thin or len(pair.P.faces) < 2 or len(pair.Q.faces) < 2):
            yield pair
        index += 1


def surface(body: Polyhedron) -> _core.Polyhedron:
    value = body.document()
    return _core.Polyhedron([tuple(vertex) for vertex in value["vertices"]], value["faces"])


def certified(pair: GeneralPair) -> SolidCertificate:
    certificate = SolidCertificate(surface(pair.P), surface(pair.Q))
    scale = str(pair.scale)
    certificate.sum((scale, scale, scale))
    return certificate
