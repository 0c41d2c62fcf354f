"""Checks a case in the plane; the lint makes its text again from its source."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.case_text import case_digest
from minkref.degeneracies.case_faults import of_place, of_sums
from minkref.degeneracies.plane.case_document import content_of
from minkref.degeneracies.plane.draft import sets_in

NAMES = {name: name for name in ("scale", "components", "holes", "digest")}


def case_faults(path: Path, value: dict[str, Any], seen: dict[str, Path]) -> Iterator[str]:
    """Yields a line for each fault."""
    try:
        P, Q = sets_in(value, "PQ")
    except _core.BadInput as error:
        yield f"{path}: {error}"
        return
    yield from of_place(path, value, content_of(P, Q), value["scales"], seen)
    yield from of_sums(path, value, case_digest(P, Q), NAMES)
