"""The paper's update in space (Section 5), followed literally in several arithmetics: exact in
rational numbers with all readings corrected, and which sentence to blame elsewhere."""

from __future__ import annotations

import random
from collections import Counter
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.general_pairs import general_pair
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.space.commands.paper_update import limit_of, significant_bits

MINUTES = Minutes(1, 6, 30)

SEED = 2012
SUMS = Counts(4, 10, 10)  # of each pair, half of them at events
PAIRS = Counts(4, 24, 100)
MOST_FACETS = 110  # of the convolution: the program looks at all pairs
BLAMED = Counts(1, 2, 8)
BLAMED_SUMS = 4
ROUNDING = ("mpfr:24", "double", "mpfr:53", "mpfr:100", "mpfr:200")
CORRECTED = {name: corrected for name, _, corrected, _ in _core.space_update_readings()}
PRINTED = {name: values[0] for name, values, *_ in _core.space_update_readings()}
ALL_CORRECTED = "all corrected"
VARIANTS = {
    ALL_CORRECTED: CORRECTED,
    **{
        f"{name} as printed": CORRECTED | {name: PRINTED[name]}
        for name in CORRECTED
        if PRINTED[name] != CORRECTED[name]
    },
    "corner and solve as printed": CORRECTED | {"corner": "lines", "solve": "printed"},
    "crossing and solve as printed": CORRECTED | {"crossing": "points", "solve": "printed"},
    "parallel left out": CORRECTED | {"parallel": "left-out"},
    "bounds as printed, singular too": CORRECTED | {"bounds": "checked", "singular": "determinant"},
    "coplanar left out": CORRECTED | {"coplanar": "left-out"},
    "all as printed": PRINTED,
}


@dataclass(frozen=True)
class Exact:
    """Sums of one pair in rational numbers, all corrected."""

    name: str
    facets: int
    events: int
    sums: int
    wrong: tuple[str, ...]


@dataclass(frozen=True)
class Task:
    index: int
    arithmetic: str


@dataclass(frozen=True)
class Blame:
    variant: str
    arithmetic: str
    events: dict[str, int]
    right: int
    undecided: int
    wrong: str | None  # a witness


def solids(index: int) -> tuple[str, _core.Polyhedron, _core.Polyhedron]:
    pair = general_pair(SEED, index)
    return pair.name, core_polyhedron(pair.P), core_polyhedron(pair.Q)


def indices(count: int) -> list[int]:
    """The first pairs of solids whose convolution is small enough."""
    found: list[int] = []
    index = 0
    while len(found) < count:
        _, P, Q = solids(index)
        if min(P.faces, Q.faces) > 1 and _facets(P, Q) <= MOST_FACETS:
            found.append(index)
        index += 1
    return found


def _facets(P: _core.Polyhedron, Q: _core.Polyhedron) -> int:
    return _core.edge_sum_with_statistics(P, Q, ("1", "1", "1"))[1]["convolution_facets"]


def scales(update: _core.PaperSpaceUpdate, count: int, name: str, at_events: bool) -> list[str]:
    """Random scales in random order; half of them events, if asked for."""
    dice = random.Random(f"minkref paper in space {name}")
    every = sorted({Fraction(scale) for scale in update.event_scales()})
    if len(every) < 2:
        return [str(Fraction(dice.randint(1, 40), 10)) for _ in range(count)]
    chosen = []
    for number in range(count):
        k = dice.randrange(len(every) - 1)
        between = (every[k] + every[k + 1]) / 2
        chosen.append(str(every[k] if at_events and number % 2 else between))
    return chosen


def exactly(task: tuple[int, int]) -> Exact:
    index, count = task
    name, P, Q = solids(index)
    update = _core.PaperSpaceUpdate(P, Q, "1", "rational", CORRECTED)
    wrong = []
    chosen = scales(update, count, name, True)
    for scale in chosen:
        update.move_to(scale)
        if update.sum().set() != _core.edge_sum_in_space(P, Q, (scale, scale, scale)):
            wrong.append(f"{name} at {scale}")
    counts = dict(update.counts())
    return Exact(name, counts["facets"], counts["events"], len(chosen), tuple(wrong))


