"""One target's outcome on one case: verdict, reasons, witness."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import StrEnum
from typing import Any

from minkref.errors import cut
from minkref.fuzz.verdicts.feature_claim import FeatureClaim


class Verdict(StrEnum):
    PASS = "pass"
    PASS_WITHIN = "pass-within"  # inside the target's declared tolerance
    WRONG = "wrong"
    KNOWN = "known"  # listed by the baseline, whatever it was before
    ERRORED = "errored"
    CRASHED = "crashed"
    TIMED_OUT = "timed-out"
    OUT_OF_MEMORY = "out-of-memory"
    GAVE_UP = "gave-up"  # the target says that it cannot tell
    UNDECIDED = "undecided"
    SKIPPED = "skipped"


GOOD = (Verdict.PASS, Verdict.PASS_WITHIN)
BROKEN = (Verdict.CRASHED, Verdict.TIMED_OUT, Verdict.OUT_OF_MEMORY, Verdict.ERRORED)


class Reason(StrEnum):
    MISSING = "missing"  # the result lacks a point of the sum
    EXTRA = "extra"  # the result has a point outside the sum
    HOLE_LOST = "hole-lost"  # the result fills a hole of the sum
    HOLE_INVENTED = "hole-invented"  # the result has a hole inside the sum
    COMPONENT = "component"  # a component of the sum is missing, or an extra component exists
    NOT_CLOSED = "not-closed"  # a ring whose vertices lie on one line
    SELF_INTERSECTING = "self-intersecting"  # rings overlap or cross; of CGAL: run the wrong way
    NOT_CANONICAL = "not-canonical"  # the right set, but not with the canonical rings
    EVENT_MISSED = "event-missed"
    EVENT_INVENTED = "event-invented"
    EVENT_MISPLACED = "event-misplaced"  # another change, another place, other features
    STATE_DRIFT = "state-drift"  # an updated state differs from the true state
    NONDETERMINISTIC = "nondeterministic"  # another answer to the same question
    ACCEPTED_INVALID = "accepted-invalid"  # a result for invalid operands
    REJECTED_VALID = "rejected-valid"  # valid operands called invalid
    PASSAGE_MISSED = "passage-missed"  # a tight passage
    PASSAGE_INVENTED = "passage-invented"
    BAR_MISSED = "bar-missed"  # a feature's life
    BAR_INVENTED = "bar-invented"
    BRIDGE_MISSED = "bridge-missed"  # of a feature, at the radius that is asked about
    BRIDGE_INVENTED = "bridge-invented"
    COLLISION_MISSED = "collision-missed"  # a scale at which a part collides is called valid
    COLLISION_INVENTED = "collision-invented"  # a valid scale is not


@dataclass(frozen=True)
class Witness:
    """A point that a reader can check by hand. Inside: scale p + q = point, p in P, q in Q.
    Outside: P scaled does not meet the set of all point - q. For a union, the number of a set with
    the point, or none. For an offset, the squared distance from the set. With a tolerance, the
    whole square (in space the cube) with this half side around the point lies inside, or outside;
    for an offset, at each radius that differs by at most so much."""

    point: tuple[str, ...]
    in_truth: bool
    p: tuple[str, ...] | None = None
    q: tuple[str, ...] | None = None
    scale: str | None = None  # if it differs from the case's
    tolerance: str = "0"
    boundary: bool = False  # p and q lie on the boundaries of P and Q, whose sum is meant
    contact: str | None = None  # for a path: the rule; `point` is on the path, point + s p = q
    on_path: tuple[str, str] | None = None  # the segment, and how far along it
    sets: int | None = None  # for a union: how many sets it unites; p and q are None
    of_set: int | None = None  # the number of a set with the point, from 1; None if no set has it
    radius: str | None = None  # of an offset; p and q are None
    manner: str | None = None  # joins and caps, if not all are round
    squared_distance: str | None = None  # from the set that is grown
    nearest: tuple[str, ...] | None = None  # its feature: "inside", "vertex" x y, "edge" x y x y
    feature: FeatureClaim | None = None  # bars, bridges or counts; `point` shows where
    places: int | None = None  # at none of so many, which decide for all, the part collides

    def document(self) -> dict[str, Any]:
        value: dict[str, Any] = {
            "point": list(self.point),
            "in_truth": self.in_truth,
            "p": list(self.p) if self.p else None,
            "q": list(self.q) if self.q else None,
        }
        if self.tolerance != "0":
            value["tolerance"] = self.tolerance
        if self.boundary:
            value["sum"] = "boundary"
        if self.contact is not None:
            on_path = list(self.on_path) if self.on_path else None
            value |= {"contact": self.contact, "on_path": on_path, "places": self.places}
        if self.sets is not None:
            value |= {"sets": self.sets, "of_set": self.of_set}
        if self.radius is not None:
            nearest = list(self.nearest) if self.nearest else None
            value |= {"radius": self.radius, "squared_distance": self.squared_distance}
            value["nearest"] = nearest
        if self.manner is not None:
            value["manner"] = self.manner
        if self.feature is not None:
            value["feature"] = self.feature.document()
        return value if self.scale is None else {**value, "scale": self.scale}


@dataclass(frozen=True)
class Outcome:
    """A target's outcome on a case. `got` holds the canonical result as JSON text, unless it
    passed."""

    target: str
    verdict: Verdict
    reasons: tuple[Reason, ...] = ()
    message: str = ""
    signal: str | None = None
    seconds: float = 0.0
    witness: Witness | None = None
    digest: str | None = None
    expected_digest: str | None = None
    got: str | None = None
    was: Verdict | None = None  # the verdict that the baseline turned into `known`
    log: str = ""  # the end of what the target wrote to standard error

    @property
    def kinds(self) -> tuple[str, ...]:
        """The names in a baseline entry: the reasons of a wrong result, else the verdict."""
        verdict = self.was or self.verdict
        if verdict is Verdict.WRONG:
            return tuple(str(reason) for reason in self.reasons)
        return (str(verdict),)

    def known(self, message: str) -> Outcome:
        return replace(self, verdict=Verdict.KNOWN, was=self.verdict, message=cut(message))
