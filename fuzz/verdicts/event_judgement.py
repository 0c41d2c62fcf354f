"""The verdict on the scales that a target lists as those of topology events."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction

from minkref import _core
from minkref.fuzz.cases.case import Case
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.comparison import decide
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict

MOST_PAIRS = 2000  # of vertices


def window(case: Case) -> tuple[str, str]:
    """From half of the scale to twice of it."""
    scale = Fraction(case.scale)
    return str(scale / 2), str(scale * 2)


def judge_events(case: Case, name: str, claimed: list[Fraction], declared: Declaration) -> Outcome:
    """Every scale of an exact target is one of the reference's and the other way round; of a
    rounding one each within its relative tolerance of another. The witness of a missed one is the
    place where it happens, at its scale. Events at the ends of the window may be left out."""
    start, end = window(case)
    moving = _core.DynamicSum(case.P, case.Q, start, end)
    places: dict[Fraction, tuple[str, str]] = {}
    for row in moving.topology_events():
        places.setdefault(Fraction(row[0]), (row[6][0], row[6][1]))
    slack = Fraction(0) if declared.exact else declared.relative * Fraction(end)
    inner = [s for s in places if Fraction(start) < s < Fraction(end)]
    missed = [s for s in inner if not _near(s, claimed, slack)]
    invented = [s for s in claimed if not _near(s, list(places), slack)]
    if not missed and not invented:
        within = not declared.exact and set(claimed) != set(places)
        return Outcome(name, Verdict.PASS_WITHIN if within else Verdict.PASS)
    reasons = ((Reason.EVENT_MISSED,) if missed else ()) + (
        (Reason.EVENT_INVENTED,) if invented else ()
    )
    text = ""
    witness = None
    if missed:
        s = min(missed)
        at = replace(case, scale=str(s), law=None)
        witness = replace(decide(at, places[s]), scale=str(s))
        text = f"the topology changes at {s}, at ({', '.join(places[s])}), which is not listed"
    if invented:
        s = min(invented)
        near = min(places, key=lambda other: abs(other - s), default=None)
        nearest = "there is none" if near is None else f"the nearest is at {near}"
        text += (
            f"{'; ' if text else ''}{s} is listed, where the topology does not change: {nearest}"
        )
        if witness is None:
            at = replace(case, scale=str(s), law=None)
            witness = replace(decide(at, _corner(moving, s)), scale=str(s))
    return Outcome(name, Verdict.WRONG, reasons, message=text, witness=witness)


def _near(scale: Fraction, others: list[Fraction], slack: Fraction) -> bool:
    return any(abs(scale - other) <= slack for other in others)


def _corner(moving: _core.DynamicSum, scale: Fraction) -> tuple[str, str]:
    """A vertex of the sum at the scale: that the sum there is as it is just below and above cannot
    be shown by one point."""
    moving.move_to(str(scale))
    ring = json.loads(moving.sum().region.canonical_json())["polygons"][0]["outer"]
    return (ring[0][0], ring[0][1])
