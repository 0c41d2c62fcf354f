"""The index of all scales: sums equal the static route's sums, events equal the dynamic sum's
events."""

from __future__ import annotations

import json
import random
import tempfile
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import islice
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.degeneracies import lint
from minkref.exact import digest
from minkref.fuzz.plane.families.holed_pairs import (
    fit_pair,
    holes_pair,
    nested_pair,
    small_holes_pair,
)
from minkref.fuzz.plane.families.leaning_walls import leaning_pair
from minkref.fuzz.plane.families.pinched_pairs import pinched_pair
from minkref.fuzz.plane.families.random_pairs import Pair
from minkref.fuzz.plane.families.touching_cells import window_of
from minkref.reports.evidence.certificates.certified_cases import written
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 7, 55)

SEED = 2012
WINDOW = ("1/10", "10")
SCALES = Counts(0, 100, 1000)  # per real pair, besides its events
PAIRS, SCALES_OF_A_PAIR = Counts(0, 150, 2500), 20
PINCHED = Counts(0, 200, 5000)  # pairs
ROUTES = tuple(_core.ROUTES)
EVERY = Counts(0, 8, 1)  # one event of so many, for real pairs and the corpus
SAMPLE = 40  # certificates
MAKERS: dict[str, Callable[[int, int], Pair]] = {
    "holes": holes_pair,
    "small holes": small_holes_pair,
    "fit": fit_pair,
    "nested": nested_pair,
    "leaning walls": leaning_pair,
}
Task = tuple[str, str, str, tuple[str | None, str | None], tuple[str, ...]]


def same_sums(task: Task, routes: tuple[str, ...] = ROUTES[:1]) -> tuple[str, int, str]:
    """The task's name, the number of compared sums, and the first scale with a difference. Uses the
    task's scales, or else some at and between the index's events."""
    name, P_text, Q_text, window, given = task
    P, Q = _core.PolygonSet.from_json(P_text), _core.PolygonSet.from_json(Q_text)

    def account(sum: _core.Sum) -> tuple[str, int, int]:
        return digest(sum.region.canonical_json()), sum.components, sum.holes

    try:
        index = _core.ScaleIndex(P, Q, *window)
        scales = list(given) or drawn(index, name, SCALES_OF_A_PAIR)
        for scale in scales:
            found = account(index.sum(scale))
            for route in routes:
                if account(_core.minkowski_sum(P, Q, scale, route)) != found:
                    return name, len(scales), f"{scale} ({route})"
    except Exception as error:  # noqa: BLE001 a fault too
        return name, 0, f"{type(error).__name__}: {error}"
    return name, len(scales), ""


def same_sums_by_all_routes(task: Task) -> tuple[str, int, str]:
    return same_sums(task, ROUTES)


def same_events(task: Task) -> tuple[str, int, str]:
    """Boundary events by scale and change, topology events and lives in all but the place."""
    name, P_text, Q_text, window, _ = task
    P, Q = _core.PolygonSet.from_json(P_text), _core.PolygonSet.from_json(Q_text)
    try:
        index, dynamic = _core.ScaleIndex(P, Q, *window), _core.DynamicSum(P, Q, *window)
        pairs: list[tuple[list[Any], list[Any]]] = [
            (
                [row[:2] for row in index.boundary_events()],
                [row[:2] for row in dynamic.boundary_events()],
            ),
            (
                [row[:6] for row in index.topology_events()],
                [row[:6] for row in dynamic.topology_events()],
            ),
        ]
        for kind in ("hole", "component"):
            pairs.append((index.features(kind), dynamic.features(kind)))
        for found, expected in pairs:
            if found != expected:
                other = next((e for f, e in zip(found, expected, strict=False) if f != e), "more")
                return name, 0, f"expected {other}"
        return name, len(pairs[0][1]) + len(pairs[1][1]), ""
    except Exception as error:  # noqa: BLE001 a fault too
        return name, 0, f"{type(error).__name__}: {error}"


def drawn(index: _core.ScaleIndex, seed: str, count: int) -> list[str]:
    """Seeded scales: out of every four, one at an event, one between two events, two anywhere."""
    dice = random.Random(f"{SEED} {seed}")
    events = index.event_scales()
    begin, end = index.window
    low = begin if begin is not None else (events[0] / 2 if events else Fraction(1, 2))
    high = end if end is not None else (2 * events[-1] if events else Fraction(2))
    scales = []
    for k in range(count):
        scale = low + (high - low) * Fraction(dice.randrange(1, 10_000), 10_000)
        if events and k % 4 == 0:
            scale = dice.choice(events)
        elif len(events) > 1 and k % 4 == 1:
            at = dice.randrange(len(events) - 1)
            scale = (events[at] + events[at + 1]) / 2
        scales.append(str(scale))
    return scales


