"""A shrunk case as a case file."""

from __future__ import annotations

import hashlib
import json

from minkref.fuzz.settings import question_of, setting_of
from minkref.fuzz.shrink.finding import SmallFinding


def has_case_file(small: SmallFinding) -> bool:
    setting = setting_of(small.result.dimension)
    return question_of(small.literal) is None and setting.has_case_file(small.literal)


def case_text(small: SmallFinding, target: str) -> str:
    """case-v1 (degeneracies/schema), with what the target does there as a comment."""
    value = json.loads(small.literal)
    content = json.dumps(value, sort_keys=True, separators=(",", ":"))
    outcome = small.outcome
    case = {
        "schema": "case-v1",
        "id": f"shrunk-{hashlib.sha256(content.encode()).hexdigest()[:16]}",
        "title": f"{target}: {outcome.verdict}, {', '.join(outcome.kinds)}",
        "comment": json.dumps(outcome.witness.document()) if outcome.witness else outcome.message,
        "dimension": small.result.dimension,
        "P": value["P"],
        "Q": value["Q"],
        "scales": setting_of(small.result.dimension).scales_of_file(value["scale"]),
    }
    return json.dumps(case, indent=1) + "\n"
