"""The Appendix's program followed literally in several arithmetics: whether its sums and events are
right, which sentence is to blame, and what stepping saves."""

from __future__ import annotations

import random
import statistics
from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.judges.plane.rounded_sums import significant_bits
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.4, 2.5, 20)

SEED = 2012
NAMES = (
    "random", "holes", "collinear", "touching", "cells", "nested", "comb", "star", "lattice",
    "rational", "thin", "leaning", "degenerate",
)  # fmt: skip
POLYGONS = Counts(12, 100, 400)
RADII = Counts(6, 10, 10)  # of each, half of them at events
BLAMED = Counts(2, 4, 10)  # of these, with each sentence and arithmetic
MOST_VERTICES = 36
UNIT = "9/4"  # squared radius at the scale 1: not 1, where a wrong radical is right
EXACT = "rational"
ROUNDING = ("double", "mpfr:24", "mpfr:53", "mpfr:100", "mpfr:200")
CORRECTED = {name: corrected for name, _, corrected, _ in _core.appendix_readings()}
PRINTED = {name: values[0] for name, values, *_ in _core.appendix_readings()}
ALL_CORRECTED, ALL_PRINTED = "all corrected", "all as printed"


def _other(name: str, values: list[str]) -> str:
    return next(value for value in values if value != CORRECTED[name])


VARIANTS = {
    ALL_CORRECTED: CORRECTED,
    **{
        f"{name}={_other(name, values)}": CORRECTED | {name: _other(name, values)}
        for name, values, *_ in _core.appendix_readings()
    },
    ALL_PRINTED: PRINTED,
}
WINDOWS = 40  # radii of the timed walk
TIMED = ("bird", "monkey", "neuron")


@dataclass
class Tally:
    """Sums: `right`; `moved`, the same rings with corners off by more than half of the digits;
    `wrong`; `undecided`. Events: `right`, `misplaced`, `missed`, `invented`."""

    sums: Counter[str] = field(default_factory=Counter)
    events: Counter[str] = field(default_factory=Counter)

    def add(self, other: Tally) -> None:
        self.sums.update(other.sums)
        self.events.update(other.events)


@dataclass(frozen=True)
class Task:
    number: int
    radii: int
    blamed: int


@dataclass
class Row:
    name: str
    wrong: list[str]
    radii: int
    at_events: int
    tallies: dict[tuple[str, str], Tally]


def drawn(number: int) -> tuple[str, _core.PolygonSet]:
    """A polygon set with a few dozen vertices at most; all but one in ten have events of rational
    squared radius."""
    name = NAMES[number % len(NAMES)]
    for index in range(17 * number, 17 * number + 400):
        pair = FAMILIES[name].pair(SEED, index)
        P = _core.PolygonSet.from_json(pair.P if number % 2 == 0 else pair.Q)
        is_small = 1 <= P.vertices <= MOST_VERTICES
        if is_small and (number % 10 == 9 or rational_events(P)):
            return f"{name} {index} {'PQ'[number % 2]}", P
    return f"{name} {index} {'PQ'[number % 2]}", P


def rational_events(P: _core.PolygonSet) -> list[str]:
    """Squared radii of events of pairs, where they are rational."""
    found = _core.disc_pair_events(P)
    known = [event[3][1][0] for event in found.rows(0, len(found))]
    return [square for square in known if square is not None]


def squares(P: _core.PolygonSet, count: int, dice: random.Random) -> tuple[list[str], int]:
    """Squared radii, up and down, and how many of them are those of events."""
    rational = rational_events(P)
    size = max((Fraction(square) for square in rational), default=Fraction(50))
    chosen, at_events = [], 0
    for k in range(count):
        if k % 2 == 0 and rational:
            chosen.append(dice.choice(rational))
            at_events += 1
        else:
            chosen.append(str(size * Fraction(dice.randint(1, 400), dice.randint(100, 400))))
    return chosen, at_events


def follow(task: Task) -> Row:
    name, P = drawn(task.number)
    dice = random.Random(f"{SEED} {task.number}")
    chosen, at_events = squares(P, task.radii, dice)
    exact = _core.DiscUpdate(P, chosen[0], UNIT, EXACT, CORRECTED)
    wrong, truth = [], {}
    for square in chosen:
        exact.move_to(square)
        answer = exact.answer()
        if answer.canonical != _core.offset(P, square).canonical_json():
            wrong.append(f"{name} at the squared radius {square}")
        truth[square] = answer
    tallies = {}
    for variant, readings in VARIANTS.items():
        for arithmetic in (EXACT, *ROUNDING):
            program = _core.DiscUpdate(P, chosen[0], UNIT, arithmetic, readings)
            tallies[variant, arithmetic] = _tally(program, exact, arithmetic, {
                square: truth[square] for square in chosen[: task.blamed]
            })  # fmt: skip
    return Row(name, wrong, len(chosen), at_events, tallies)


