"""`minkref path` in the plane: the scales at which a part passes along a path."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.errors import refusing
from minkref.exact import text_of_bounds
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_proof import proof_document, proof_files, proved
from minkref.motion.commands.path_rows import contact_document, extreme_scales, range_documents
from minkref.motion.path_text import read_path
from minkref.motion.scale_ranges import CONTACTS, PATH_ROUTES, range_values
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.operand import read_operand
from minkref.verbs.path import PathInPlane, check_words

FORMS = ("json", "svg")  # that -o writes


def run(request: PathInPlane) -> None:
    watch = Stopwatch()
    output, contact, route = request.output, request.contact, request.route
    window = text_of_bounds(request.from_scale, request.to_scale)
    check_words(contact=(contact, CONTACTS), route=(route, PATH_ROUTES))
    target = target_of(output, None, FORMS, FORMS[0], request.json, has_format=False)
    first, second = read_operand(request.part), read_operand(request.obstacles)
    way = read_path(request.path)
    files = [first.file, second.file, *([way.file] if way.file else [])]
    if output is not None:
        refuse_overwriting(output, files)
    proof = proof_files(request.certify, files, output)
    where = f"{request.part}, {request.obstacles}"
    with memory_wall(
        request.memory, "the path", f"{request.part} and {request.obstacles}", SMALLER
    ):
        ranges, bounds, statistics = refusing(
            where,
            lambda: _core.valid_scales(
                first.set, second.set, way.points, contact, window[0], window[1], route
            ),
        )
        proven = proved(
            proof,
            (first.name, second.name),
            (first.set, second.set),
            way.points,
            lambda made: made.valid(contact, window[0], window[1], range_values(ranges)),
        )
    value = document(
        "path",
        watch,
        part=first.name,
        obstacles=second.name,
        path=way.name,
        vertices=len(way.points),
        is_closed=len(way.points) > 1 and way.points[0] == way.points[-1],
        contact=contact,
        route=route,
        **{"from": window[0], "to": window[1]},
        motion="translations only, along the path",
        valid=range_documents(ranges),
        **extreme_scales(ranges),
        star_shaped=_core.star_shaped(first.set),
        bounds=[contact_document(row) for row in bounds],
        statistics=dict(statistics),
        warnings=first.warnings + second.warnings,
        output=None if output is None else str(output),
        certificate=proof_document(proven),
    )
    asked = (first.set, second.set, way.points, contact)
    drawn = partial(_drawn, where, asked, ranges, bounds, window)
    finish(value, target, request.json, drawn, [] if proven is None else [proven[0]])


def _drawn(
    where: str, asked: tuple[Any, ...], ranges: Any, bounds: Any, window: Sequence[str | None]
) -> str:
    """The diagram of places and scales that collide. `asked`: all that PathQuestion takes."""
    from minkref.motion.page.diagram_svg import diagram_svg
    from minkref.motion.page.picture import PathQuestion, picture, window_around

    question = PathQuestion(*asked)
    shown = window_around(bounds, window[0], window[1])
    data = refusing(where, lambda: picture(question, ranges, bounds, shown))
    return diagram_svg(data)
