"""`minkref trap disc OBSTACLES --at X,Y`: the radii at which a disc does not get out."""

from __future__ import annotations

from functools import partial

from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import refusing
from minkref.motion.commands.disc_picture import disc_room_picture
from minkref.motion.commands.disc_rows import question_of, radii_document, radii_shown, range_text
from minkref.motion.commands.path_answer import FORMATS, finish
from minkref.motion.commands.path_rows import point_text
from minkref.motion.disc_radii import trapped
from minkref.output.documents import Stopwatch, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import read_operand
from minkref.verbs.trap import TrapOfDisc


def run(request: TrapOfDisc) -> None:
    watch = Stopwatch()
    question = question_of(request, request.obstacles)
    target = target_of(request.output, None, FORMATS, "json", request.json, has_format=False)
    with memory_wall(request.memory, "the trap", request.obstacles, SIMPLER):
        operand = read_operand(request.obstacles)
        if request.output is not None:
            refuse_overwriting(request.output, [operand.file])
        found = refusing(operand.name, lambda: trapped(operand.set, request.at, question, cores()))
    value = radii_document(
        "trap",
        watch,
        request,
        found,
        obstacles=operand.name,
        at=list(request.at),
        warnings=operand.warnings,
        output=None if request.output is None else str(request.output),
    )
    part = f"{request.part} in {operand.name}, contact {request.contact}"
    rows = [("part", part), ("where", f"at {point_text(request.at)}")]
    drawn = partial(
        disc_room_picture, operand, [request.at], found, range_text(value), "is trapped"
    )
    finish(value, target, request.json, drawn, printed=radii_shown(rows, "trapped"))
