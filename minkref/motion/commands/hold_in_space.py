"""`minkref hold` of polyhedra."""

from __future__ import annotations

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.errors import refusing
from minkref.exact import text_of_bounds
from minkref.motion.commands.hold_answer import MOTION, held_fields, print_held, way_fields
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_in_space import json_target, refuse_other_words
from minkref.motion.commands.path_rows import space_contact_document
from minkref.motion.path_text import read_space_path
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.space.operand import read_summand
from minkref.verbs.hold import HoldInSpace


def run(request: HoldInSpace) -> None:
    watch = Stopwatch()
    output, contact, route = request.output, request.contact, request.route
    window = text_of_bounds(request.from_scale, request.to_scale)
    refuse_other_words(contact, route)
    target = json_target(output, request.json)
    first, second = read_summand(request.part), read_summand(request.obstacles)
    way = read_space_path(request.way)
    if output is not None:
        refuse_overwriting(output, [first.file, second.file, *([way.file] if way.file else [])])
    with memory_wall(request.memory, "the way", f"{request.part} and {request.obstacles}", SMALLER):
        rows = refusing(
            f"{request.part}, {request.obstacles}",
            lambda: _core.held_scales_in_space(
                first.surface, second.surface, way.points, contact, window[0], window[1], route
            ),
        )
    value = document(
        "hold",
        watch,
        dimension=3,
        part=first.name,
        obstacles=second.name,
        **way_fields(way.name, way.points),
        contact=contact,
        route=route,
        **{"from": window[0], "to": window[1]},
        motion=MOTION,
        **held_fields(rows, space_contact_document),
        star_shaped=_core.star_shaped_in_space(first.surface),
        warnings=first.warnings + second.warnings,
        output=None if output is None else str(output),
    )
    finish(value, target, request.json, printed=print_held)
