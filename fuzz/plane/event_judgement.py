"""The verdict on the scales of events that a target lists."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import inf, nextafter

from minkref import _core
from minkref.exact import scientific
from minkref.fuzz.cases.verbs import EVENTS, PAIR_EVENTS
from minkref.fuzz.plane.case import Case
from minkref.fuzz.plane.comparison import decide, some_point
from minkref.fuzz.plane.judgement import without_answer
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.targets.declaration import Declaration
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict

MOST_PAIRS = 2000  # pairs of vertices
# The change at an event, and what does not happen at an invented one.
WORDS = {
    EVENTS: ("the topology changes", "the topology does not change"),
    PAIR_EVENTS: (
        "two edges of the convolution begin or cease to meet",
        "no two edges of the convolution begin or cease to meet",
    ),
}
Places = dict[Fraction, tuple[str, str]]
TWO_STEPS = Fraction(1, 2**51)  # relative: twice what lies between a double and the next, at most


def window(case: Case) -> tuple[str, str]:
    """Returns half the scale and twice the scale."""
    scale = Fraction(case.scale)
    return str(scale / 2), str(scale * 2)


def without_scales(case: Case, name: str, answer: Answer) -> Outcome:
    """The outcome if an answer gives a reason instead of a list; WRONG: valid operands were
    rejected."""
    outcome = without_answer(name, answer)
    if outcome.verdict is not Verdict.WRONG:
        return outcome
    return replace(outcome, reasons=(Reason.REJECTED_VALID,), witness=some_point(case))


def judge_events(
    case: Case, name: str, claimed: list[Fraction], declared: Declaration, verb: str = EVENTS
) -> Outcome:
    """Judges a list of scales. An exact target's list must equal the reference's; for a rounding
    target each scale must lie within its tolerance of a counterpart, and vice versa
    (docs/adapter-protocol.md). A missed event's place, with the event's scale, serves as witness.
    Events at the window's ends, or within the tolerance of them, may be left out. Skipped if the
    tolerance reaches the window's size: any list would pass."""
    low, high = map(Fraction, window(case))
    within = Within(declared)
    room = within.room(high)
    if 2 * room >= high - low:
        message = f"a tolerance of {scientific(str(room))} is as large as the window of scales"
        return Outcome(name, Verdict.SKIPPED, message=message)
    wide = (low - room if room < low else low / 2, high + room)
    places = _places(case, verb, *map(str, wide))
    inner = [s for s in places if low + within.room(s) < s < high - within.room(s)]
    claims, scales, reach = sorted(set(claimed)), sorted(places), within.room(wide[1])
    missed = [s for s in inner if not any(map(within(s), _near(claims, s, reach)))]
    invented = [
        listed
        for listed in claims
        if not any(within(s)(listed) for s in _near(scales, listed, reach))
    ]
    if not missed and not invented:
        right = declared.exact or set(inner) <= set(claimed) <= set(places)
        return Outcome(name, Verdict.PASS if right else Verdict.PASS_WITHIN)
    reasons = ((Reason.EVENT_MISSED,) if missed else ()) + (
        (Reason.EVENT_INVENTED,) if invented else ()
    )
    text = ""
    witness = None
    changes, stays = WORDS[verb]
    if missed:
        s = min(missed)
        at = replace(case, scale=str(s), law=None)
        witness = replace(decide(at, places[s]), scale=str(s))
        text = f"{changes} at {s}, at ({', '.join(places[s])}), which is not listed"
    if invented:
        s = min(invented)
        near = min(places, key=lambda other: abs(other - s), default=None)
        nearest = "there is none" if near is None else f"the nearest is at {near}"
        text += f"{'; ' if text else ''}{s} is listed, where {stays}: {nearest}"
        if witness is None:
            # No single point shows that the sum equals the sums just below and above.
            at = replace(case, scale=str(s) if s > 0 else case.scale, law=None)
            witness = replace(some_point(at), scale=at.scale)
    return Outcome(name, Verdict.WRONG, reasons, message=text, witness=witness)


def _places(case: Case, verb: str, start: str, end: str) -> Places:
    """The exact scales of a window's events, each with the place of one."""
    places: Places = {}
    if verb == PAIR_EVENTS:
        found = _core.pair_events(case.P, case.Q, start, end)
        for scale, *_, at, _to in found.rows(0, len(found)):
            places.setdefault(Fraction(scale), at)
        return places
    for row in _core.DynamicSum(case.P, case.Q, start, end).topology_events():
        places.setdefault(Fraction(row[0]), (row[6][0], row[6][1]))
    return places


def _near(ascending: Sequence[Fraction], at: Fraction, reach: Fraction) -> Sequence[Fraction]:
    """The numbers at most `reach` from a number."""
    first = bisect_left(ascending, at - reach)
    last = first
    while last < len(ascending) and ascending[last] <= at + reach:
        last += 1
    return ascending[first:last]


@dataclass(frozen=True)
class Within:
    """Whether a listed scale may stand for an event's scale."""

    declared: Declaration

    def slack(self, scale: Fraction) -> Fraction:
        return self.declared.tolerance(scale)

    def room(self, scale: Fraction) -> Fraction:
        """At least what listed scales up to this may be off."""
        return self.slack(scale) + (scale * TWO_STEPS if self.declared.numbers == "double" else 0)

    def __call__(self, scale: Fraction) -> Callable[[Fraction], bool]:
        slack, beside = self.slack(scale), self.beside(scale)
        return lambda listed: abs(listed - scale) <= slack or listed in beside

    def beside(self, scale: Fraction) -> set[Fraction]:
        """The greatest double not above a scale, and the least not below, if the target's numbers
        are doubles: even an exact target cannot say more then."""
        if self.declared.numbers != "double":
            return set()
        try:
            near = float(scale)
        except OverflowError:
            return set()
        doubles = [
            Fraction(x) for x in (nextafter(near, 0.0), near, nextafter(near, inf)) if x < inf
        ]
        below, above = [x for x in doubles if x <= scale], [x for x in doubles if x >= scale]
        return {*below[-1:], *above[:1]}
