"""`minkref trap` in the plane: the scales at which a part cannot get out."""

from __future__ import annotations

from functools import partial
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import print_lines
from minkref.errors import Refusal, refusing
from minkref.exact import text_of_bounds
from minkref.motion.commands.fit import (
    bound_rows,
    free_document,
    refuse_both,
    refuse_without_clearance,
    written_rows,
)
from minkref.motion.commands.fit_picture import fit_picture
from minkref.motion.commands.path_answer import FORMATS, finish
from minkref.motion.commands.path_proof import proved
from minkref.motion.commands.path_rows import point_text, ranges_text
from minkref.motion.scale_ranges import CONTACTS, range_values
from minkref.output.documents import Stopwatch, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.operand import read_operand
from minkref.verbs.path import check_words
from minkref.verbs.proof_option import proof_document, proof_files, proof_rows
from minkref.verbs.trap import Trap


def run(request: Trap) -> None:
    watch = Stopwatch()
    part, obstacles, contact, place = (
        request.part, request.obstacles, request.contact, request.at,
    )  # fmt: skip
    check_words(contact=(contact, CONTACTS))
    if request.clearance is not None:
        _run_with_clearance(request)
        return
    refuse_without_clearance(request)
    window = text_of_bounds(request.from_scale, request.to_scale)
    target = target_of(request.output, None, FORMATS, "json", request.json, has_format=False)
    first, second = read_operand(part), read_operand(obstacles)
    if request.output is not None:
        refuse_overwriting(request.output, [first.file, second.file])
    proof = proof_files(request.certify, [first.file, second.file], request.output)
    with memory_wall(request.memory, "the trap", f"{part} and {obstacles}", SMALLER):
        rows = refusing(
            f"{part}, {obstacles}",
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
        obstacles=second.name,
        at=list(place),
        contact=contact,
        **{"from": window[0], "to": window[1]},
        warnings=first.warnings + second.warnings,
        output=str(request.output) if request.output else None,
        certificate=proof_document(proven),
    )
    drawn = partial(fit_picture, first.set, second.set, value, "trapped")
    finish(value, target, request.json, drawn, [] if proven is None else [proven[0]], print_trap)


def _run_with_clearance(request: Trap) -> None:
    from minkref.motion.commands import clear_bracket, clear_scale

    if request.certify is not None:
        what = "there is no certificate of a clearance"
        raise Refusal(what, "--certify", "leave it out, or leave --clearance out")
    if request.scale is None:
        clear_bracket.run_trap(request)
        return
    refuse_both(request)
    clear_scale.run_trap(request)


def print_trap(value: dict[str, Any]) -> None:
    rows = [
        ("part", f"{value['part']} in {value['obstacles']}, contact {value['contact']}"),
        (
            "trapped",
            f"by translation, at {point_text(value['at'])}: {ranges_text(value['scales'])}",
        ),
        ("motion", value["motion"]),
        *bound_rows(value),
        *written_rows(value),
        *proof_rows(value),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines(rows, value)
