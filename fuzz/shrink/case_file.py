"""A shrunk case as a case file."""

from __future__ import annotations

import hashlib
import json

from minkref.fuzz.shrink.finding import SmallFinding
from minkref.fuzz.space.hull import is_convex
from minkref.fuzz.space.polyhedron import Polyhedron


def has_case_file(small: SmallFinding) -> bool:
    """In space only convex operands have one."""
    if small.result.dimension == 2:
        return True
    value = json.loads(small.literal)
    return all(is_convex(Polyhedron.from_document(value[name])) for name in "PQ")


def case_text(small: SmallFinding, target: str) -> str:
    """case-v1 (degeneracies/schema), with what the target does there as a comment."""
    value = json.loads(small.literal)
    content = json.dumps(value, sort_keys=True, separators=(",", ":"))
    outcome = small.outcome
    factors = value["scale"].split(",")
    spatial = small.result.dimension == 3
    case = {
        "schema": "case-v1",
        "id": f"shrunk-{hashlib.sha256(content.encode()).hexdigest()[:16]}",
        "title": f"{target}: {outcome.verdict}, {', '.join(outcome.kinds)}",
        "comment": json.dumps(outcome.witness.document()) if outcome.witness else outcome.message,
        "dimension": small.result.dimension,
        "P": value["P"],
        "Q": value["Q"],
        "scales": [factors if len(factors) == 3 else factors * 3] if spatial else factors,
    }
    return json.dumps(case, indent=1) + "\n"
