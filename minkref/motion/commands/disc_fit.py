"""`minkref fit disc CONTAINER`: the radii of discs in a container."""

from __future__ import annotations

from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import refusing
from minkref.motion.commands.disc_rows import give_radii, question_of, radii_document
from minkref.motion.commands.fit import question_named
from minkref.motion.commands.path_rows import point_text
from minkref.motion.disc_radii import DiscRadii, anywhere, at_place, between
from minkref.output.documents import Stopwatch
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import read_operand
from minkref.verbs.fit import FitOfDisc


def run(request: FitOfDisc) -> None:
    watch = Stopwatch()
    question = question_of(request, request.container)
    asked, places = question_named(request)

    def answer() -> DiscRadii:
        container, name = operand.set, operand.name
        if asked == "at":
            return at_place(container, places[0], name, question)
        if asked == "anywhere":
            return anywhere(container, name, question, cores())
        return between(container, places, name, question, cores())

    with memory_wall(request.memory, "the fit", request.container, SIMPLER):
        operand = read_operand(request.container)
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
    )
    where = f"{asked} {' and '.join(map(point_text, places))}".rstrip()
    part = f"{request.part} in {operand.name}, contact {request.contact}"
    give_radii(value, request.json, [("part", part), ("where", where)], "fits")
