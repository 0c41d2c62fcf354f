"""`minkref fit PART CONTAINER`: the scales at which a part fits."""

from __future__ import annotations

from typing import Annotated, Any

import typer
from minkref import _core
from minkref.cli.memory import SMALLER, Memory, memory_wall
from minkref.cli.options import Json, Schema
from minkref.cli.output import give, print_lines
from minkref.errors import Refusal, refusing
from minkref.exact import read_point
from minkref.motion.commands.path_in_space import fit_in_space
from minkref.motion.commands.path_rows import (
    BY_TRANSLATION,
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
from minkref.output.documents import Stopwatch, document
from minkref.plane.operand import read_operand
from minkref.space.operand import in_space
from minkref.verbs.path import MOST_ROWS, Contact, check_words

EXAMPLES = """Examples:

minkref fit disc1 g1 --anywhere

minkref fit bolt.wkt slot.wkt --at 3,1/2

minkref fit cutter.wkt pocket.wkt --between 2,2 7,2 --contact forbidden --json

minkref fit part.off housing.off --at 3,1/2,0"""

Part = Annotated[str, typer.Argument(help="The part, scaled about its origin: a file or a model.")]


def command(
    part: Part,
    container: Annotated[
        str, typer.Argument(help="What the part is to lie in: a file or a model.")
    ],
    at: Annotated[
        str | None,
        typer.Option(
            "--at", help="With its origin at this place; X,Y,Z in space.", metavar="X,Y[,Z]"
        ),
    ] = None,
    anywhere: Annotated[bool, typer.Option("--anywhere", help="At some place.")] = False,
    between: Annotated[
        tuple[str, str] | None,
        typer.Option(
            "--between", help="At both places and along a way between them.", metavar="X,Y X,Y"
        ),
    ] = None,
    contact: Contact = "allowed",
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Find all scales at which a part lies in a container: at a place, somewhere, or all along a
    way between two places, by translations only; in space at a place. Exact, and found again at,
    just below and just above each bound by static sums, in space by what the part's pieces
    cover."""
    watch = Stopwatch()
    check_words(contact=(contact, CONTACTS))
    if (at is not None) + anywhere + (between is not None) != 1:
        mend = "give --at X,Y, --anywhere or --between X,Y X,Y"
        raise Refusal("one question is asked at a time", "minkref fit", mend)
    if in_space(part, container):
        give(fit_in_space(watch, part, container, at, contact, memory), json, _print)
        return
    question = "at" if at is not None else "anywhere" if anywhere else "between"
    places = [read_point(at, "--at")] if at is not None else []
    places += [read_point(place, "--between") for place in between or ()]
    first, second = read_operand(part), read_operand(container)
    ask: dict[str, Any] = {
        "at": lambda: _core.fit_at(first.set, second.set, places[0], contact),
        "anywhere": lambda: _core.fit_anywhere(first.set, second.set, contact),
        "between": lambda: _core.fit_between(first.set, second.set, places[0], places[1], contact),
    }
    with memory_wall(memory, "the fit", f"{part} and {container}", SMALLER):
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
    )
    give(value, json, _print)


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
        contact = bound["contact"]
        told = (
            f"{bound['event']} of free places"
            if contact is None
            else f"{feature_text(contact['part'], 'dimension' in value)} of the part touches "
            f"{feature_text(contact['obstacle'], 'dimension' in value)}"
        )
        side = "ends" if bound["ends"] else "begins"
        rows.append((number_text(bound["scale"]), f"{side}: {told}, {point_text(bound['at'])}"))
    if len(value["bounds"]) > MOST_ROWS:
        rows.append(("more", f"{len(value['bounds']) - MOST_ROWS:,}; --json prints all"))
    how = "decisions" if "dimension" in value else "static sums"
    rows.append(("found again", f"{len(value['proofs'])} {how} at and beside the bounds"))
    return rows


def _print(value: dict[str, Any]) -> None:
    where = {"at": "at", "anywhere": "anywhere", "between": "between"}[value["question"]]
    places = " and ".join(point_text(place) for place in value["places"])
    rows = [
        ("part", f"{value['part']} in {value['container']}, contact {value['contact']}"),
        ("fits", f"{where} {places}".rstrip() + f": {ranges_text(value['scales'])}"),
        ("motion", value["motion"]),
        *bound_rows(value),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines(rows, value)
