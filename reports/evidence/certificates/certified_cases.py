"""Cases from all families, and certificates for their sums and events."""

from __future__ import annotations

import itertools
import random
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.drawing import around, shape_text
from minkref.fuzz.plane.families.outlines import spiral
from minkref.fuzz.run import naming

# How many vertices the two operands of a small case may have in all.
SMALL = 60


def cases(seed: int, families: tuple[str, ...] = tuple(FAMILIES)) -> Iterator[Case]:
    """Cases from each family in turn, without end: accepted cases with an operand that is a region
    or empty."""
    index = 0
    while True:
        for family in families:
            case = naming.load(CaseName(f"{family}:{seed}:{index}", "evidence"))
            if isinstance(case, Case) and any(o.is_region or o.is_empty for o in (case.P, case.Q)):
                yield case
        index += 1


def events(seed: int, each: int) -> Iterator[tuple[Case, Fraction, Fraction]]:
    """Small cases, scales of events of their boundary from 1/4 to 4, up to `each` a case, and the
    event before it or 1/4."""
    for case in cases(seed):
        if case.P.vertices + case.Q.vertices > SMALL:
            continue
        dynamic = _core.DynamicSum(case.P, case.Q, "1/4", "4")
        scales = sorted({Fraction(1, 4), *(Fraction(row[0]) for row in dynamic.boundary_events())})
        pairs = list(itertools.pairwise(scales))
        dice = random.Random(case.name.text)
        for before, scale in dice.sample(pairs, min(each, len(pairs))):
            yield case, scale, before


def star(corners: int, seed: int) -> _core.PolygonSet:
    """A star-shaped polygon around the origin with radii from 30 to 1000."""
    dice = random.Random(seed)
    ring = []
    for x, y in around(corners, 1000):
        factor = Fraction(dice.randrange(30, 1000), 1000)
        ring.append(f"{float(x * factor)!r} {float(y * factor)!r}")
    return _core.read_text(f"POLYGON(({', '.join([*ring, ring[0]])}))", "wkt", f"star of {corners}")


def wound(vertices: int, pitch: int, wall: Fraction) -> _core.PolygonSet:
    """A spiral."""
    text = shape_text([[spiral(vertices // 2 - 1, pitch, wall)]])
    return _core.read_text(text, "json", f"spiral of {vertices}")


def written(certificate: Certificate, folder: Path, stem: str) -> Path:
    """Writes the certificate with its case beside it."""
    (folder / f"{stem}.case.json").write_text(certificate.case(), encoding="utf-8")
    path = folder / f"{stem}.cert.json"
    path.write_text(certificate.text(f"{stem}.case.json"), encoding="utf-8")
    return path
