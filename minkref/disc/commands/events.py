"""`minkref events P disc`: the radii at which the sum with a disc changes."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from itertools import islice
from json import dumps
from typing import Any

from minkref import _core
from minkref.certain_digits import between
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.readings import DISC_EVENT_CHOICES, with_other
from minkref.disc.commands.index_file import Places, from_places
from minkref.disc.commands.sum import enclosed
from minkref.disc.disc import ANY, check_radii, is_disc, squares_of
from minkref.disc.eroded import ErodedByDisc, eroded_by_disc
from minkref.errors import Refusal, choice
from minkref.exact import text_of_bounds
from minkref.output.documents import (
    Stopwatch,
    as_text,
    document,
    lasting,
    listing,
    refuse_overwriting,
)
from minkref.output.output_target import target_of
from minkref.output.terminal import console, counted
from minkref.plane.commands.scale_index import cores, refuse_overwriting_index
from minkref.plane.operand import read_operand
from minkref.verbs.events import EventsWithDisc, check_form, check_limit

FORMATS = ("json", "jsonl")
KINDS = ("boundary", "topology")
KINDS_OF_PLACES = ("corner", "joint", "saddle", "ridge", "maximum")
SHOWN = 10  # events that people see
Row = dict[str, Any]


def run(request: EventsWithDisc) -> None:
    if not is_disc(request.Q):
        mend = "give `minkref events P disc`"
        raise Refusal("the disc is the second operand", request.P, mend)
    if request.kind == "pair":
        if request.erode:
            what = "pair events are those of a convolution, and an erosion has none of its own"
            mend = "choose --kind boundary or --kind topology"
            raise Refusal(what, "--kind pair --erode", mend)
        from minkref.disc.commands.pair_events import pair_events

        pair_events(request)
        return
    watch = Stopwatch()
    P, Q, output, limit, json = (
        request.P, request.Q, request.output, request.limit, request.json,
    )  # fmt: skip
    chosen = _kind(request)
    check_radii(request.from_scale, request.to_scale)
    bounds = text_of_bounds(request.from_scale, request.to_scale)
    target = target_of(output, request.file_format, FORMATS, "json", json)
    with memory_wall(request.memory, "events of a disc", P, SIMPLER):
        operand = read_operand(P)
        if output is not None:
            refuse_overwriting(output, [operand.file])
            refuse_overwriting_index(output, request.index)
        squares = squares_of(request.from_scale, request.to_scale)
        eroded = eroded_by_disc(operand.set, operand.name) if request.erode else None
        listed: Boundary | Topology = from_places(
            request.index,
            operand,
            lambda places: (Boundary if chosen == KINDS[0] else Topology)(
                operand.set if eroded is None else eroded.set, squares, places, eroded
            ),
        )
        inradius = None if eroded is None else [event_row(row) for row in eroded.largest(cores())]
    rows = listed.rows(limit)
    head = document(
        "events",
        watch,
        P=operand.name,
        Q=Q,
        erode=request.erode,
        **{"from": bounds[0]},
        to=bounds[1],
        kind=chosen,
        warnings=operand.warnings,
        output=str(output) if output else None,
        compute_seconds=listed.seconds,
        exact_signs=listed.exact_signs,
        counts={name: listed.kinds.count(name) for name in KINDS_OF_PLACES},
        count=len(listed.kinds),
        inradius=inradius,
    )
    if target is not None and target.form == "jsonl":
        target.write_pieces(dumps(row) + "\n" for row in rows)
    elif target is not None:
        target.write_pieces(listing(lasting(head), "events", rows))
    if json and target is None:
        sys.stdout.writelines(listing(head, "events", rows))
    elif json:
        sys.stdout.write(as_text({**head, "events": None}))
    elif target is None or not target.is_standard_output:
        shown = [] if target is not None else list(islice(rows, SHOWN if limit is None else limit))
        _print(head, shown)


def _kind(request: EventsWithDisc) -> str:
    """Refuses a kind that is none, and options that it does not have."""
    if request.Q != ANY:
        mend = "name the disc `disc`, and bounds of its radius by --from and --to"
        raise Refusal("events are found for all radii", request.Q, mend)
    kind = request.kind or KINDS[0]
    if kind not in KINDS:
        raise Refusal(
            f"there are no events {kind} of a disc", "--kind", choice(kind, (*KINDS, "pair"))
        )
    check_form(request.form)
    if request.form != "corrected":
        what = "events of a disc of the kind pair alone have a printed form"
        raise Refusal(what, f"--form {request.form}", "add --kind pair, or leave it out")
    if request.reading:
        what = "sentences of the Appendix are of events of the kind pair"
        mend = with_other("add --kind pair", None, request.reading, DISC_EVENT_CHOICES)
        raise Refusal(what, "--reading", mend)
    if request.route not in (None, "index"):
        what = "events of a disc are found by an index alone"
        raise Refusal(what, "--route", "leave it out")
    check_limit(request.limit)
    return kind


class Boundary:
    """All events in a window of squared radii."""

    def __init__(
        self,
        P: _core.PolygonSet,
        squares: list[str | None],
        places: Places | None,
        eroded: ErodedByDisc | None,
    ) -> None:
        self._eroded = eroded
        self._found = _core.diagram_events(P, cores(), squares[0], squares[1], places)
        self.seconds = self._found.seconds
        self.exact_signs = self._found.exact_signs
        self.kinds = self._found.kinds()

    def rows(self, limit: int | None) -> Iterator[Row]:
        """Their numbers are made exact one by one, which takes the most time."""
        for number in range(len(self.kinds))[:limit]:
            found = self._found.rows(number, 1)[0]
            yield {**event_row(found, self._eroded), "changes": None}


class Topology:
    """Those at which holes or components change."""

    def __init__(
        self,
        P: _core.PolygonSet,
        squares: list[str | None],
        places: Places | None,
        eroded: ErodedByDisc | None,
    ) -> None:
        self._eroded = eroded
        self._index = _core.disc_index(P, cores(), places)
        self.seconds = self._index.seconds
        self.exact_signs = self._index.exact_signs
        changes = self._index.changes()
        first, last = 1, len(self._index)
        if squares[0] is not None:
            place, at_event = self._index.place(squares[0])
            first = place if at_event else place + 1
        if squares[1] is not None:
            last = self._index.place(squares[1])[0]
        self._changes = [change for change in changes if first <= change[1] <= last]
        kinds = self._index.kinds()
        self.kinds = [kinds[change[0]] for change in self._changes]

    def rows(self, limit: int | None) -> Iterator[Row]:
        for event, _, born, ended, joined in self._changes[:limit]:
            yield {
                **event_row(self._index.rows(event, 1)[0], self._eroded),
                "changes": {
                    "born": [{"hole": hole, "of": of} for hole, of in born],
                    "ended": ended,
                    "joined": [list(polygons) for polygons in joined],
                },
            }


def event_row(found: Any, eroded: ErodedByDisc | None = None) -> Row:
    found = found if eroded is None else eroded.in_P(found)
    kind, square, polynomial, radius, place, features = found
    return {
        "kind": kind,
        "radius": enclosed(radius),
        "squared_radius": square,
        "polynomial": polynomial,
        "place": [c if math.isfinite(c) else None for c in place],
        "features": [feature_row(*feature) for feature in features],
    }


def feature_row(kind: str, first: str, second: str) -> Row:
    if kind == "vertex":
        return {"vertex": [first, second]}
    return {"edge": [int(first), int(second)]}


def _in_words(changes: Row, eroded: bool) -> str:
    one = "component" if eroded else "hole"
    told = [
        f"{one} {each['hole']} leaves " + (f"{one} {each['of']}" if each["of"] else "the outside")
        for each in changes["born"]
    ]
    told += [f"{one} {hole} ends" for hole in changes["ended"]]
    if eroded:
        told += [f"{_hole_of_P(a)} and {_hole_of_P(b)} are one" for a, b in changes["joined"]]
    else:
        told += [f"polygons {a} and {b} are in one component" for a, b in changes["joined"]]
    return "; ".join(told)


def _hole_of_P(number: int) -> str:
    """In the order of P's rings; what is outside of all of P is 0."""
    return f"hole {number}" if number else "the outside"


