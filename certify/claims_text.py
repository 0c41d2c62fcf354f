"""The claims of a certificate in a few words."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Any


def shown(certificate: object, claims: Sequence[dict[str, Any]]) -> str:
    """Python's repr of a certificate: its class, and how many claims of each kind."""
    counts = Counter(str(claim["claim"]) for claim in claims)
    told = ", ".join(f"{count} {kind}" for kind, count in counts.items()) or "none"
    return f"<{type(certificate).__name__}: claims {told}>"
