"""The paper's own update in `minkref sum` and `minkref sweep`: its walk, and its answers beside
the exact ones."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any, TypeVar

from minkref import _core
from minkref.arithmetic import check_arithmetic
from minkref.cli.row_spool import Row
from minkref.errors import Refusal, refusing
from minkref.exact import in_double_range
from minkref.fuzz.judges.plane.paper_events import Edge, Event, compare_events
from minkref.fuzz.judges.plane.rounded_sums import Comparison, compare, significant_bits
from minkref.plane.commands.scale_index import cores
from minkref.plane.commands.sum_fields import sum_fields
from minkref.plane.operand import Operand

T = TypeVar("T")


class PaperWalk:
    """P and Q followed from one scale to another by the paper's program. Each step holds its answer
    against the exact sum."""

    def __init__(
        self, P: Operand, Q: Operand, scale: str, arithmetic: str, readings: dict[str, str]
    ) -> None:
        check_arithmetic(arithmetic)
        self._P, self._Q = P.set, Q.set
        self._bits = significant_bits(arithmetic)
        self._adjacent = readings["adjacent"]
        self._update = refusing(
            f"{P.name} and {Q.name}",
            lambda: _core.PaperUpdate(P.set, Q.set, scale, arithmetic, readings, cores()),
        )

    @property
    def seconds(self) -> float:
        return self._update.seconds

    def counts(self) -> dict[str, Any]:
        return dict(self._update.counts())

    def events(
        self, most: int | None = None, window: tuple[Fraction, Fraction] | None = None
    ) -> dict[str, Any]:
        """Counts of right, misplaced, missed and invented events of the array, and the first missed
        and the first invented event; with `most` also the first so many events, each with the exact
        scale of the same event, or the first so many of a window that are missed and invented."""
        found = compare_events(
            self._P, self._Q, self._update, self._adjacent, self._bits, most or 0, window, cores()
        )
        fields: dict[str, Any] = {
            "right": found.right,
            "misplaced": found.misplaced,
            "missed": found.missed,
            "invented": found.invented,
            "first_missed": event_fields(found.first_missed),
            "first_invented": event_fields(found.first_invented),
        }
        if window is not None:
            fields["missed_within"] = [_event_fields(event) for event in found.missed_within]
            fields["invented_within"] = [_event_fields(event) for event in found.invented_within]
        elif most is not None:
            fields["rows"] = [
                {**_event_fields(event), "exact": exact} for event, exact in found.listed
            ]
        return fields

    def move_to(self, scale: str) -> dict[str, Any]:
        return dict(self._update.move_to(scale))

    def sum(self) -> _core.Sum:
        return self._update.sum()

    def beside_exact(
        self, scale: str, answer: _core.Sum, exact: _core.Sum | None = None
    ) -> dict[str, Any]:
        return comparison_fields(compare(self._P, self._Q, scale, answer, self._bits, exact))

    def row(self, scale: str) -> tuple[Row, _core.PolygonSet]:
        """The row of a sweep at its next scale, and the sum. Refuses what the arithmetic cannot
        decide."""
        did = decided(lambda: self.move_to(scale))
        answer = decided(self.sum)
        row: Row = {
            "scale": scale,
            **sum_fields(answer),
            "insertions": did["insertions"],
            "deletions": did["deletions"],
            "swaps": None,
            "updated": did["updated"],
            "event_scales": None,
            "update_seconds": did["seconds"],
            "sum_seconds": answer.seconds,
            "exact": self.beside_exact(scale, answer),
        }
        return row, answer.region


def paper_walk(
    P: Operand, Q: Operand, scale: str, arithmetic: str, readings: dict[str, str]
) -> PaperWalk:
    """Refuses what the arithmetic cannot decide."""
    return decided(lambda: PaperWalk(P, Q, scale, arithmetic, readings))


def decided(work: Callable[[], T]) -> T:
    """Refuses what the arithmetic cannot decide."""
    try:
        return work()
    except _core.UndecidedSign:
        raise Refusal(
            "the arithmetic could not decide a sign",
            "--arithmetic",
            "choose rational, or mpfr:BITS with more bits",
            "undecided-sign",
        ) from None


def comparison_fields(found: Comparison) -> dict[str, Any]:
    return {
        "same_structure": found.same_structure,
        "ulps": None if found.ulps is None else in_double_range(str(found.ulps)),
        "witness": None
        if found.point is None
        else {"point": list(found.point), "in_sum": found.in_sum},
    }


def event_fields(event: Event | None) -> dict[str, Any] | None:
    return None if event is None else _event_fields(event)


def _event_fields(event: Event) -> dict[str, Any]:
    return {
        "scale": event.scale,
        "change": "birth" if event.begins else "death",
        "a": parent_of(event.a),
        "b": parent_of(event.b),
    }


def parent_of(edge: Edge) -> str:
    """A convolution edge as `--where` names it: `S 0.4 at 0.7`."""
    kind, _, ring, index, other, vertex = edge
    return f"{kind} {ring}.{index} at {other}.{vertex}"
