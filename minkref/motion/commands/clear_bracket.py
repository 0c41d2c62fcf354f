"""`minkref fit` and `minkref trap` of a part that keeps a distance: two scales around the last one
at which it fits, or gets away."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from functools import partial
from typing import Any

from minkref.certain_digits import enclosing
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import print_lines
from minkref.cli.progress import progress
from minkref.errors import refusing
from minkref.exact import text_of_bounds
from minkref.motion.clear_fits import ClearTrap, KeptDistance
from minkref.motion.clear_rooms import Container
from minkref.motion.commands.clear import clear_range, clear_range_text
from minkref.motion.commands.clear_picture import clear_picture
from minkref.motion.commands.disc_rows import rounded_place
from minkref.motion.commands.fit import written_rows
from minkref.motion.commands.path_answer import FORMATS, finish
from minkref.motion.commands.path_rows import BY_TRANSLATION, number_text, point_text
from minkref.motion.scale_bracket import TOLERANCE, ScaleBracket
from minkref.motion.scale_ranges import CONTACTS
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import read_operand
from minkref.verbs.fit import FitInPlane
from minkref.verbs.trap import Trap

Row = dict[str, Any]
CAUSES = {
    "apart": "no way leads there",
    "meets": "no place is free",
    "contact": "the part at a given place",
    "neck": "a neck on the best way",
    "room": "the room at the best place",
}


def run_fit(request: FitInPlane, question: str, places: list[tuple[str, str]]) -> None:
    """Answers `--anywhere` or `--between` with a clearance, for all scales."""
    watch = Stopwatch()
    target = target_of(request.output, None, FORMATS, "json", request.json, has_format=False)
    first, second = read_operand(request.part), read_operand(request.container)
    if request.output is not None:
        refuse_overwriting(request.output, [first.file, second.file])
    names = f"{request.part} and {request.container}"
    given = None if question == "anywhere" else (places[0], places[1])
    with _bracketing(request, "the fit", names) as kept:
        asked = Container(first.set, second.set, second.name, given, kept.clearance, kept.threads)
        found = refusing(second.name, lambda: kept.fits(asked, first.name))
        witness = refusing(second.name, lambda: _witness(asked, found, kept.allowed))
    value = document(
        "fit",
        watch,
        part=first.name,
        container=second.name,
        question=question,
        places=[list(place) for place in places],
        **_shared(request, found),
        witness=witness,
        warnings=first.warnings + second.warnings,
        output=str(request.output) if request.output else None,
    )

    def shown(value: Row) -> None:
        where = f"{question} {' and '.join(map(point_text, places))}".rstrip()
        rows = [("fits", f"{where}: {bracket_text(value['bracket'])}"), *_limit_rows(value)]
        if value["witness"] is not None and question == "anywhere":
            place, scale = value["witness"]["place"], value["witness"]["scale"]
            rows.append(("place", f"{point_text(place)}, at the scale {number_text(scale)}"))
        _print(value, value["container"], rows)

    drawn = partial(clear_picture, first.set, second.set, value, value["witness"], "fits")
    finish(value, target, request.json, drawn, printed=shown)


def run_trap(request: Trap) -> None:
    """Answers `minkref trap` with a clearance, for all scales of the window."""
    watch = Stopwatch()
    target = target_of(request.output, None, FORMATS, "json", request.json, has_format=False)
    first, second = read_operand(request.part), read_operand(request.obstacles)
    if request.output is not None:
        refuse_overwriting(request.output, [first.file, second.file])
    window = (request.from_scale, request.to_scale)
    with _bracketing(request, "the trap", f"{request.part} and {request.obstacles}") as kept:
        found = refusing(
            second.name, lambda: kept.trap(first.set, second.set, request.at, window, first.name)
        )
    texts = text_of_bounds(*window)
    value = document(
        "trap",
        watch,
        part=first.name,
        obstacles=second.name,
        at=list(request.at),
        **_shared(request, found.escapes),
        free=[clear_range(one) for one in found.free.ranges],
        is_trapped=not found.is_empty,
        **{"from": texts[0], "to": texts[1]},
        warnings=first.warnings + second.warnings,
        output=str(request.output) if request.output else None,
    )

    def shown(value: Row) -> None:
        free = ", ".join(map(clear_range_text, value["free"])) or "at no scale"
        rows = [("free", f"at {point_text(value['at'])}: {free}")]
        if value["bracket"] is not None:
            rows += [("gets out", bracket_text(value["bracket"])), *_limit_rows(value)]
        rows.append(("trapped", trapped_text(value)))
        _print(value, value["obstacles"], rows)

    scale = _trapped_scale(found)
    shown_at = None if scale is None else {"scale": str(scale), "place": list(request.at)}
    drawn = partial(clear_picture, first.set, second.set, value, shown_at, "trapped")
    finish(value, target, request.json, drawn, printed=shown)


@contextmanager
def _bracketing(request: FitInPlane | Trap, work: str, names: str) -> Iterator[KeptDistance]:
    """Makes the distance to keep; within it memory is limited, and the certain digits are shown."""
    assert request.clearance is not None
    tolerance = request.tolerance or TOLERANCE
    total = max(1, _digits(tolerance))
    with memory_wall(request.memory, work, names, SMALLER), progress(total) as steps:
        steps.now("certain digits")
        shown = 0

        def told(low: Fraction, high: Fraction) -> None:
            nonlocal shown
            digits = min(total, _digits((high - low) / high))
            steps.now(f"certain digits of about {number_text(str(high))}")
            steps.done(max(0, digits - shown))
            shown = max(shown, digits)

        allowed = request.contact == CONTACTS[0]
        yield KeptDistance(request.clearance, allowed, tolerance, cores(), told)


def bracket_document(found: ScaleBracket) -> Row:
    fails = found.fails_from
    return {
        "holds_to": str(found.holds_to),
        "fails_from": None if fails is None else str(fails),
        "is_exact": found.is_exact,
        "end_in": found.end_in,
        "decisions": found.decisions,
    }


def bracket_text(bracket: Row) -> str:
    """Write all scales up to an end, which lies between two scales."""
    holds, fails = bracket["holds_to"], bracket["fails_from"]
    close = "]" if bracket["end_in"] else ")"
    if fails is None:
        return f"(0, {number_text(holds)}], as far as was asked"
    if bracket["is_exact"]:
        return "at no scale" if holds == "0" else f"(0, {number_text(holds)}{close}"
    if holds == "0":
        return f"at no scale from {number_text(fails)} on"
    digits = _digits(1 - Fraction(holds) / Fraction(fails)) + 2
    return f"(0, s{close}, s {enclosing(holds, fails, digits)}, both decided exactly"


def trapped_text(value: Row) -> str:
    """Write the scales of a trap: from the bracket on, up to the last free scale."""
    if not value["is_trapped"]:
        return "at no scale"
    bracket, last = value["bracket"], value["free"][-1]
    first, is_in = bracket["fails_from"], not bracket["end_in"]
    if bracket["holds_to"] != "0" and not bracket["is_exact"]:
        return clear_range_text({**last, "from": {"exact": "s"}, "from_in": is_in}) + ", the same s"
    if first == "0" or (bracket["holds_to"] == "0" and first == value["from"]):
        return clear_range_text(last)  # all free scales
    return clear_range_text({**last, "from": {"exact": first}, "from_in": is_in})


def _digits(share: Fraction) -> int:
    """Count the digits that a number has before a share of it matters."""
    return len(str(share.denominator // share.numerator)) - 1


def _shared(request: FitInPlane | Trap, found: ScaleBracket | None) -> Row:
    return {
        "contact": request.contact,
        "clearance": str(request.clearance),
        "tolerance": str(request.tolerance or TOLERANCE),
        "motion": BY_TRANSLATION,
        "bracket": None if found is None else bracket_document(found),
        "cause": None if found is None else found.cause,
        "near": None if found is None or found.place is None else rounded_place(found.place),
    }


def _trapped_scale(found: ClearTrap) -> Fraction | None:
    """Choose a scale at which the part is trapped."""
    if found.is_empty or found.escapes is None or found.escapes.fails_from is None:
        return None
    first, last = found.escapes.fails_from, found.free.ranges[-1].high
    if first > 0 and not (found.escapes.end_in and found.escapes.is_exact):
        return first
    return (first + Fraction(last.bounds[0])) / 2 if last else 2 * first or Fraction(1)


def _witness(asked: Container, found: ScaleBracket, allowed: bool) -> Row | None:
    """A scale and a place at which the part keeps the clearance: exact."""
    scale = found.holds_to
    if scale == 0:
        return None
    less = scale * (1 - TOLERANCE)
    if asked.places is not None:
        one = scale if found.end_in or not found.is_exact else less
        return {"scale": str(one), "place": list(asked.places[0])}
    if found.place is None or not all(map(math.isfinite, found.place)):
        return None
    x, y = map(Fraction, found.place)
    for one in (scale, less):
        if asked.keeps(one, (x, y), allowed):
            return {"scale": str(one), "place": [str(x), str(y)]}
    return None


def _limit_rows(value: Row) -> list[tuple[str, str]]:
    near = value["near"]
    is_told = near is not None and None not in near
    where = f", near ({near[0]:.9g}, {near[1]:.9g})" if is_told else ""
    return [("limit", CAUSES[value["cause"]] + where)]


def _print(value: Row, among: str, rows: list[tuple[str, str]]) -> None:
    decisions = 0 if value["bracket"] is None else value["bracket"]["decisions"]
    print_lines(
        [
            ("part", f"{value['part']} in {among}, contact {value['contact']}"),
            ("clearance", number_text(value["clearance"])),
            *rows,
            ("motion", value["motion"]),
            ("decided", f"exactly at {decisions} scales"),
            *written_rows(value),
            ("seconds", f"{value['seconds']:.3f}"),
        ],
        value,
    )
