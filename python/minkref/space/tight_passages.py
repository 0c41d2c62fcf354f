"""Tight passages of a sum in space."""

from __future__ import annotations

import json
from typing import Any

from minkref import _core
from minkref.errors import refusing
from minkref.space.general_sum import refuse_polygon
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling

NONE: dict[str, Any] = {"lines": [], "points": [], "sheets": []}


def tight_passages(P: SpaceOperand, Q: SpaceOperand, scaling: Scaling) -> dict[str, Any]:
    """All of them, exact (docs/space-sums.md). Refuses a plane polygon, and more pairs of convex
    pieces than are looked at."""
    refuse_polygon(
        "tight passages are not found with a plane polygon", "leave --passages out", P, Q
    )
    found = refusing(
        f"{P.name} and {Q.name}",
        lambda: _core.tight_passages_in_space(P.surface, Q.surface, scaling),
    )
    return dict(json.loads(found))
