"""Tight passages in space."""

from __future__ import annotations

import json
from typing import Any

from minkref import _core
from minkref.errors import Refusal, refusal_of
from minkref.space.general_sum import refuse_polygon
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling

TOO_MANY = ("too-many-pieces", "too-many-pairs")
LEAVE = "leave --passages out"
NONE: dict[str, Any] = {"lines": [], "points": [], "sheets": []}


def tight_passages(P: SpaceOperand, Q: SpaceOperand, scaling: Scaling) -> dict[str, Any]:
    """Find all tight passages, exactly (docs/space-sums.md). Refuses a plane polygon, and too many
    pairs of convex pieces."""
    refuse_polygon("tight passages are not found with a plane polygon", LEAVE, P, Q)
    try:
        found = _core.tight_passages_in_space(P.surface, Q.surface, scaling)
    except _core.BadInput as error:
        refusal = refusal_of(error, f"{P.name} and {Q.name}")
        if refusal.code in TOO_MANY:  # no other route finds passages
            raise Refusal(refusal.what, refusal.where, LEAVE, refusal.code) from error
        raise refusal from error
    return dict(json.loads(found))
