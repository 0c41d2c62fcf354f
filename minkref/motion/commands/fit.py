"""`minkref fit` in the plane: the scales at which a part fits."""

from __future__ import annotations

from functools import partial
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import print_lines
from minkref.errors import Refusal, refusing
from minkref.motion.commands.fit_picture import fit_picture
from minkref.motion.commands.path_answer import FORMATS, finish
from minkref.motion.commands.path_rows import (
    BY_TRANSLATION,
    MOST_ROWS,
    extreme_scales,
    feature_text,
    free_bound_document,
    number_text,
    point_text,
    proof_documents,
    range_documents,
    ranges_text,
)
from minkref.motion.scale_ranges import CONTACTS
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.operand import read_operand
from minkref.verbs.fit import FitInPlane, FitOfDisc
from minkref.verbs.path import check_words
from minkref.verbs.trap import Trap


def run(request: FitInPlane) -> None:
    watch = Stopwatch()
    part, container, contact = request.part, request.container, request.contact
    check_words(contact=(contact, CONTACTS))
    question, places = question_named(request)
    if request.clearance is not None:
        _run_with_clearance(request, question, places)
        return
    refuse_without_clearance(request)
    target = target_of(request.output, None, FORMATS, "json", request.json, has_format=False)
    first, second = read_operand(part), read_operand(container)
    if request.output is not None:
        refuse_overwriting(request.output, [first.file, second.file])
    ask: dict[str, Any] = {
        "at": lambda: _core.fit_at(first.set, second.set, places[0], contact),
        "anywhere": lambda: _core.fit_anywhere(first.set, second.set, contact),
        "between": lambda: _core.fit_between(first.set, second.set, places[0], places[1], contact),
    }
    with memory_wall(request.memory, "the fit", f"{part} and {container}", SMALLER):
        rows = refusing(f"{part}, {container}", ask[question])
    value = free_document(
        "fit",
        watch,
        rows,
        part=first.name,
        container=second.name,
        question=question,
        places=[list(place) for place in places],
        contact=contact,
        warnings=first.warnings + second.warnings,
        output=str(request.output) if request.output else None,
    )
    drawn = partial(fit_picture, first.set, second.set, value, "fits")
    finish(value, target, request.json, drawn, printed=print_fit)


def _run_with_clearance(request: FitInPlane, question: str, places: list[tuple[str, str]]) -> None:
    from minkref.motion.commands import clear, clear_bracket, clear_scale

    if question == "at":
        _refuse_options(request, "a place is answered for all scales, without a bracket")
        clear.run_fit_at(request, places[0])
    elif request.scale is not None:
        refuse_both(request)
        clear_scale.run_fit(request, question, places)
    else:
        clear_bracket.run_fit(request, question, places)


def refuse_without_clearance(request: FitInPlane | Trap) -> None:
    """Refuse options that belong to a clearance."""
    _refuse_options(request, "without a clearance all scales are answered, without a bracket")


def refuse_both(request: FitInPlane | Trap) -> None:
    if request.tolerance is not None:
        what = "one scale is decided, without a bracket"
        raise Refusal(what, f"--tolerance {request.tolerance}", "leave it out")


def _refuse_options(request: FitInPlane | Trap, what: str) -> None:
    for option, value in (("--scale", request.scale), ("--tolerance", request.tolerance)):
        if value is not None:
            raise Refusal(what, f"{option} {value}", "leave it out")


def question_named(request: FitInPlane | FitOfDisc) -> tuple[str, list[tuple[str, str]]]:
    """The one question that is asked, and its places."""
    at, between = request.at, request.between
    if (at is not None) + request.anywhere + (between is not None) != 1:
        mend = "give --at X,Y, --anywhere or --between X,Y X,Y"
        raise Refusal("one question is asked at a time", "minkref fit", mend)
    question = "at" if at is not None else "anywhere" if request.anywhere else "between"
    return question, [at] if at is not None else list(between or ())


def free_document(name: str, watch: Stopwatch, rows: Any, **fields: Any) -> dict[str, Any]:
    """The document of a fit or a trap."""
    ranges, bounds, proofs, critical = rows
    return document(
        name,
        watch,
        **fields,
        motion=BY_TRANSLATION,
        scales=range_documents(ranges),
        **extreme_scales(ranges),
        bounds=[free_bound_document(row) for row in bounds],
        proofs=proof_documents(proofs),
        critical_scales=critical,
    )


def bound_rows(value: dict[str, Any]) -> list[tuple[str, str]]:
    """A line for each bound, and one for the proofs."""
    rows = []
    for bound in value["bounds"][:MOST_ROWS]:
        side = "ends" if bound["ends"] else "begins"
        rows.append((number_text(bound["scale"]), f"{side}: {_cause(bound, 'dimension' in value)}"))
    if len(value["bounds"]) > MOST_ROWS:
        rows.append(("more", f"{len(value['bounds']) - MOST_ROWS:,}; --json prints all"))
    how = "decisions" if "dimension" in value else "static sums"
    rows.append(("found again", f"{len(value['proofs'])} {how} at and beside the bounds"))
    return rows


def written_rows(value: dict[str, Any]) -> list[tuple[str, str]]:
    return [("written", value["output"])] if value.get("output") else []


def _cause(bound: dict[str, Any], in_space: bool) -> str:
    """The event at a bound and where, and what touches there."""
    contact, where = bound["contact"], point_text(bound["at"])
    if contact is None:
        return f"{bound['event']} of free places, {where}"
    part, obstacle = (feature_text(contact[one], in_space) for one in ("part", "obstacle"))
    touching = f"{part} of the part touches {obstacle}"
    if bound["event"] == "contact":
        return f"{touching}, {where}"
    return f"{bound['event']} of free places, {where}: there {touching}"


def print_fit(value: dict[str, Any]) -> None:
    where = {"at": "at", "anywhere": "anywhere", "between": "between"}[value["question"]]
    places = " and ".join(point_text(place) for place in value["places"])
    rows = [
        ("part", f"{value['part']} in {value['container']}, contact {value['contact']}"),
        ("fits", f"{where} {places}".rstrip() + f": {ranges_text(value['scales'])}"),
        *([("place", point_text(value["place"]))] if value.get("place") else []),
        ("motion", value["motion"]),
        *bound_rows(value),
        *written_rows(value),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines(rows, value)
