"""Rings that touch, at all scales: the index and the dynamic sum on exhaustive and random cells of
a grid, where a tight passage may run across the face of an edge."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterator
from fractions import Fraction

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.geometry.plane import Point, Ring, Shape, doubled_area
from minkref.fuzz.plane.families.drawing import is_valid, shape_text
from minkref.fuzz.plane.families.pinched_pairs import pinched_pair
from minkref.fuzz.plane.families.touching_cells import (
    Window,
    beside_segments,
    random_cells,
    window_of,
)
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 1, 8)

SEED = 46
ROUTES = tuple(_core.ROUTES)
HAIR = Fraction(1, 2**20)  # relative: beside an event
RANDOM, PINCHED = Counts(0, 200, 2000), Counts(0, 400, 5000)
EVERY = Counts(0, 7, 1)  # one cell or hole of so many
EVERY_SET = 3  # of triangular holes
Task = tuple[str, str, str, Window]


def same_as_static(task: Task) -> tuple[str, int, str]:
    """The task's name, the number of compared sums, and the first difference or exception."""
    name, P_text, Q_text, window = task
    P, Q = _core.PolygonSet.from_json(P_text), _core.PolygonSet.from_json(Q_text)
    compared = 0
    try:
        index, dynamic = _core.ScaleIndex(P, Q, *window), _core.DynamicSum(P, Q, *window)
        for scale in telling_scales(index.event_scales(), window):
            dynamic.move_to(scale)
            expected = _account(_core.minkowski_sum(P, Q, scale, ROUTES[0]))
            found = {"index": _account(index.sum(scale)), "dynamic": _account(dynamic.sum())}
            for route in ROUTES[1:]:
                found[route] = _account(_core.minkowski_sum(P, Q, scale, route))
            for which, account in found.items():
                if account != expected:
                    return name, compared, f"{which} at {scale}"
            compared += 2
    except Exception as error:  # noqa: BLE001 a fault too
        return name, compared, f"{type(error).__name__}: {error}"
    return name, compared, ""


def _account(sum: _core.Sum) -> tuple[str, int, int]:
    return digest(sum.region.canonical_json()), sum.components, sum.holes


def telling_scales(events: list[Fraction], window: Window) -> list[str]:
    """At, beside and between all events, and beyond them as far as the window goes."""
    low, high = (None if bound is None else Fraction(bound) for bound in window)
    at = sorted(events)
    bounds = [low or Fraction(0), *at, high if high is not None else (at[-1] if at else 1) * 2]
    scales = {(a + b) / 2 for a, b in itertools.pairwise(bounds)}
    scales.update(scale * way for scale in at for way in (1 - HAIR, 1, 1 + HAIR))
    scales.update(bound for bound in (low, high) if bound is not None)
    return [
        str(scale)
        for scale in sorted(scales)
        if scale > 0 and (low is None or low <= scale) and (high is None or scale <= high)
    ]


def cell_tasks(side: int) -> Iterator[Task]:
    """Tasks without a window, and four in five with a window too."""
    for number, case in enumerate(beside_segments(side)):
        yield case.name, case.P, case.Q, (None, None)
        window = window_of(number)
        if window != (None, None):
            yield f"{case.name}, {window}", case.P, case.Q, window


def triangle_tasks() -> Iterator[Task]:
    """Triangular lattice holes that touch the surrounding triangle, each beside a short segment."""
    outer: Ring = [(0, 0), (4, 0), (0, 4)]
    nodes: list[Point] = [(x, y) for x in range(5) for y in range(5 - x)]
    segments = [(1, 0), (0, 1), (1, -1), (2, -1), (1, -2), (1, 1), (2, 1)]
    number = 0
    for hole in itertools.combinations(nodes, 3):
        shape: Shape = [[outer, list(hole)]]
        if not any(0 in (x, y, 4 - x - y) for x, y in hole) or not doubled_area(shape[0][1]):
            continue
        text = shape_text(shape)
        if not is_valid(text):
            continue
        for way in segments:
            number += 1
            segment = shape_text([[[(0, 0), way]]])
            if number % EVERY_SET == 0:
                yield f"hole {hole}, {way}", segment, text, window_of(number)


def random_tasks(count: int) -> Iterator[Task]:
    for number in range(count):
        pair = random_cells(SEED, number)
        yield f"random cells {number}", pair.P, pair.Q, window_of(number)


def pinched_tasks(count: int) -> Iterator[Task]:
    for number in range(count):
        pair = pinched_pair(SEED, number)
        yield f"pinched {number}", pair.P, pair.Q, window_of(number)


def run(findings: Findings, size: Size) -> None:
    drawn = {
        "2 x 2 cells": list(cell_tasks(2))[:: size.of(EVERY)],
        "3 x 3 cells": list(cell_tasks(3))[:: size.of(EVERY)],
        "triangular holes": list(triangle_tasks())[:: size.of(EVERY)],
        "random cells": list(random_tasks(size.of(RANDOM))),
        "pinched pairs": list(pinched_tasks(size.of(PINCHED))),
    }
    for what, tasks in drawn.items():
        compared, wrong = 0, []
        for name, count, fault in in_processes(same_as_static, tasks, each=100, what=what):
            compared += count
            if fault:
                wrong.append(f"{name}: {fault}")
        findings.none(f"{what}: other than the static sum", wrong)
        windows = Counter(task[3] != (None, None) for task in tasks)
        findings.figures[what] = (
            f"{len(tasks):,}, {windows[True]:,} of them in a window; {compared:,} sums compared"
        )
        findings.target(f"{what}: with a window and without", len(windows) == 2, 2, len(windows))
    findings.note(f"seed {SEED}; routes: {', '.join(ROUTES)}; beside an event: 1 part in 2^20")
