"""Checks a case in space; the lint makes its text again from its source."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.space.convex_certificate import ConvexCertificate
from minkref.degeneracies.case_faults import of_place, of_sums
from minkref.degeneracies.space.body import Body
from minkref.degeneracies.space.case_document import DegenerateInSpace, content_in_space
from minkref.fuzz.geometry.polyhedron import Polyhedron

NAMES = {name: name for name in ("vertices", "facets", "volume", "digest")} | {"scale": "scaling"}


def case_faults(path: Path, value: dict[str, Any], seen: dict[str, Path]) -> Iterator[str]:
    """Yields a line for each fault."""
    try:
        P, Q = (Polyhedron.from_document(value[name]) for name in "PQ")
        certificate = ConvexCertificate(Body(P, "P").surface, Body(Q, "Q").surface)
    except (ValueError, _core.BadInput) as error:
        yield f"{path}: {error}"
        return
    scales = DegenerateInSpace.scales_in(value)
    yield from of_place(path, value, content_in_space(P, Q), scales, seen)
    yield from of_sums(path, value, certificate.case_digest(), NAMES)
