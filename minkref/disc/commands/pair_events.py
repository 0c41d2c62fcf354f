"""`minkref events P disc --kind pair`: the radii at which two offset features start or stop to
share points, as it is or as the Appendix prints it."""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certain_digits import between
from minkref.cli.memory import SMALLER, memory_wall
from minkref.disc.disc import ANY, read_disc
from minkref.errors import Refusal, choice, refusing
from minkref.exact import read_scale
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
from minkref.plane.event_values import FORMS
from minkref.plane.operand import read_operand

FORMATS = ("json", "jsonl")
CHANGES = ("birth", "death", "touch", "swap", "overlap", "none")
CONDITIONS = ("end on line", "end on circle", "circle on line", "circles")
# Sentences of the Appendix that do not hold (docs/disc.md, "Pair events").
SENTENCES = ("rejected", "number", "radical", "line", "parallel")
SHOWN = 10  # events that people see
AT_ONCE = 1000  # rows that are made exact in one call
Row = dict[str, Any]


def pair_events_with_disc(
    P: str,
    Q: str,
    form: str,
    first: str | None,
    last: str | None,
    limit: int | None,
    output: Path | None,
    file_format: str | None,
    json_document: bool,
    memory: int | None,
    given: dict[str, bool],
) -> None:
    """The command, its options read but not yet checked. `given`: options that there are not."""
    watch = Stopwatch()
    radius = _check(Q, form, limit, given)
    window = _window(first, last)
    target = target_of(output, file_format, FORMATS, "json", json_document)
    most = limit if limit is not None or json_document or target is not None else SHOWN
    with memory_wall(memory, "pair events of a disc", P, SMALLER):
        operand = read_operand(P)
        if output is not None:
            refuse_overwriting(output, [operand.file])
        squares = [None if bound is None else str(bound**2) for bound in window]
        printed = list(SENTENCES) if form == "printed" else []
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
            **{"from": None if window[0] is None else str(window[0])},
            to=None if window[1] is None else str(window[1]),
            kind="pair",
            form=form,
            radius=radius,
            warnings=operand.warnings,
            output=str(output) if output else None,
            compute_seconds=found.seconds,
            **{name: counts[name] for name in ("features", "pairs", "filtered_pairs")},
            exact_signs=counts["exact_signs"],
            changes={name: counts["changes"].get(name, 0) for name in CHANGES},
            conditions={name: counts["kinds"].get(name, 0) for name in CONDITIONS},
            count=counts["count"],
            truth=_truth(counts) if form == "printed" else None,
        )
        if target is not None and target.form == "jsonl":
            target.write_pieces(json.dumps(row) + "\n" for row in _rows(found))
        elif target is not None:
            target.write_pieces(listing(lasting(head), "events", _rows(found)))
        if json_document and target is None:
            sys.stdout.writelines(listing(head, "events", _rows(found)))
        elif json_document:
            sys.stdout.write(as_text({**head, "events": None}))
        elif target is None or not target.is_standard_output:
            _print(head, [] if target is not None else list(_rows(found)))


def _check(Q: str, form: str, limit: int | None, given: dict[str, bool]) -> str | None:
    """Refuses what there is not; the radius of the disc at the scale 1, for formulas as printed."""
    if form not in FORMS:
        raise Refusal(f"there is no form {form!r}", "--form", choice(form, FORMS))
    for option, is_given in given.items():
        if is_given:
            raise Refusal("events of a disc do not have this option", option, "leave it out")
    if limit is not None and limit < 0:
        raise Refusal("the limit is negative", f"--limit {limit}", "give a number of events")
    if form == "printed":
        return "1" if Q == ANY else read_disc(Q).radius
    if Q != ANY:
        mend = "name the disc `disc`; its radius matters to --form printed only"
        raise Refusal("events are found for all radii", Q, mend)
    return None


def _window(first: str | None, last: str | None) -> tuple[Fraction | None, Fraction | None]:
    low = None if first is None else Fraction(read_scale(first, "--from"))
    high = None if last is None else Fraction(read_scale(last, "--to"))
    if low is not None and high is not None and low > high:
        raise Refusal(
            "no radius is in the window", f"--from {first} --to {last}", "exchange the bounds"
        )
    return low, high


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
        ("features", f"{head['features']:,} edges and arcs, {head['pairs']:,} pairs"),
        ("events", _numbers(head["count"], head["changes"])),
        ("conditions", _numbers(None, head["conditions"])),
    ]
    if head["truth"] is not None:
        truth = head["truth"]
        told = f"{truth['right']:,} right, {truth['missed']:,} missed of {truth['count']:,}"
        named.append(("in truth", f"{told}, {truth['invented']:,} invented"))
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


def _numbers(total: int | None, parts: dict[str, int]) -> str:
    told = ", ".join(f"{name} {count:,}" for name, count in parts.items() if count)
    if total is None:
        return told or "none"
    return counted(total, "event") + (f": {told}" if told else "")


def _named(feature: Row) -> str:
    if "vertex" in feature:
        return f"arc about ({', '.join(feature['vertex'])})"
    return f"edge {feature['edge'][0]}.{feature['edge'][1]}"
