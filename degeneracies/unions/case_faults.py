"""Checks a case of a union, with its certificate; the lint makes its text again from its source."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.plane.union_certificate import UnionCertificate
from minkref.degeneracies.case_faults import Claims, of_certificate, of_place
from minkref.degeneracies.plane.draft import valid_sets
from minkref.degeneracies.unions.case_document import content_of
from minkref.exact import digest


def case_faults(path: Path, value: dict[str, Any], seen: dict[str, Path]) -> Iterator[str]:
    """Yields a line for each fault."""
    try:
        texts = {f"set {k}": json.dumps(one) for k, one in enumerate(value["sets"])}
        sets = valid_sets(texts)
    except _core.BadInput as error:
        yield f"{path}: {error}"
        return
    yield from of_place(path, value, content_of(sets), [], seen)

    def of_claims(claims: Claims) -> Iterator[str]:
        told = [{"polygons": c["polygons"]} for c in claims if c["claim"] == "union"]
        digests = [digest(json.dumps(one, sort_keys=True, separators=(",", ":"))) for one in told]
        if digests != [value["expected"]["digest"]]:
            yield f"{path.with_name(value['certificate'])}: the union is not claimed"

    yield from of_certificate(path, value, UnionCertificate(sets).case_digest(), of_claims)
