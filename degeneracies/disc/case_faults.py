"""Checks a case with a disc, with its certificate; the lint makes both again from their source."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.case_text import set_digest
from minkref.degeneracies.case_faults import Claims, of_certificate, of_place
from minkref.degeneracies.plane.case_document import set_content
from minkref.degeneracies.plane.draft import sets_in


def case_faults(path: Path, value: dict[str, Any], seen: dict[str, Path]) -> Iterator[str]:
    """Yields a line for each fault."""
    try:
        (P,) = sets_in(value, "P")
    except _core.BadInput as error:
        yield f"{path}: {error}"
        return
    squares = value["squared_radii"]
    yield from of_place(path, value, json.dumps(set_content(P)), squares, seen)
    if [row["squared_radius"] for row in value["expected"]] != squares:
        yield f"{path}: not each radius has its expected result"

    def of_claims(claims: Claims) -> Iterator[str]:
        first = value["expected"][0]
        told = [(one["digest"], one["holes"]) for one in claims if one["claim"] == "sum"]
        if told != [(first["digest"], first["holes"])]:
            yield f"{path}: the sum that is expected at the disc's radius is not certified"

    yield from of_certificate(path, value, set_digest(P), of_claims)
