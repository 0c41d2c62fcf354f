"""The paper's own update in `minkref sum` and `minkref sweep`: its options, its walk, and its
answers beside the exact ones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Annotated, Any, TypeVar

import typer
from minkref import _core
from minkref.commands.line.arithmetic import check_arithmetic
from minkref.commands.lists.row_spool import Row
from minkref.commands.lists.sum_fields import sum_fields
from minkref.errors import Refusal, choice, refusing
from minkref.exact import approximate, in_double_range
from minkref.fuzz.judges.paper_events import Edge, Event, compare_events
from minkref.fuzz.judges.rounded_sums import Comparison, compare
from minkref.operand import Operand

T = TypeVar("T")
ROUTE = "paper-update"
FORMS = ("printed", "corrected")


@dataclass(frozen=True)
class Choices:
    """How a section of the paper may be read. `rows`: name, values (the printed one first), the
    corrected one, section. `check` refuses a value that is none."""

    rows: list[tuple[str, list[str], str, str]]
    check: Callable[[str, str], None]

    def names(self) -> str:
        return ", ".join(f"{name} ({'|'.join(values)})" for name, values, *_ in self.rows)


PLANE_CHOICES = Choices(_core.paper_readings(), _core.check_paper_reading)

Form = Annotated[
    str | None,
    typer.Option(
        "--form",
        help=f"With --route {ROUTE}: all formulas as printed (the default) or corrected.",
        metavar="|".join(FORMS),
    ),
]
Reading = Annotated[
    list[str] | None,
    typer.Option(
        "--reading",
        help=f"With --route {ROUTE}: one formula or sentence of the paper as read, whatever --form "
        f"says; may be repeated. {PLANE_CHOICES.names()}.",
        metavar="NAME=VALUE",
    ),
]


def readings_of(
    form: str | None, chosen: Sequence[str] | None, choices: Choices = PLANE_CHOICES
) -> dict[str, str]:
    """By name, all of them. The last of a name counts."""
    form = form or FORMS[0]
    if form not in FORMS:
        raise Refusal(f"there is no form {form!r}", "--form", choice(form, FORMS))
    readings = {
        name: values[0] if form == "printed" else corrected
        for name, values, corrected, _ in choices.rows
    }
    for text in chosen or ():
        name, equals, value = text.partition("=")
        where = f"--reading {text[:60]}"
        if not equals or name not in readings:
            raise Refusal(
                f"there is no reading {name[:40]!r}", where, choice(name, tuple(readings))
            )
        refusing(where, partial(choices.check, name, value))
        readings[name] = value
    return readings


def refuse_options(route: str, form: str | None, chosen: Sequence[str] | None) -> None:
    """Refuses the options of the route with any other."""
    if route == ROUTE:
        return
    for option, given in (("--form", form), ("--reading", chosen)):
        if given:
            raise Refusal(
                f"the route {route} has no readings",
                option,
                f"add --route {ROUTE}, or leave it out",
            )


class PaperWalk:
    """P and Q followed from one scale to another by the paper's program. Each step holds its answer
    against the exact sum."""

    def __init__(
        self, P: Operand, Q: Operand, scale: str, arithmetic: str, readings: dict[str, str]
    ) -> None:
        check_arithmetic(arithmetic)
        self._P, self._Q = P.set, Q.set
        self._bits = bits_of(arithmetic)
        self._adjacent = readings["adjacent"]
        self._update = refusing(
            f"{P.name} and {Q.name}",
            lambda: _core.PaperUpdate(P.set, Q.set, scale, arithmetic, readings),
        )

    @property
    def seconds(self) -> float:
        return self._update.seconds

    def counts(self) -> dict[str, Any]:
        return dict(self._update.counts())

    def events(self) -> dict[str, Any]:
        """Of the array of events, how many are right, and what is missed and invented."""
        found = compare_events(self._P, self._Q, self._update, self._adjacent)
        return {
            "right": found.right,
            "missed": found.missed,
            "invented": found.invented,
            "first_missed": event_fields(found.first_missed),
            "first_invented": event_fields(found.first_invented),
        }

    def move_to(self, scale: str) -> dict[str, Any]:
        return dict(self._update.move_to(scale))

    def sum(self) -> _core.Sum:
        return self._update.sum()

    def beside_exact(self, scale: str, answer: _core.Sum) -> dict[str, Any]:
        return comparison_fields(compare(self._P, self._Q, scale, answer, self._bits))

    def row(self, scale: str) -> tuple[Row, _core.PolygonSet]:
        did = self.move_to(scale)
        answer = self.sum()
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


def bits_of(arithmetic: str) -> int | None:
    """Of a rounding arithmetic."""
    if arithmetic.startswith("mpfr:"):
        return int(arithmetic.removeprefix("mpfr:"))
    return None if arithmetic == "rational" else 53


def comparison_fields(found: Comparison) -> dict[str, Any]:
    return {
        "same_structure": found.same_structure,
        "ulps": None if found.ulps is None else in_double_range(str(found.ulps)),
        "witness": None
        if found.point is None
        else {"point": list(found.point), "in_sum": found.in_sum},
    }


def event_fields(event: Event | None) -> dict[str, Any] | None:
    if event is None:
        return None
    change = "birth" if event.begins else "death"
    return {
        "scale": event.scale,
        "change": change,
        "a": parent_of(event.a),
        "b": parent_of(event.b),
    }


def parent_of(edge: Edge) -> str:
    """An edge of the convolution as `--where` names it: `S 0.4 at 0.7`."""
    kind, _, ring, index, other, vertex = edge
    return f"{kind} {ring}.{index} at {other}.{vertex}"


def events_in_words(events: dict[str, Any]) -> list[tuple[str, str]]:
    """Rows of what people read of the events."""
    rows = [
        (
            "events",
            f"{events['right']:,} right, {events['missed']:,} missed, "
            f"{events['invented']:,} invented",
        )
    ]
    for what in ("missed", "invented"):
        event = events[f"first_{what}"]
        if event is not None:
            scale = f"{approximate(event['scale']):.10g}"
            told = f"at {scale}, {event['change']}: {event['a']} and {event['b']}"
            rows.append((f"first {what}", told))
    return rows


def in_words(found: dict[str, Any]) -> str:
    """What people read of a comparison."""
    if found["same_structure"]:
        off = found["ulps"]
        return "the same set" if off == 0 else f"the same structure, up to {off:.3g} ulp off"
    witness = found["witness"]
    if witness is None:
        return "another structure"
    x, y = witness["point"]
    where = "in the sum, and lost" if witness["in_sum"] else "not in the sum, and added"
    return f"another structure: ({x}, {y}) is {where}"
