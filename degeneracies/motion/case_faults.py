"""Checks a case of a path or a trap, with the certificate of each expected answer; the lint makes
its text again from its source."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.degeneracies.case_faults import Claims, of_certificate, of_place
from minkref.degeneracies.motion.case_document import DegeneratePath
from minkref.degeneracies.plane.case_document import content_of
from minkref.degeneracies.plane.draft import sets_in


def case_faults(path: Path, value: dict[str, Any], seen: dict[str, Path]) -> Iterator[str]:
    """Yields a line for each fault."""
    try:
        R, obstacles = sets_in(value, "RO")
    except _core.BadInput as error:
        yield f"{path}: {error}"
        return
    numbers = DegeneratePath.scales_in(value)
    yield from of_place(path, value, content_of(R, obstacles), numbers, seen, value["id"])

    def of_claims(claims: Claims) -> Iterator[str]:
        ((asked, expected),) = value["expected"].items()
        for contact, ranges in expected.items():
            told = [c[asked] for c in claims if asked in c and c["contact"] == contact]
            if told != [ranges]:
                file = path.with_name(value["certificate"])
                yield f"{file}: the scales are not claimed, contact {contact}"

    digest = PathCertificate(R, obstacles, value["path"]).case_digest()
    yield from of_certificate(path, value, digest, of_claims)
