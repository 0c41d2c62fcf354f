"""`minkref fit disc CONTAINER`: the radii of discs in a container."""

from __future__ import annotations

from functools import partial

from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import refusing
from minkref.motion.commands.disc_picture import disc_room_picture
from minkref.motion.commands.disc_rows import question_of, radii_document, radii_shown, range_text
from minkref.motion.commands.fit import question_named
from minkref.motion.commands.path_answer import FORMATS, finish
from minkref.motion.commands.path_rows import point_text
from minkref.motion.disc_radii import DiscRadii, anywhere, at_place, between
from minkref.output.documents import Stopwatch, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import read_operand
from minkref.verbs.fit import FitOfDisc


def run(request: FitOfDisc) -> None:
    watch = Stopwatch()
    question = question_of(request, request.container)
    asked, places = question_named(request)
    target = target_of(request.output, None, FORMATS, "json", request.json, has_format=False)

    def answer() -> DiscRadii:
        container, name = operand.set, operand.name
        if asked == "at":
            return at_place(container, places[0], name, question)
        if asked == "anywhere":
            return anywhere(container, name, question, cores())
        return between(container, places, name, question, cores())

    with memory_wall(request.memory, "the fit", request.container, SIMPLER):
        operand = read_operand(request.container)
        if request.output is not None:
            refuse_overwriting(request.output, [operand.file])
        found = refusing(operand.name, answer)
    value = radii_document(
        "fit",
        watch,
        request,
        found,
        container=operand.name,
        question=asked,
        places=[list(place) for place in places],
        warnings=operand.warnings,
        output=None if request.output is None else str(request.output),
    )
    where = f"{asked} {' and '.join(map(point_text, places))}".rstrip()
    part = f"{request.part} in {operand.name}, contact {request.contact}"
    shown = radii_shown([("part", part), ("where", where)], "fits")
    drawn = partial(disc_room_picture, operand, places, found, range_text(value), "fits")
    finish(value, target, request.json, drawn, printed=shown)
