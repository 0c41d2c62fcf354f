"""`minkref fit` and `minkref trap` of polyhedra."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import give
from minkref.errors import Refusal, refusing
from minkref.exact import text_of_bounds
from minkref.motion.commands.fit import print_fit
from minkref.motion.commands.path_rows import (
    BY_TRANSLATION,
    extreme_scales,
    proof_documents,
    range_documents,
    space_contact_document,
)
from minkref.motion.commands.trap import print_trap
from minkref.motion.scale_ranges import CONTACTS
from minkref.output.documents import Stopwatch, document
from minkref.space.operand import read_summand
from minkref.verbs.fit import PLACE, FitInSpace
from minkref.verbs.path import check_words
from minkref.verbs.trap import TrapInSpace


def run_fit(request: FitInSpace) -> None:
    """The fit at a place, or anywhere."""
    watch = Stopwatch()
    part, container, contact, place = (
        request.part, request.container, request.contact, request.at,
    )  # fmt: skip
    check_words(contact=(contact, CONTACTS))
    if (place is not None) == request.anywhere:
        raise Refusal("one question is asked at a time", "minkref fit", PLACE)
    first, second = read_summand(part), read_summand(container)
    sets = first.surface, second.surface
    with memory_wall(request.memory, "the fit", f"{part} and {container}", SMALLER):
        if place is None:
            answer = refusing(
                f"{part}, {container}", lambda: _core.fit_anywhere_in_space(*sets, contact)
            )
            fields = free_fields(answer)
        else:
            where = place
            (ranges, bounds, _), proofs = refusing(
                f"{part}, {container}", lambda: _core.fit_at_in_space(*sets, where, contact)
            )
            rows = [(row[0], row[1], "contact", row[4], row) for row in bounds]
            fields = free_fields((ranges, rows, [], proofs, 0))
            fields["place"] = None
    value = document(
        "fit",
        watch,
        dimension=3,
        part=first.name,
        container=second.name,
        question="anywhere" if place is None else "at",
        places=[] if place is None else [list(place)],
        contact=contact,
        warnings=first.warnings + second.warnings,
        motion=BY_TRANSLATION,
        **fields,
    )
    give(value, request.json, print_fit)


def run_trap(request: TrapInSpace) -> None:
    watch = Stopwatch()
    part, obstacles, contact = request.part, request.obstacles, request.contact
    check_words(contact=(contact, CONTACTS))
    window = text_of_bounds(request.from_scale, request.to_scale)
    first, second = read_summand(part), read_summand(obstacles)
    with memory_wall(request.memory, "the trap", f"{part} and {obstacles}", SMALLER):
        answer = refusing(
            f"{part}, {obstacles}",
            lambda: _core.trapped_scales_in_space(
                first.surface, second.surface, request.at, contact, *window
            ),
        )
    fields = free_fields(answer)
    del fields["place"], fields["supports"]
    value = document(
        "trap",
        watch,
        dimension=3,
        part=first.name,
        obstacles=second.name,
        at=list(request.at),
        contact=contact,
        **{"from": window[0], "to": window[1]},
        warnings=first.warnings + second.warnings,
        motion=BY_TRANSLATION,
        **fields,
    )
    give(value, request.json, print_trap)


def free_fields(answer: Any) -> dict[str, Any]:
    """The fields of scales at which a polyhedron fits or is trapped."""
    ranges, bounds, supports, proofs, critical = answer
    return {
        "scales": range_documents(ranges),
        **extreme_scales(ranges),
        "place": list(bounds[-1][4][4]) if bounds and bounds[-1][4] is not None else None,
        "bounds": [_bound(row) for row in bounds],
        "supports": [
            {"vertex": vertex, "face": face, "weight": weight} for vertex, face, weight in supports
        ],
        "proofs": proof_documents(proofs),
        "critical_scales": critical,
    }


def _bound(row: Any) -> dict[str, Any]:
    scale, ends, event, at, contact = row
    told = None if contact is None else space_contact_document(contact)
    return {
        "scale": scale,
        "ends": ends,
        "event": event,
        "at": list(at) if told is None or event != "contact" else told["touching"],
        "contact": None if told is None else {key: told[key] for key in ("part", "obstacle")},
    }
