"""`minkref trap disc OBSTACLES --at X,Y`: the radii at which a disc does not get out."""

from __future__ import annotations

from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import refusing
from minkref.motion.commands.disc_rows import give_radii, question_of, radii_document
from minkref.motion.commands.path_rows import point_text
from minkref.motion.disc_radii import trapped
from minkref.output.documents import Stopwatch
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import read_operand
from minkref.verbs.trap import TrapOfDisc


def run(request: TrapOfDisc) -> None:
    watch = Stopwatch()
    question = question_of(request, request.obstacles)
    with memory_wall(request.memory, "the trap", request.obstacles, SIMPLER):
        operand = read_operand(request.obstacles)
        found = refusing(operand.name, lambda: trapped(operand.set, request.at, question, cores()))
    value = radii_document(
        "trap",
        watch,
        request,
        found,
        obstacles=operand.name,
        at=list(request.at),
        warnings=operand.warnings,
    )
    part = f"{request.part} in {operand.name}, contact {request.contact}"
    rows = [("part", part), ("where", f"at {point_text(request.at)}")]
    give_radii(value, request.json, rows, "trapped")
