"""`minkref path disc OBSTACLES PATH`: the radii at which a disc passes along a path."""

from __future__ import annotations

from functools import partial

from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import refusing
from minkref.motion.commands.disc_picture import disc_path_picture
from minkref.motion.commands.disc_rows import question_of, radii_document, radii_shown, range_text
from minkref.motion.commands.path_answer import FORMATS, finish
from minkref.motion.disc_radii import on_path
from minkref.motion.path_text import read_path
from minkref.output.documents import Stopwatch, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.operand import read_operand
from minkref.verbs.path import PathOfDisc


def run(request: PathOfDisc) -> None:
    watch = Stopwatch()
    question = question_of(request, request.obstacles)
    output = request.output
    target = target_of(output, None, FORMATS, "json", request.json, has_format=False)
    with memory_wall(request.memory, "the path", request.obstacles, SIMPLER):
        operand, way = read_operand(request.obstacles), read_path(request.path)
        if output is not None:
            refuse_overwriting(output, [operand.file, *([way.file] if way.file else [])])
        found = refusing(operand.name, lambda: on_path(operand.set, way.points, question))
    value = radii_document(
        "path",
        watch,
        request,
        found,
        obstacles=operand.name,
        path=way.name,
        vertices=len(way.points),
        warnings=operand.warnings,
        output=None if output is None else str(output),
    )
    told = f"{way.name}, vertices {len(way.points):,}, contact {request.contact}"
    rows = [("part", f"{request.part} among {operand.name}"), ("path", told)]
    drawn = partial(disc_path_picture, operand, way.points, found, range_text(value))
    finish(value, target, request.json, drawn, printed=radii_shown(rows, "valid radii"))