def _features_in_words(row: Row) -> str:
    return ", ".join(
        f"vertex ({', '.join(each['vertex'])})"
        if "vertex" in each
        else f"edge {each['edge'][0]}.{each['edge'][1]}"
        for each in row["features"]
    )


def _print(head: dict[str, Any], rows: list[Row]) -> None:
    out = console()
    counts = ", ".join(f"{name} {n:,}" for name, n in head["counts"].items() if n)
    sign = "less" if head["erode"] else "+"
    out.print(
        f"{head['P']} {sign} disc: {counted(head['count'], head['kind'] + ' event')}", markup=False
    )
    for row in head["inradius"] or []:
        x, y = (f"{c:.9g}" for c in row["place"])
        told = f"{between(**row['radius'], digits=9)} at ({x}, {y}): {_features_in_words(row)}"
        out.print(f"inradius {told}", markup=False)
    if counts:
        out.print(counts)
    for row in rows:
        told = between(**row["radius"], digits=9)
        out.print(f"{told:>14}  {row['kind']}: {_features_in_words(row)}")
        if row["changes"]:
            out.print(f"{'':>14}  {_in_words(row['changes'], head['erode'])}")
    if len(rows) < head["count"]:
        out.print(f"... {head['count'] - len(rows):,} more; -o FILE writes all")
    for warning in head["warnings"]:
        sys.stderr.write(f"warning: {warning}\n")