def _tally(
    program: _core.DiscUpdate,
    exact: _core.DiscUpdate,
    arithmetic: str,
    truth: dict[str, _core.DiscAnswer],
) -> Tally:
    tally = Tally()
    bits = significant_bits(arithmetic)
    tally.events.update(program.agreement(exact, 0 if bits is None else bits // 2))
    for square, right in truth.items():
        program.move_to(square)
        try:
            answer = program.answer()
        except _core.UndecidedSign:
            tally.sums["undecided"] += 1
            continue
        off = answer.corner_distance(right)
        near = 0.5 ** ((53 if bits is None else min(bits, 53)) // 2)
        size = 1 + float(Fraction(square)) ** 0.5
        if answer.canonical != right.canonical:
            tally.sums["wrong"] += 1
        elif off is None or off <= near * 64 * size:
            tally.sums["right"] += 1
        else:
            tally.sums["moved"] += 1
    return tally


def run(findings: Findings, size: Size) -> None:
    tasks = [Task(number, size.of(RADII), size.of(BLAMED)) for number in range(size.of(POLYGONS))]
    rows = list(in_processes(follow, tasks))
    _exact(findings, rows)
    _blame(findings, rows)
    names = TIMED[:1] if size is Size.QUICK else TIMED
    tell_absent(findings, *names)
    findings.figures["stepping"] = [_stepping(findings, name) for name in names]


def _exact(findings: Findings, rows: list[Row]) -> None:
    radii, at_events = sum(row.radii for row in rows), sum(row.at_events for row in rows)
    findings.none(
        "all corrected, exact: sums that are not the exact ones",
        [wrong for row in rows for wrong in row.wrong],
    )
    findings.note(
        f"{len(rows):,} polygon sets, {radii:,} radii, {at_events:,} of them of events (seed "
        f"{SEED}); squared radius at the scale 1: {UNIT}"
    )


def _blame(findings: Findings, rows: list[Row]) -> None:
    total: dict[tuple[str, str], Tally] = {}
    for row in rows:
        for key, tally in row.tallies.items():
            total.setdefault(key, Tally()).add(tally)
    unlike = total[ALL_CORRECTED, EXACT]
    findings.none(
        "all corrected, exact: events that are not the exact ones",
        sum(unlike.events[name] for name in ("misplaced", "missed", "invented")),
    )
    findings.figures["blame"] = {
        variant: {
            arithmetic: {
                "sums": dict(total[variant, arithmetic].sums),
                "events": dict(total[variant, arithmetic].events),
            }
            for arithmetic in (EXACT, *ROUNDING)
        }
        for variant in VARIANTS
    }
    for variant in VARIANTS:
        told = "; ".join(
            f"{arithmetic} {_in_words(total[variant, arithmetic])}"
            for arithmetic in (EXACT, *ROUNDING)
        )
        findings.note(f"{variant}: {told}")


def _in_words(tally: Tally) -> str:
    asked = sum(tally.sums.values())
    moved = f", {tally.sums['moved']} moved" if tally.sums["moved"] else ""
    events = tally.events
    return (
        f"{tally.sums['right']} of {asked} sums right{moved}, events {events['right']:,} right, "
        f"{events['misplaced']:,} misplaced, {events['missed']:,} missed, "
        f"{events['invented']:,} invented"
    )


def _stepping(findings: Findings, name: str) -> dict[str, Any]:
    """Section 8.2: from radius to radius by the array of events, against all pairs anew."""
    P = operand(name)
    low, high = _box(P.set)
    side = max(high[0] - low[0], high[1] - low[1])
    program = _core.DiscUpdate(P.set, str((side / 1000) ** 2), "1", "double", CORRECTED)
    dice = random.Random(SEED)
    ratios, whole, updates, searches = [], [], [], []
    for _ in range(WINDOWS):
        radius = side * Fraction(dice.randint(1, 1000), 10_000)
        square = str(radius**2)
        step = program.move_to(square)
        seconds = program.place_intersections()[1]
        update = step["seconds"] + seconds
        search = program.search_intersections(square)[1]
        answer = program.answer().seconds
        updates.append(update)
        searches.append(search)
        ratios.append(search / update)
        whole.append((search + answer) / (update + answer))
    findings.note(
        f"{P.name}, doubles, {WINDOWS} radii up to a tenth of its size: the array of events takes "
        f"{program.seconds:.2f} s; a step with all intersections placed takes "
        f"{1000 * statistics.median(updates):.2f} ms, the same from all pairs "
        f"{1000 * statistics.median(searches):.1f} ms: {statistics.median(ratios):.1f} times as "
        f"long (quartiles {_quartiles(ratios)}); with loops and collision detection on both sides "
        f"{statistics.median(whole):.2f} times (quartiles {_quartiles(whole)})"
    )
    return {
        "model": P.name,
        **dict(program.counts()),
        "array_seconds": program.seconds,
        "step_seconds": updates,
        "search_seconds": searches,
        "ratios": ratios,
        "ratios_of_whole_sums": whole,
    }


def _quartiles(values: list[float]) -> str:
    low, _, high = statistics.quantiles(values, n=4)
    return f"{low:.2f} to {high:.2f}"


def _box(P: _core.PolygonSet) -> tuple[tuple[Fraction, Fraction], tuple[Fraction, Fraction]]:
    points = [point for polygon in P.rings() for ring in polygon for point in ring]
    xs, ys = [Fraction(x) for x, _ in points], [Fraction(y) for _, y in points]
    return (min(xs), min(ys)), (max(xs), max(ys))
