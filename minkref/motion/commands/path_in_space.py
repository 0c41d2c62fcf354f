"""`minkref path` of polyhedra."""

from __future__ import annotations

from pathlib import Path

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.errors import Refusal, refusing
from minkref.exact import text_of_bounds
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_rows import (
    extreme_scales,
    range_documents,
    space_contact_document,
)
from minkref.motion.path_text import read_space_path
from minkref.motion.scale_ranges import CONTACTS, PATH_ROUTES
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.space.operand import read_summand
from minkref.verbs.path import PathInSpace, check_words


def run(request: PathInSpace) -> None:
    watch = Stopwatch()
    part, obstacles, output = request.part, request.obstacles, request.output
    path, contact, route = request.path, request.contact, request.route
    window = text_of_bounds(request.from_scale, request.to_scale)
    refuse_other_words(contact, route)
    target = json_target(output, request.json)
    first, second, way = read_summand(part), read_summand(obstacles), read_space_path(path)
    if output is not None:
        files = [first.file, second.file, *([way.file] if way.file else [])]
        refuse_overwriting(output, files)
    with memory_wall(request.memory, "the path", f"{part} and {obstacles}", SMALLER):
        ranges, bounds, statistics = refusing(
            f"{part}, {obstacles}",
            lambda: _core.valid_scales_in_space(
                first.surface, second.surface, way.points, contact, window[0], window[1], route
            ),
        )
    value = document(
        "path",
        watch,
        dimension=3,
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
        star_shaped=_core.star_shaped_in_space(first.surface),
        bounds=[space_contact_document(row) for row in bounds],
        statistics=dict(statistics),
        warnings=first.warnings + second.warnings,
        output=None if output is None else str(output),
    )
    finish(value, target, request.json)


def refuse_other_words(contact: str, route: str) -> None:
    """Refuses words that `path` and `hold` do not know in space."""
    if route == PATH_ROUTES[2]:
        what = "this route is of paths in the plane"
        raise Refusal(what, "--route index", "choose pieces or contacts", "no-route")
    check_words(contact=(contact, CONTACTS), route=(route, PATH_ROUTES[:2]))


def json_target(output: Path | None, json: bool) -> Target | None:
    """The file of -o. Refuses a picture."""
    if output is not None and output.suffix.lower() == ".svg":
        raise Refusal("no picture is drawn in space", str(output), "name a .json file")
    return target_of(output, None, ("json",), "json", json)
