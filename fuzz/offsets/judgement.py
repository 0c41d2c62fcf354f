"""The verdict on a target's set grown or eroded by a disc."""

from __future__ import annotations

import zlib
from dataclasses import dataclass, replace
from fractions import Fraction

from minkref import _core
from minkref.errors import cut
from minkref.exact import digest
from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.geometry.region import Region
from minkref.fuzz.offsets.asked_offset import AskedOffset
from minkref.fuzz.offsets.curve_witness import CurveWitness
from minkref.fuzz.offsets.curves import NOTHING, counts_of
from minkref.fuzz.offsets.distance_check import holds
from minkref.fuzz.offsets.join_check import holds as shows
from minkref.fuzz.offsets.join_judgement import join_breaches
from minkref.fuzz.offsets.join_pieces import is_plain
from minkref.fuzz.offsets.manner import SHARP
from minkref.fuzz.offsets.sandwich import Breach, Sandwich
from minkref.fuzz.offsets.sharp_front import is_free
from minkref.fuzz.plane.comparison import WitnessRefuted
from minkref.fuzz.plane.judgement import DOUBT, REFEREE, too_large, without_answer
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness

PROVED = 4  # among so many small cases, one has its sum found by both routes
MOST_VERTICES = 60  # of such a case
MOST_PAIRS = 8_000_000  # edges of an answer times edges of the set


def judge_offset(case: AskedOffset, name: str, answer: Answer) -> list[Outcome]:
    """Polygons lie between two sums, with smaller and larger discs; curves are those of the sum.
    A rational point decides, by its exact distance from the set, and plain fractions check it. If
    they refute the reference, the target is undecided, and an outcome names the referee."""
    try:
        return [_judged(case, name, answer)]
    except WitnessRefuted as error:
        return in_doubt(name, answer, f"{DOUBT}: {error}")
    except _core.LimitExceeded as error:
        return [too_large(name, answer, error)]
    except MemoryError:
        return [_undecided(name, answer, "there is too little memory to judge the answer")]


def _judged(case: AskedOffset, name: str, answer: Answer) -> Outcome:
    if answer.verdict is Verdict.WRONG:
        return _refuted(case, name, answer, some_point(case), (Reason.REJECTED_VALID,))
    if answer.curves is None and answer.region is None:
        return without_answer(name, answer)
    half = answer.declaration.offset_tolerance(case.magnitude, abs(case.radius))
    if half >= abs(case.radius):
        message = "its tolerance is not less than the radius"
        return Outcome(name, Verdict.SKIPPED, message=message, seconds=answer.seconds)
    if case.is_nothing:
        return _of_nothing(case, name, answer)
    if not case.manner.is_round and (why := _unjudged(case, answer)):
        return Outcome(name, Verdict.SKIPPED, message=why, seconds=answer.seconds)
    if answer.curves is not None:
        return _Curves(case, name, answer, half).judged(answer.curves)
    assert answer.region is not None
    return _Polygons(case, name, answer, half).judged(answer.region)


def _unjudged(case: AskedOffset, answer: Answer) -> str | None:
    """Why an answer with joins and caps is not judged; None if it is."""
    if answer.curves is not None:
        return "curves have round joins and caps"
    if case.manner.join == SHARP:
        return None
    return None if is_plain(case) else "its joins depend on short sides or nearly straight corners"


@dataclass(frozen=True)
class _Polygons:
    case: AskedOffset
    name: str
    answer: Answer
    half: Fraction

    def judged(self, region: Region) -> Outcome:
        case, half = self.case, self.half
        result: Shape = [[[*ring] for ring in polygon] for polygon in region.set.rings()]
        near = case.near
        if sum(len(r) for p in result for r in p) * len(near.edges) > MOST_PAIRS:
            message = f"more than {MOST_PAIRS:,} pairs of edges are not judged"
            return Outcome(self.name, Verdict.SKIPPED, message=message)
        if case.manner.is_round:
            low, high = abs(case.radius) - half, abs(case.radius) + half
            breaches = Sandwich(near, low, high, result, case.inward).breaches(case.beyond(high))
        else:
            breaches = join_breaches(case, half, region.set)
        if breaches:
            reasons = tuple(dict.fromkeys(self._reason(region, each) for each in breaches))
            witness = witness_of(case, breaches[0], half)
            return _refuted(case, self.name, self.answer, witness, reasons)
        return Outcome(
            self.name, Verdict.PASS_WITHIN, seconds=self.answer.seconds, digest=region.digest
        )

    def _reason(self, region: Region, breach: Breach) -> Reason:
        if not self.case.manner.is_round:
            return Reason.MISSING if breach.missing != self.case.inward else Reason.EXTRA
        components, holes = self.case.counts
        if breach.missing != self.case.inward:
            if region.holes > holes:
                return Reason.HOLE_INVENTED
            lost = breach.whole or region.components < components
            return Reason.COMPONENT if lost and components > 1 else Reason.MISSING
        if breach.whole or region.holes < holes:
            return Reason.HOLE_LOST
        return Reason.COMPONENT if region.components > components else Reason.EXTRA


