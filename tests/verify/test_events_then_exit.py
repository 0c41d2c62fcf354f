"""A program may end right after its answer: the answer is judged, and no fault of ours reported."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import Any

import pytest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run.naming import load
from minkref.fuzz.settings import asking_about
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Verdict

PROGRAM = """
import json, sys
for line in sys.stdin:
    asked = json.loads(line)
    answer = {"seq": asked["seq"], "status": "result"}
    if asked["verb"] == "hello":
        answer |= {"protocol": "adapter-v1", "name": "ends", "capabilities": CAPABILITIES}
    elif asked["verb"] == "events":
        answer |= {"scales": SCALES}
    elif asked["verb"] == "at":
        answer = {"seq": asked["seq"], "status": "skipped", "reason": "not now"}
    print(json.dumps(answer), flush=True)
    if asked["verb"] == "events":
        sys.exit(0)
"""
PLANE = ["plane", "non-convex", "holes", "components", "touching", "empty", "point", "segment"]


class SlowToLook(AdapterTarget):
    """Reads the answer only after the program has ended."""

    def asked(self, *about: Any) -> Any:
        found = super().asked(*about)
        time.sleep(1)
        return found


@pytest.mark.parametrize("scales", [[], ["1/1000"]])
def test_a_program_that_ends_after_its_events(tmp_path: Path, scales: list[str]) -> None:
    text = PROGRAM.replace("CAPABILITIES", repr([*PLANE, "rational", "events"]))
    (tmp_path / "ends.py").write_text(text.replace("SCALES", repr(scales)), encoding="utf-8")
    target = SlowToLook("ends", [sys.executable, str(tmp_path / "ends.py")], Limits(seconds=20))
    case = load(CaseName("events(fit:1:0)", "events"))
    try:
        asking = asking_about(case, lambda name: target, lambda step: None, {}, target.limits)
        (outcome,) = asking.outcomes(["ends"])
    finally:
        target.close()
    assert outcome.verdict in (Verdict.PASS, Verdict.WRONG)