def blame(task: Task) -> list[Blame]:
    """All variants on one pair in one arithmetic."""
    name, P, Q = solids(task.index)
    truth = _core.PaperSpaceUpdate(P, Q, "1", "rational", CORRECTED)
    bits = significant_bits(task.arithmetic)
    chosen = scales(truth, BLAMED_SUMS, name, bits is None)
    rows = []
    for variant, readings in VARIANTS.items():
        update = _core.PaperSpaceUpdate(P, Q, "1", task.arithmetic, readings)
        right = undecided = 0
        wrong = None
        for scale in chosen:
            update.move_to(scale)
            try:
                same, _, _, witness = update.beside_exact(update.sum(), limit_of(bits))
            except _core.UndecidedSign:
                undecided += 1
                continue
            right += same
            if witness is not None and wrong is None:
                wrong = f"{name} at {scale}: ({', '.join(witness[0])})"
        events = dict(update.event_trial(truth, bits or 0))
        rows.append(Blame(variant, task.arithmetic, events, right, undecided, wrong))
    return rows


def run(findings: Findings, size: Size) -> None:
    chosen = indices(size.of(PAIRS))
    _laws(list(in_processes(exactly, [(index, size.of(SUMS)) for index in chosen], 10)), findings)
    tasks = [
        Task(index, arithmetic)
        for index in chosen[: size.of(BLAMED)]
        for arithmetic in ("rational", *ROUNDING)
    ]
    _blamed([row for rows in in_processes(blame, tasks, 5) for row in rows], findings)


def _laws(rows: list[Exact], findings: Findings) -> None:
    sums = sum(row.sums for row in rows)
    findings.note(
        f"{len(rows)} pairs, the convolutions with {min(row.facets for row in rows)} to "
        f"{max(row.facets for row in rows)} facets and {max(row.events for row in rows):,} events "
        f"at most; {sums:,} sums, half of them at events, in random order"
    )
    findings.none(
        f"all corrected, rational: of {sums:,} sums those that are not the exact ones",
        [wrong for row in rows for wrong in row.wrong],
    )


def _blamed(rows: list[Blame], findings: Findings) -> None:
    table: dict[str, dict[str, str]] = {}
    for variant in VARIANTS:
        for arithmetic in ("rational", *ROUNDING):
            mine = [r for r in rows if (r.variant, r.arithmetic) == (variant, arithmetic)]
            if not mine:
                continue
            events: Counter[str] = Counter()
            for row in mine:
                events.update(row.events)
            right, asked = sum(row.right for row in mine), BLAMED_SUMS * len(mine)
            undecided = sum(row.undecided for row in mine)
            told = (
                f"{right} of {asked} sums right"
                + (f" ({undecided} undecided)" if undecided else "")
                + f"; of {events['events']:,} events {events['right']:,} right, "
                f"{events['misplaced']:,} misplaced, {events['missed']:,} missed, "
                f"{events['invented']:,} invented"
            )
            table.setdefault(variant, {})[arithmetic] = told
            findings.note(f"{variant}, {arithmetic}: {told}")
    findings.figures["sums and events, by what is as printed"] = table
    exact = [r for r in rows if (r.variant, r.arithmetic) == (ALL_CORRECTED, "rational")]
    lost = sum(row.events["missed"] + row.events["invented"] for row in exact)
    findings.none("all corrected, rational: events missed or invented", lost)
    shown = next((r for r in rows if r.variant != ALL_CORRECTED and r.wrong), None)
    if shown is not None:
        findings.note(f"a wrong answer, with {shown.variant} in {shown.arithmetic}: {shown.wrong}")