@dataclass(frozen=True)
class _Curves:
    case: AskedOffset
    name: str
    answer: Answer
    half: Fraction

    def judged(self, curves: str) -> Outcome:
        case, half = self.case, self.half
        truth = case.form
        seconds, own = self.answer.seconds, digest(curves)
        if curves == truth:
            return Outcome(self.name, Verdict.PASS, seconds=seconds, digest=own)
        search = CurveWitness(case.near, curves, truth, abs(case.radius), case.inward)
        found = search.differing_point(half)
        if found is not None:
            witness = witness_of(case, found, half)
            return _refuted(case, self.name, self.answer, witness, (self._reason(curves, found),))
        overlap = search.overlap()
        if overlap is not None:
            square, bound = case.near.of(overlap).square, case.radius**2
            in_truth = square >= bound if case.inward else square <= bound
            witness = _witness(case, overlap, in_truth, Fraction(0))
            return _refuted(case, self.name, self.answer, witness, (Reason.SELF_INTERSECTING,))
        if half and case.has_event(half):
            return Outcome(self.name, Verdict.PASS_WITHIN, seconds=seconds, digest=own)
        return _undecided(self.name, self.answer, "no point tells the curves apart")

    def _reason(self, curves: str, breach: Breach) -> Reason:
        (components, holes), (wanted, wanted_holes) = counts_of(curves), self.case.counts
        if holes != wanted_holes:
            return Reason.HOLE_LOST if holes < wanted_holes else Reason.HOLE_INVENTED
        if components != wanted:
            return Reason.COMPONENT
        return Reason.MISSING if breach.missing != self.case.inward else Reason.EXTRA


def _of_nothing(case: AskedOffset, name: str, answer: Answer) -> Outcome:
    """The empty set grows to nothing, and nothing is left of a set without interior."""
    region = answer.region
    point = None if region is None else _core.inner_point(region.set)
    is_empty = point is None and answer.curves in (None, NOTHING)
    if is_empty:
        return Outcome(name, Verdict.PASS, seconds=answer.seconds, digest=answer.digest)
    x, y = map(Fraction, point or ("0", "0"))
    return _refuted(case, name, answer, _witness(case, (x, y), False, Fraction(0)), (Reason.EXTRA,))


def some_point(case: AskedOffset) -> Witness:
    """A vertex of the set, which an erosion lacks; of the empty set the origin, outside."""
    nothing = (Fraction(0), Fraction(0))
    point = nothing if case.set.is_empty else case.near.origin
    return _witness(case, point, not (case.set.is_empty or case.inward), Fraction(0))


def witness_of(case: AskedOffset, breach: Breach, half: Fraction) -> Witness:
    """Raises WitnessRefuted if plain fractions do not confirm it."""
    return _witness(case, breach.point, breach.missing != case.inward, half)


def _witness(
    case: AskedOffset, point: tuple[Fraction | int, Fraction | int], in_truth: bool, half: Fraction
) -> Witness:
    x, y = map(str, point)
    if case.set.is_empty:
        return Witness((x, y), in_truth, radius=str(case.radius))
    found = case.near.of(point)
    witness = Witness(
        (x, y), in_truth, tolerance=str(half), radius=str(case.radius),
        squared_distance=str(found.square), nearest=found.nearest,
    )  # fmt: skip
    if not case.manner.is_round:
        witness = replace(witness, manner=str(case.manner))
    if not is_proven(case, witness):
        raise WitnessRefuted(f"the point ({x}, {y}) on {case.name.text}")
    return witness


def is_proven(case: AskedOffset, witness: Witness) -> bool:
    """Whether plain fractions confirm the witness. Where parts with sharp corners meet, only the
    points that a disc sweeps are judged."""
    met = case.manner.join == SHARP and not is_free(case, Fraction(witness.tolerance))
    if case.manner.is_round or met:
        return holds(case.P_json, witness)
    return shows(case.literal, witness)


def _refuted(
    case: AskedOffset, name: str, answer: Answer, witness: Witness, reasons: tuple[Reason, ...]
) -> Outcome:
    return Outcome(
        name,
        Verdict.WRONG,
        reasons,
        message=cut(answer.message),
        seconds=answer.seconds,
        witness=witness,
        digest=answer.digest,
        expected_digest=digest(case.form) if case.manner.is_round else None,
        got=answer.text,
    )


def in_doubt(name: str, answer: Answer, message: str) -> list[Outcome]:
    doubt = Outcome(REFEREE, Verdict.ERRORED, message=message)
    return [_undecided(name, answer, message), doubt]


def _undecided(name: str, answer: Answer, message: str) -> Outcome:
    if answer.text is None:
        return without_answer(name, answer)
    return Outcome(
        name, Verdict.UNDECIDED, message=message, seconds=answer.seconds,
        digest=answer.digest, got=answer.text,
    )  # fmt: skip


def doubt_about(case: AskedOffset) -> str | None:
    """Names a difference between both routes of the reference; None if they agree, or without a
    comparison: one small case among PROVED, chosen by name, gets one."""
    if zlib.crc32(case.name.text.encode()) % PROVED or case.set.vertices > MOST_VERTICES:
        return None
    if case.is_nothing or not case.manner.is_round:
        return None
    other = case.by_disc(case.radius, 1, "paper")
    if other.canonical_json() == case.expected.canonical_json():
        return None
    return "the two routes of the reference differ"
