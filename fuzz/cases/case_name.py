"""Names for cases."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class CaseName:
    """A text that reproduces a case (`fuzz/run/naming.py`), cheap to send to a worker, and the
    column of the matrix that it belongs to."""

    text: str
    group: str
