"""The verdict on a target's union."""

from __future__ import annotations

import zlib

from minkref import _core
from minkref.fuzz.plane.comparison import WitnessRefuted
from minkref.fuzz.plane.exact_shapes import shape_of
from minkref.fuzz.plane.judgement import (
    DOUBT,
    REFEREE,
    compared,
    rejected,
    too_large,
    undecided,
    without_answer,
)
from minkref.fuzz.targets.answer import Answer
from minkref.fuzz.unions.asked_union import AskedUnion
from minkref.fuzz.unions.side_check import wrong_side
from minkref.fuzz.unions.union_witness import UnionOf, some_point
from minkref.fuzz.verdicts.verdict import Outcome, Verdict, Witness

PROVED = 4  # among so many cases, one has its union proved by `side_check`
MOST_EDGES = 60  # of all sets and their union, for a proof in some tenths of a second


def judge_union(case: AskedUnion, name: str, answer: Answer) -> list[Outcome]:
    """Compares a target's union with that of the reference: equal as sets, or within the tolerance;
    else a point decides, which the definition alone judges, twice. If the definition refutes the
    reference, the target is undecided, and an outcome names the referee."""
    try:
        found = _judged(case, name, answer)
    except WitnessRefuted as error:
        return in_doubt(name, answer, f"{DOUBT}: {error}")
    except _core.LimitExceeded as error:
        return [too_large(name, answer, error)]
    except MemoryError:
        return [undecided(name, answer, "there is too little memory to judge the answer")]
    if isinstance(found, Witness):
        point = ", ".join(found.point)
        return in_doubt(name, answer, f"the union of the reference is refuted at ({point})")
    return [found]


def _judged(case: AskedUnion, name: str, answer: Answer) -> Outcome | Witness:
    if answer.verdict is Verdict.WRONG:
        return rejected(name, answer, some_point(case), case.expected)
    if answer.region is None:
        return without_answer(name, answer)
    half = answer.declaration.tolerance(case.magnitude)
    return compared(name, answer, case.expected, UnionOf(case), half)


def in_doubt(name: str, answer: Answer, message: str) -> list[Outcome]:
    doubt = Outcome(REFEREE, Verdict.ERRORED, message=message)
    return [undecided(name, answer, message), doubt]


def doubt_about(case: AskedUnion) -> str | None:
    """Says where the reference's union is wrong; None if proved right, or without a proof: one
    small case among PROVED, chosen by name, gets a proof."""
    if zlib.crc32(case.name.text.encode()) % PROVED:
        return None
    if case.vertices + case.expected.set.vertices > MOST_EDGES:
        return None
    sets = [shape_of(each) for each in case.sets if each.is_region]
    at = wrong_side(sets, shape_of(case.expected.set))
    return None if at is None else f"the union of the reference is wrong beside ({at[0]}, {at[1]})"
