"""Boundary events, and components and holes at and between them, against a judge that takes sums
at, below and above every scale that might be one."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple, Self

from minkref import _core
from minkref.fuzz.cgal.executables import OracleNotFoundError, built_folders
from minkref.fuzz.cgal.server import OracleServer
from minkref.fuzz.judges.ruling import Ruling, dice_of
from minkref.fuzz.plane.case import Case
from minkref.fuzz.verdicts.verdict import Reason

EXECUTABLE = "minkref-sampled-events"
BUILD_COMMAND = f"cmake --preset release && cmake --build --preset release --target {EXECUTABLE}"
SECONDS = 60.0


class Counts(NamedTuple):
    rings: int
    vertices: int
    components: int
    holes: int


class Event(NamedTuple):
    s: Fraction
    below: Counts
    at: Counts
    above: Counts
    same: bool  # the same moving vertices, joined alike, below and above

    @property
    def change(self) -> str:
        """Names the change by docs/definitions.md."""
        if self.same:
            return "touch"
        more = self.above.vertices - self.below.vertices
        return "birth" if more > 0 else "death" if more < 0 else "swap"


class Events(NamedTuple):
    """Events at all scales, ascending; `before`: counts below the first event, or everywhere."""

    events: list[Event]
    before: Counts


class SampledEvents(OracleServer):
    """The judge oracle/sampled (see its README.md). Limits for each call: `seconds` on the clock,
    `bytes` of address space. OracleNotFoundError if not built."""

    def __init__(self, seconds: float = SECONDS, bytes: int = 4 << 30) -> None:
        super().__init__(find_executable(), seconds, bytes)

    def __enter__(self) -> Self:
        return self

    def events(self, case: Case) -> Events | str:
        """Returns all boundary events of a case; or the reason why none can be told. Exact. A
        millisecond for ten vertices each. RuntimeError if the judge fails."""
        value = self.ask("sampled-events", {"P": case.P_json, "Q": case.Q_json})
        if value["status"] == "skipped":
            return str(value["reason"])
        if value["status"] != "result":
            raise RuntimeError(f"the judge of events {value['status']}: {value.get('reason')}")
        return Events([_event(row) for row in value["events"]], Counts(*value["before"]))


def find_executable() -> Path:
    """Finds the judge; OracleNotFoundError names the build command."""
    for folder in built_folders("sampled"):
        if (folder / EXECUTABLE).is_file():
            return folder / EXECUTABLE
    raise OracleNotFoundError(f"{EXECUTABLE} was not found; build it with: {BUILD_COMMAND}")


def _event(row: dict[str, Any]) -> Event:
    below, at, above = (Counts(*row[name]) for name in ("below", "at", "above"))
    return Event(Fraction(row["s"]), below, at, above, row["same"])


def judge(case: Case, sampled: SampledEvents) -> Ruling:
    """By all routes, at all scales and in a window that ends at events: the scales and changes of
    boundary events, each once; components and holes at and between them, and as the topology
    events tell them."""
    truth = sampled.events(case)
    if isinstance(truth, str):
        return Ruling(skipped=truth)
    ruling = Ruling()
    low, high = window(case, truth.events)
    within = [event for event in truth.events if low <= event.s <= high]
    ways: dict[str, Callable[..., _core.DynamicSum | _core.ScaleIndex]] = {
        "dynamic": _core.DynamicSum,
        "winding": _by_winding,
        "index": _core.ScaleIndex,
    }
    for route, sums in ways.items():
        found = sums(case.P, case.Q)
        compare_events(ruling, f"boundary events by the route {route}", found, truth.events)
        compare_topology(ruling, route, found, truth.events)
        if isinstance(found, _core.DynamicSum):
            compare_states(ruling, found, truth)
        else:
            compare_index(ruling, found, truth)
        found = sums(case.P, case.Q, str(low), str(high))
        compare_events(
            ruling, f"boundary events in [{low}, {high}] by the route {route}", found, within
        )
    return ruling


def _by_winding(
    P: _core.PolygonSet, Q: _core.PolygonSet, low: str | None = None, high: str | None = None
) -> _core.DynamicSum:
    return _core.DynamicSum(P, Q, low, high, "winding")


def window(case: Case, events: Sequence[Event]) -> tuple[Fraction, Fraction]:
    """Ends at events, or beside them."""
    dice = dice_of(case)
    scales = [event.s for event in events] or [Fraction(1)]
    low, high = sorted(
        dice.choice(scales) * dice.choice((1, 1, Fraction(99, 100))) for _ in range(2)
    )
    return low, max(high, low * Fraction(101, 100))


def compare_events(ruling: Ruling, what: str, found: Any, truth: Sequence[Event]) -> None:
    listed = [(Fraction(s), change) for s, change, *_ in found.boundary_events()]
    right = [(event.s, event.change) for event in truth]
    invented = [row for row in listed if row not in right]
    missed = [row for row in right if row not in listed]
    reason = Reason.EVENT_INVENTED if invented else Reason.EVENT_MISSED
    if {s for s, _ in listed} == {s for s, _ in right}:
        reason = Reason.EVENT_MISPLACED
    ruling.compare(f"{what} that only one side has", _text(invented), _text(missed), reason)
    ruling.compare(
        f"{what}, ascending and each once", _text(listed), _text(sorted(set(listed))),
        Reason.EVENT_INVENTED,
    )  # fmt: skip


def compare_states(ruling: Ruling, dynamic: _core.DynamicSum, truth: Events) -> None:
    """Holes, components and vertices below, at and above each event."""
    first = truth.before
    right: list[tuple[Any, ...]] = []
    if first.rings:  # the empty set has no states
        right.append(("0", first.holes, first.components, first.vertices))
    right += [
        (str(s), above.holes, above.components, above.vertices, at.holes, at.components)
        for s, _, at, above, _ in truth.events
    ]
    scales = {s for s, *_ in right}
    told: list[tuple[Any, ...]] = []
    for begin, counts in dynamic.state_counts():
        is_new = not told or list(told[-1][1:4]) != counts[:3] or counts[:2] != counts[3:]
        if begin is None:
            told.append(("0", *counts[:3]))
        elif begin in scales or is_new:  # some states equal the one before
            told.append((begin, *counts))
    ruling.compare(
        "from a scale on holes, components, vertices, and holes and components at it",
        _less(told, right), _less(right, told), Reason.STATE_DRIFT,
    )  # fmt: skip


def compare_index(ruling: Ruling, index: _core.ScaleIndex, truth: Events) -> None:
    """Components and holes at each event and in the middle between two."""
    scales = [event.s for event in truth.events]
    ends = [Fraction(0), *scales, 2 * max(scales, default=Fraction(1))]
    middles = [(a + b) / 2 for a, b in pairwise(ends)]
    states = [truth.before, *(event.above for event in truth.events)]
    right = [
        (str(s), counts.components, counts.holes)
        for s, counts in [
            *zip(middles, states, strict=True),
            *((event.s, event.at) for event in truth.events),
        ]
    ]
    told = [(s, *index.components_and_holes(s)) for s, *_ in right]
    ruling.compare(
        "components and holes at a scale by the index",
        _less(told, right), _less(right, told), Reason.STATE_DRIFT,
    )  # fmt: skip


def compare_topology(ruling: Ruling, route: str, found: Any, truth: Sequence[Event]) -> None:
    """Checks the topology events by the components and holes below, at and above each scale."""
    rows = found.topology_events()
    for feature in ("component", "hole"):
        told = {event.s: (0, 0) for event in truth}
        for s, of, _, before, after, parts, _ in rows:
            if of == feature:
                at, above = told.get(Fraction(s), (0, 0))
                told[Fraction(s)] = (
                    at + parts - len(before), above + len(after) - len(before)
                )  # fmt: skip
        right = {
            event.s: (_count(event.at, feature) - below, _count(event.above, feature) - below)
            for event in truth
            for below in [_count(event.below, feature)]
        }
        ruling.compare(
            f"{feature}s more at and above a scale than below, by the topology events of {route}",
            _less(sorted(told.items()), right.items()), _less(right.items(), told.items()),
            Reason.EVENT_MISPLACED,
        )  # fmt: skip


def _count(state: Counts, feature: str) -> int:
    return state.components if feature == "component" else state.holes


def _less(these: Iterable[Any], others: Iterable[Any]) -> list[Any]:
    known = set(others)
    return [row for row in these if row not in known]


def _text(rows: Sequence[tuple[Fraction, str]]) -> list[str]:
    return [f"{s} {change}" for s, change in rows]
