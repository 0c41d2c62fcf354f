"""Verdicts on features found by targets."""

from __future__ import annotations

import math
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from minkref import _core
from minkref.errors import cut
from minkref.exact import digest
from minkref.fuzz.features.asked_features import AskedFeatures
from minkref.fuzz.features.claims import Chord, Claim, ClaimedBar, ClaimedFeatures
from minkref.fuzz.features.exact_radius import ExactRadius
from minkref.fuzz.features.matching import unpaired
from minkref.fuzz.features.true_features import NearChord, TrueBar, TrueBridge
from minkref.fuzz.offsets.event_window import event_within
from minkref.fuzz.plane.judgement import REFEREE, too_large, without_answer
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.verdicts.feature_claim import FeatureClaim
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness

PROVED = 4  # among so many cases, one has its truth found by both judges
ROUNDED = Fraction(1, 2**40)  # of the size: ends of bridges are told as numbers near them
DOUBLE = Fraction(1, 2**52)  # of a radius: numbers told in doubles
UNSURE = "the set has too many vertices for a second judge"
Found = tuple[Reason, Witness]


def judge_features(case: AskedFeatures, name: str, answer: Answer) -> list[Outcome]:
    """Pairs told bars with true bars; bars up to twice the tolerance may stay alone. Bridges,
    components, holes count unless an event radius lies within tolerance. Two independent judges
    prove each fault; if they differ, the target is undecided, and an outcome names the referee."""
    try:
        outcome = _judged(case, name, answer)
        if outcome.verdict is not Verdict.WRONG or answer.features is None:
            return [outcome]
        if not case.has_second_opinion:
            return [_undecided(name, answer, UNSURE)]
        doubt = case.second_opinion
        return [outcome] if doubt is None else in_doubt(name, answer, doubt)
    except _core.LimitExceeded as error:
        return [too_large(name, answer, error)]
    except MemoryError:
        return [_undecided(name, answer, "there is too little memory to judge the answer")]


def doubt_about(case: AskedFeatures) -> str | None:
    """Names a difference between both judges; None without. Compares one small case among PROVED,
    chosen by name."""
    if zlib.crc32(case.name.text.encode()) % PROVED or not case.has_second_opinion:
        return None
    return case.second_opinion


def in_doubt(name: str, answer: Answer, message: str) -> list[Outcome]:
    told = cut(f"two judges differ: {message}")
    return [_undecided(name, answer, told), Outcome(REFEREE, Verdict.ERRORED, message=told)]


def _judged(case: AskedFeatures, name: str, answer: Answer) -> Outcome:
    if answer.verdict is Verdict.WRONG:
        return _refuted(case, name, answer, (Reason.REJECTED_VALID, _counts_witness(case, None)))
    if answer.features is None:
        return without_answer(name, answer)
    comparison = _Comparison(case, ClaimedFeatures(answer.features), answer)
    found = comparison.bars() or comparison.at_radius()
    if found is not None:
        return _refuted(case, name, answer, found)
    verdict = Verdict.PASS if answer.declaration.exact else Verdict.PASS_WITHIN
    return Outcome(name, verdict, seconds=answer.seconds, digest=digest(answer.features))