def degenerate_tasks(count: int) -> Iterator[Task]:
    for number in range(count):
        kind = list(MAKERS)[number % len(MAKERS)]
        pair = MAKERS[kind](SEED, number // len(MAKERS))
        yield f"{kind} {number // len(MAKERS)}", pair.P, pair.Q, (None, None), ()


def pinched_tasks(count: int) -> Iterator[Task]:
    for number in range(count):
        pair = pinched_pair(SEED, number)
        yield f"pinched {number}", pair.P, pair.Q, window_of(number), ()


def corpus_tasks(every: int) -> Iterator[Task]:
    for path in lint.case_paths(lint.CORPUS)[::every]:
        case = json.loads(path.read_text())
        if case["dimension"] != 2:
            continue
        P, Q = json.dumps(case["P"]), json.dumps(case["Q"])
        scales = [Fraction(scale) for scale in case["scales"]]
        window = (str(min(scales) / 2), str(2 * max(scales)))
        yield path.stem, P, Q, window, ()
        yield path.stem, P, Q, window, tuple(map(str, scales))


def real_tasks(findings: Findings, first: str, second: str, size: Size) -> list[Task]:
    """In portions: random scales, and below, at and above each boundary event."""
    tell_absent(findings, first, second)
    P, Q = operand(first), operand(second)
    dynamic = _core.DynamicSum(P.set, Q.set, *WINDOW)
    events = [Fraction(row[0]) for row in dynamic.boundary_events()]
    dice = random.Random(SEED)
    low, high = map(Fraction, WINDOW)
    scales = [
        str(low + (high - low) * Fraction(dice.randrange(1, 10**6), 10**6))
        for _ in range(size.of(SCALES))
    ]
    bounds = [low, *events, high]
    for k, event in islice(enumerate(events, 1), 0, None, size.of(EVERY)):
        scales += [str((bounds[k - 1] + event) / 2), str(event), str((event + bounds[k + 1]) / 2)]
    step = 500
    return [
        (
            f"{P.name} + {Q.name}",
            P.set.to_json(),
            Q.set.to_json(),
            WINDOW,
            tuple(scales[k : k + step]),
        )
        for k in range(0, len(scales), step)
    ]


def run(findings: Findings, size: Size) -> None:
    def all_of(what: str, work: Callable[[Task], tuple[str, int, str]], tasks: list[Task]) -> None:
        compared, wrong = 0, []
        for name, count, fault in in_processes(work, tasks, each=100, what=what):
            compared += count
            if fault:
                wrong.append(f"{name}: {fault}")
        findings.none(f"{what}: differ", wrong)
        findings.figures[what] = f"{len(tasks):,} tasks, {compared:,} compared"
        findings.target(f"{what}: compared", compared > 0, "some", compared)

    degenerate, corpus = list(degenerate_tasks(size.of(PAIRS))), list(corpus_tasks(size.of(EVERY)))
    pinched = list(pinched_tasks(size.of(PINCHED)))
    all_of("degenerate pairs, sums at 20 scales", same_sums, degenerate)
    all_of("degenerate pairs, events", same_events, degenerate)
    all_of("pinched pairs, sums at 20 scales by all routes", same_sums_by_all_routes, pinched)
    all_of("pinched pairs, events", same_events, pinched)
    all_of("corpus, sums at 20 scales", same_sums, corpus)
    all_of("corpus, events", same_events, corpus[::2])
    for first, second in (("neuron", "disc1"), ("monkey", "bird")):
        tasks = real_tasks(findings, first, second, size)
        all_of(f"{first} + {second}, sums", same_sums, tasks)
        all_of(f"{first} + {second}, events", same_events, tasks[:1])
    _certificates(findings, degenerate[:: len(degenerate) // SAMPLE])
    findings.note(
        f"seed {SEED}; windows of real pairs {WINDOW[0]} to {WINDOW[1]}, of degenerate pairs all "
        "scales, of pinched pairs five in turn, of the corpus from half the least to twice the "
        "greatest scale of the case"
    )


def _certificates(findings: Findings, tasks: list[Task]) -> None:
    """Certifies sums at drawn scales, at an event if any exists: the digest must equal the index's
    digest."""
    with tempfile.TemporaryDirectory() as folder:
        files, other = [], []
        for number, (name, P_text, Q_text, window, _) in enumerate(tasks):
            P, Q = _core.PolygonSet.from_json(P_text), _core.PolygonSet.from_json(Q_text)
            index = _core.ScaleIndex(P, Q, *window)
            scale = drawn(index, name, 1)[0]
            certificate = Certificate(P, Q)
            certificate.sum(scale)
            if certificate.claims[0]["digest"] != digest(index.sum(scale).region.canonical_json()):
                other.append(f"{name} at {scale}")
            files.append(written(certificate, Path(folder), str(number)))
        refused = [
            verdict.why
            for verdict in (*verdicts(in_cpp(), files), *verdicts(in_python(), files))
            if verdict.code
        ]
    findings.none("certificates of another sum than the index has", other)
    findings.none("certificates that a checker refuses", refused)
    findings.figures["certificates followed by both checkers"] = len(files)
