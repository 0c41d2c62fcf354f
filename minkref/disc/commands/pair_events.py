"""`minkref events P disc --kind pair`: the radii at which two offset features start or stop to
share points, as it is or as the Appendix prints it."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from json import dumps
from typing import Any

from minkref import _core
from minkref.certain_digits import between
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.readings import DISC_EVENT_CHOICES, readings_of
from minkref.disc.disc import ANY, check_radii, read_disc, squares_of
from minkref.errors import Refusal, refusing
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
from minkref.output.terminal import counted, escaped, lines
from minkref.plane.operand import read_operand
from minkref.verbs.events import EventsWithDisc, check_form, check_limit

FORMATS = ("json", "jsonl")
CHANGES = ("birth", "death", "touch", "swap", "overlap", "none")
CONDITIONS = ("end on line", "end on circle", "circle on line", "circles")
SHOWN = 10  # events that people see
AT_ONCE = 1000  # rows that are made exact in one call
Row = dict[str, Any]


def pair_events(request: EventsWithDisc) -> None:
    watch = Stopwatch()
    check_form(request.form)
    P, Q, form, output, json = (
        request.P, request.Q, request.form, request.output, request.json,
    )  # fmt: skip
    readings = readings_of(form, request.reading, DISC_EVENT_CHOICES)
    printed = [name for name, values, *_ in DISC_EVENT_CHOICES.rows if readings[name] == values[0]]
    limit, radius = request.limit, _check(request, bool(printed))
    check_radii(request.from_scale, request.to_scale)
    window = text_of_bounds(request.from_scale, request.to_scale)
    target = target_of(output, request.file_format, FORMATS, "json", json)
    most = limit if limit is not None or json or target is not None else SHOWN
    with memory_wall(request.memory, "pair events of a disc", P, SMALLER):
        operand = read_operand(P)
        if output is not None:
            refuse_overwriting(output, [operand.file])
        squares = squares_of(request.from_scale, request.to_scale)
        is_unit = radius in (None, "1")
        found = refusing(
            operand.name,
            lambda: _core.disc_pair_events(
                operand.set, printed, is_unit, squares[0], squares[1], most
            ),
        )
        counts = dict(found.counts())
        head = document(
            "events",
            watch,
            P=operand.name,
            Q=Q,
            **{"from": window[0]},
            to=window[1],
            kind="pair",
            form=form,
            readings=readings if request.reading else None,
            radius=radius,
            warnings=operand.warnings,
            output=str(output) if output else None,
            compute_seconds=found.seconds,
            **{name: counts[name] for name in ("features", "pairs", "filtered_pairs")},
            exact_signs=counts["exact_signs"],
            changes={name: counts["changes"].get(name, 0) for name in CHANGES},
            conditions={name: counts["kinds"].get(name, 0) for name in CONDITIONS},
            count=counts["count"],
            truth=_truth(counts) if printed else None,
        )
        if target is not None and target.form == "jsonl":
            target.write_pieces(dumps(row) + "\n" for row in _rows(found))
        elif target is not None:
            target.write_pieces(listing(lasting(head), "events", _rows(found)))
        if json and target is None:
            sys.stdout.writelines(listing(head, "events", _rows(found)))
        elif json:
            sys.stdout.write(as_text({**head, "events": None}))
        elif target is None or not target.is_standard_output:
            _print(head, [] if target is not None else list(_rows(found)))


def _check(request: EventsWithDisc, is_printed: bool) -> str | None:
    """Refuses what there is not; the radius of the disc at the scale 1, for formulas as printed."""
    for option, given in (("--index", request.index), ("--route", request.route)):
        if given is not None:
            what = "pair events of a disc come from no index"
            raise Refusal(what, option, "leave it out")
    check_limit(request.limit)
    if is_printed:
        return "1" if request.Q == ANY else read_disc(request.Q).radius
    if request.Q != ANY:
        mend = "name the disc `disc`; its radius matters to sentences as printed only"
        raise Refusal("events are found for all radii", request.Q, mend)
    return None


def _truth(counts: dict[str, Any]) -> dict[str, int]:
    return {
        "count": counts["true_count"],
        "right": counts["right_count"],
        "missed": counts["true_count"] - counts["right_count"],
        "invented": counts["count"] - counts["right_count"],
    }


def _rows(found: _core.DiscPairEvents) -> Iterator[Row]:
    """Their numbers are made exact now."""
    for start in range(0, len(found), AT_ONCE):
        for rank, condition, features, event in found.rows(start, AT_ONCE):
            change, (square, polynomial, (low, high)), shared, contacts = event
            yield {
                "rank": rank,
                "condition": condition,
                "change": change,
                "radius": {"low": _double(low), "high": _double(high)},
                "squared_radius": square,
                "polynomial": polynomial,
                "features": [_feature(*feature) for feature in features],
                "shared": dict(
                    zip(
                        ("before", "at", "after"),
                        ("segment" if count < 0 else count for count in shared),
                        strict=True,
                    )
                ),
                "contacts": [_contact(*contact) for contact in contacts],
            }


def _double(value: float) -> float | None:
    """Beyond doubles: None."""
    return value if math.isfinite(value) else None


def _feature(kind: str, first: str, second: str) -> Row:
    if kind == "vertex":
        return {"vertex": [first, second]}
    return {"edge": [int(first), int(second)]}


def _contact(condition: str, of: str, end: int, meets: bool, place: tuple[float, float]) -> Row:
    return {
        "condition": condition,
        "of": "ab".index(of) if of else None,
        "end": ("first", "last")[end] if of else None,
        "meets": meets,
        "place": [_double(x) for x in place],
    }


def _print(head: dict[str, Any], rows: list[Row]) -> None:
    named = [
        ("pair events", f"{head['P']} + {head['Q']}"),
        ("form", head["form"]),
        *([("readings", _in_words(head["readings"]))] if head["readings"] else []),
        ("features", f"{head['features']:,} edges and arcs, {head['pairs']:,} pairs"),
        ("events", _numbers(head["count"], head["changes"])),
        ("conditions", _numbers(None, head["conditions"])),
    ]
    if head["truth"] is not None:
        truth = head["truth"]
        told = f"{truth['right']:,} right, {truth['missed']:,} missed of {truth['count']:,}"
        named.append(("in truth", f"{told}, {truth['invented']:,} invented"))
        if "none" in head["changes"]:
            named.append(("none", "at the printed radius the pair's shared points do not change"))
    named.append(("seconds", f"{head['seconds']:.3f}"))
    if head["output"]:
        named.append(("written", head["output"]))
    sys.stdout.write(lines(named))
    for row in rows:
        radius = between(**row["radius"], digits=9)
        features = ", ".join(_named(feature) for feature in row["features"])
        sys.stdout.write(f"{radius:>14}  {row['change']}: {row['condition']}, {features}\n")
    if head["output"] is None and len(rows) < head["count"]:
        sys.stdout.write(f"... {head['count'] - len(rows):,} more; -o FILE writes all\n")
    for warning in head["warnings"]:
        sys.stderr.write(f"warning: {escaped(warning)}\n")


def _in_words(readings: dict[str, str]) -> str:
    return ", ".join(f"{name}={value}" for name, value in readings.items())


def _numbers(total: int | None, parts: dict[str, int]) -> str:
    told = ", ".join(f"{name} {count:,}" for name, count in parts.items() if count)
    if total is None:
        return told or "none"
    return counted(total, "event") + (f": {told}" if told else "")


def _named(feature: Row) -> str:
    if "vertex" in feature:
        return f"arc about ({', '.join(feature['vertex'])})"
    return f"edge {feature['edge'][0]}.{feature['edge'][1]}"
