"""`minkref trap PART ASSEMBLY --at X,Y`: the scales at which a part cannot get out."""

from __future__ import annotations

from typing import Annotated, Any

import typer
from minkref import _core
from minkref.cli.memory import SMALLER, Memory, memory_wall
from minkref.cli.options import Json, Schema, WindowFrom, WindowTo
from minkref.cli.output import give, print_lines
from minkref.errors import Refusal, refusing
from minkref.exact import read_point, read_window
from minkref.motion.commands.path_proof import (
    Certify,
    proof_document,
    proof_files,
    proof_rows,
    proved,
)
from minkref.motion.commands.path_rows import point_text, ranges_text
from minkref.motion.scale_ranges import CONTACTS, range_values
from minkref.output.documents import Stopwatch, write_together
from minkref.plane.operand import read_operand
from minkref.space.operand import in_space
from minkref.verbs.fit import Part, bound_rows, free_document
from minkref.verbs.path import Contact, check_words

EXAMPLES = """Examples:

minkref trap ball.wkt cage.wkt --at 2,2

minkref trap ball.wkt cage.wkt --at 2,2 --contact forbidden --from 1/2 --to 4 --json

minkref trap ball.wkt cage.wkt --at 2,2 --certify trap.cert.json"""


def command(
    part: Part,
    assembly: Annotated[str, typer.Argument(help="What may hold the part: a file or a model.")],
    at: Annotated[str, typer.Option("--at", help="Where the part's origin is.", metavar="X,Y")],
    contact: Contact = "allowed",
    from_scale: WindowFrom = None,
    to_scale: WindowTo = None,
    certify: Certify = None,
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Find all scales at which a part is free at a place, and no translation takes it away from the
    assembly. A rotation may free it all the same: "trapped" is by translations only. Exact, and
    found again at, just below and just above each bound by static sums."""
    watch = Stopwatch()
    check_words(contact=(contact, CONTACTS))
    if in_space(part, assembly):
        what = "traps are found in the plane"
        raise Refusal(what, f"{part} and {assembly}", "give two polygon sets", "not-in-space")
    window = read_window(from_scale, to_scale)
    place = read_point(at, "--at")
    first, second = read_operand(part), read_operand(assembly)
    proof = proof_files(certify, [first.file, second.file])
    with memory_wall(memory, "the trap", f"{part} and {assembly}", SMALLER):
        rows = refusing(
            f"{part}, {assembly}",
            lambda: _core.trapped_scales(
                first.set, second.set, place, contact, window[0], window[1]
            ),
        )
        proven = proved(
            proof,
            (first.name, second.name),
            (first.set, second.set),
            [place],
            lambda made: made.trap(contact, window[0], window[1], range_values(rows[0])),
        )
    value = free_document(
        "trap",
        watch,
        rows,
        part=first.name,
        assembly=second.name,
        at=list(place),
        contact=contact,
        **{"from": window[0], "to": window[1]},
        warnings=first.warnings + second.warnings,
        certificate=proof_document(proven),
    )
    if proven is not None:
        write_together({**proven[0].contents()})
    give(value, json, _print)


def _print(value: dict[str, Any]) -> None:
    rows = [
        ("part", f"{value['part']} in {value['assembly']}, contact {value['contact']}"),
        (
            "trapped",
            f"by translation, at {point_text(value['at'])}: {ranges_text(value['scales'])}",
        ),
        ("motion", value["motion"]),
        *bound_rows(value),
        *proof_rows(value),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines(rows, value)
