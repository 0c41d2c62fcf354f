"""A target is asked for the scales at which a part passes along a path."""

from __future__ import annotations

from typing import Any

from minkref.fuzz.cases.verbs import PATH
from minkref.fuzz.motion.asked_path import AskedPath
from minkref.fuzz.motion.path_claim import PathClaim
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.targets.numbers import Unreadable, received_scale, sent_number
from minkref.motion.scale_ranges import ScaleRange


def asked_claim(target: AdapterTarget, case: AskedPath) -> tuple[PathClaim, Declaration] | Answer:
    """Returns the target's claim on a path's scales, and its declaration; else the answer without
    claim."""

    def fields(declaration: Declaration) -> dict[str, Any]:
        path = [[sent_number(axis, declaration) for axis in point] for point in case.path]
        return {"path": path, "contact": case.contact, **case.asked}

    def read(value: dict[str, Any], declaration: Declaration) -> PathClaim:
        return _claim(case, value, declaration)

    return target.asked(case, PATH, fields, read)


def _claim(case: AskedPath, value: dict[str, Any], declaration: Declaration) -> PathClaim:
    """Reads a claim. Raises Unreadable for anything else."""
    if case.window is None:
        valid = value.get("valid")
        if not isinstance(valid, list) or not all(isinstance(one, bool) for one in valid):
            raise Unreadable("valid is not a list of true and false")
        if len(valid) != len(case.scales):
            raise Unreadable(f"valid has {len(valid)} entries for {len(case.scales)} scales")
        return PathClaim(tuple(valid))
    ranges = value.get("ranges")
    if not isinstance(ranges, list) or not all(isinstance(one, dict) for one in ranges):
        raise Unreadable("ranges is not a list of objects")
    return PathClaim(ranges=tuple(_range(one, declaration) for one in ranges))


def _range(value: dict[str, Any], declaration: Declaration) -> ScaleRange:
    """Reads a range, which contains its ends unless the target says otherwise; a missing end
    defaults to the window's."""
    if "from" not in value:
        raise Unreadable("a range has no from")
    low, high = (
        None if value.get(word) is None else received_scale(value[word], declaration)
        for word in ("from", "to")
    )
    ends_in = [value.get(word, True) for word in ("from_in", "to_in")]
    if low is None or not all(isinstance(one, bool) for one in ends_in):
        raise Unreadable("a range has from, to, from_in and to_in")
    if high is not None and high < low:
        raise Unreadable("a range ends before it begins")
    return ScaleRange(low, high, ends_in[0], ends_in[1])