@dataclass(frozen=True)
class _Comparison:
    case: AskedFeatures
    told: ClaimedFeatures
    answer: Answer

    def half(self, radius: float) -> Fraction:
        """A radius's tolerance."""
        declaration, far = self.answer.declaration, Fraction(radius)
        half = declaration.tolerance(self.case.magnitude + far)
        return max(half, far * DOUBLE) if declaration.numbers == "double" else half

    def bars(self) -> Found | None:
        """Finds a bar without partner."""
        true, told = self.case.truth.bars, self.told.bars
        partners = [[k for k, one in enumerate(told) if self._fits(bar, one)] for bar in true]
        lost = unpaired((k for k, bar in enumerate(true) if self._counts(bar)), partners)
        if lost is not None:
            return self._missed(true[lost])
        turned: list[list[int]] = [[] for _ in told]
        for k, numbers in enumerate(partners):
            for number in numbers:
                turned[number].append(k)
        more = unpaired((k for k, bar in enumerate(told) if self._counts(bar)), turned)
        return None if more is None else self._invented(told[more])

    def _counts(self, bar: TrueBar | ClaimedBar) -> bool:
        end: ExactRadius | Claim = bar.birth if bar.death is None else bar.death
        return bar.is_longer(2 * self.half(float(end.high)))

    def _fits(self, bar: TrueBar, told: ClaimedBar) -> bool:
        if (bar.death is None) != (told.death is None):
            return False
        return self._is_near(bar.birth, told.birth) and (
            bar.death is None or told.death is None or self._is_near(bar.death, told.death)
        )

    def _is_near(self, truth: ExactRadius, told: Claim) -> bool:
        half = self.half(truth.near)
        if truth.low > told.high + half or truth.high < told.low - half:
            return False
        return told.is_near(truth, half)

    def _missed(self, bar: TrueBar) -> Found:
        has = sum(bar.text == other.text for other in self.case.truth.bars)
        told = sum(self._fits(bar, one) for one in self.told.bars)
        claim = FeatureClaim("bar", bar.text, has, told, None, *self._ends(bar))
        return Reason.BAR_MISSED, self._witness(bar, claim)

    def _invented(self, told: ClaimedBar) -> Found:
        bars = self.case.truth.bars
        nearest = min(bars, key=lambda bar: _apart(bar, told), default=None)
        has = sum(self._fits(bar, told) for bar in bars)
        told_so = sum(one == told for one in self.told.bars)
        near = nearest.text if nearest else None
        ends = self._ends(nearest) if nearest else ()
        claim = FeatureClaim("bar", told.text, has, told_so, near, *ends)
        return Reason.BAR_INVENTED, self._witness(nearest, claim)

    def _ends(self, bar: TrueBar) -> tuple[tuple[str, ...] | None, tuple[str, ...] | None]:
        places = (self.case.truth.place(node) for node in (bar.leaf, bar.end))
        begins, ends = (None if place is None else _texts(place) for place in places)
        return begins, ends

    def _witness(self, bar: TrueBar | None, claim: FeatureClaim) -> Witness:
        point = claim.ends_at or claim.begins_at or _first_vertex(self.case)
        return Witness(point, claim.in_set > claim.in_answer, feature=claim)

    @cached_property
    def _slack(self) -> Fraction:
        radius = self.case.radius
        return self.half(float(radius)) + ROUNDED * (self.case.magnitude + radius)

    def at_radius(self) -> Found | None:
        """Compares components, holes, bridges, unless an event radius is near."""
        case, value = self.case, self.told.value
        if not value.keys() & {"components", "holes", "bridges"}:
            return None
        half = max(self.half(float(case.radius)), ROUNDED * case.radius)
        if event_within(case.set, case.radius - half, case.radius + half):
            return None
        shape = case.truth.found.regions(str(case.radius**2))
        for word, true, less, more in (
            ("components", shape.components, Reason.COMPONENT, Reason.COMPONENT),
            ("holes", shape.holes, Reason.HOLE_LOST, Reason.HOLE_INVENTED),
        ):
            if word in value and value[word] != true:
                reason = less if value[word] < true else more
                return reason, _counts_witness(case, (word, true, value[word]))
        return None if self.told.bridges is None else self._bridges(self.told.bridges)

    def _bridges(self, told: Sequence[Chord]) -> Found | None:
        true = self.case.truth.bridges(self.case.radius)
        near = [[k for k, chord in enumerate(told) if self._is_chord(b, chord)] for b in true]
        lost = unpaired(range(len(true)), near)
        if lost is not None:
            bridge = true[lost]
            claim = FeatureClaim("bridge", _chord_text(bridge.ends), 1, 0, None, None, None)
            return Reason.BRIDGE_MISSED, Witness(_texts(bridge.centre), True, feature=claim)
        turned = [[k for k, numbers in enumerate(near) if j in numbers] for j in range(len(told))]
        more = unpaired(range(len(told)), turned)
        if more is None:
            return None
        ends = tuple((float(x), float(y)) for x, y in told[more])
        middle = _texts(((ends[0][0] + ends[1][0]) / 2, (ends[0][1] + ends[1][1]) / 2))
        has, told_so = len(turned[more]), sum(chord == told[more] for chord in told)
        claim = FeatureClaim("bridge", _chord_text((ends[0], ends[1])), has, max(told_so, has + 1))
        return Reason.BRIDGE_INVENTED, Witness(middle, False, feature=claim)

    def _is_chord(self, bridge: TrueBridge, chord: Chord) -> bool:
        slack = float(self._slack)
        return any(
            all(
                abs(Fraction(p) - x) <= self._slack
                for (a, b) in zip(ends, chord, strict=True)
                for p, x in zip(a, b, strict=True)
            )
            for ends in (bridge.ends, bridge.ends[::-1])
            if abs(ends[0][0] - float(chord[0][0])) <= 2 * slack
        )


def _apart(bar: TrueBar, told: ClaimedBar) -> float:
    """How far two bars differ."""
    if (bar.death is None) != (told.death is None):
        return math.inf
    birth = abs(bar.birth.near - float(told.birth.low))
    if bar.death is None or told.death is None:
        return birth
    return max(birth, abs(bar.death.near - float(told.death.low)))


def _counts_witness(case: AskedFeatures, counts: tuple[str, int, int] | None) -> Witness:
    point = _first_vertex(case)
    if counts is None:
        return Witness(point, True, feature=FeatureClaim("set", "a valid set", 1, 0))
    word, has, told = counts
    return Witness(point, has > told, feature=FeatureClaim("shape", word, has, told))


def _first_vertex(case: AskedFeatures) -> tuple[str, ...]:
    if case.set.is_empty:
        return "0", "0"
    return tuple(map(str, case.shape[0][0][0]))


def _texts(place: tuple[float, float]) -> tuple[str, str]:
    return str(Fraction(place[0])), str(Fraction(place[1]))


def _chord_text(ends: NearChord) -> str:
    (a, b), (c, d) = ends
    return f"({a!r}, {b!r}) to ({c!r}, {d!r})"


def _refuted(case: AskedFeatures, name: str, answer: Answer, found: Found) -> Outcome:
    reason, witness = found
    return Outcome(
        name,
        Verdict.WRONG,
        (reason,),
        message=cut(answer.message),
        seconds=answer.seconds,
        witness=witness,
        digest=answer.digest,
        expected_digest=digest(case.expected),
        got=answer.text,
    )


def _undecided(name: str, answer: Answer, message: str) -> Outcome:
    if answer.text is None:
        return without_answer(name, answer)
    return Outcome(
        name, Verdict.UNDECIDED, message=message, seconds=answer.seconds,
        digest=answer.digest, got=answer.text,
    )  # fmt: skip
