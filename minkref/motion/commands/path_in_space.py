"""`minkref path` and `minkref fit` of polyhedra."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import give
from minkref.errors import Refusal, refusing
from minkref.exact import text_of_bounds
from minkref.motion.commands.fit import print_fit
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_rows import (
    BY_TRANSLATION,
    extreme_scales,
    proof_documents,
    range_documents,
    space_contact_document,
)
from minkref.motion.path_text import read_space_path
from minkref.motion.scale_ranges import CONTACTS, PATH_ROUTES
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.space.operand import read_summand
from minkref.verbs.fit import PLACE, FitInSpace
from minkref.verbs.path import PathInSpace, check_words


def run(request: PathInSpace) -> None:
    watch = Stopwatch()
    part, obstacles, output = request.part, request.obstacles, request.output
    path, contact, route = request.path, request.contact, request.route
    window = text_of_bounds(request.from_scale, request.to_scale)
    if route == PATH_ROUTES[2]:
        what = "this route is of paths in the plane"
        raise Refusal(what, "--route index", "choose pieces or contacts", "no-route")
    check_words(contact=(contact, CONTACTS), route=(route, PATH_ROUTES[:2]))
    if output is not None and output.suffix.lower() == ".svg":
        raise Refusal("no picture is drawn in space", str(output), "name a .json file")
    target = target_of(output, None, ("json",), "json", request.json)
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


def run_fit(request: FitInSpace) -> None:
    """The fit at a place."""
    watch = Stopwatch()
    part, container, contact, place = (
        request.part, request.container, request.contact, request.at,
    )  # fmt: skip
    check_words(contact=(contact, CONTACTS))
    if place is None:
        raise Refusal("in space a fit is found at one place", "minkref fit", PLACE)
    first, second = read_summand(part), read_summand(container)
    with memory_wall(request.memory, "the fit", f"{part} and {container}", SMALLER):
        (ranges, bounds, _), proofs = refusing(
            f"{part}, {container}",
            lambda: _core.fit_at_in_space(first.surface, second.surface, place, contact),
        )
    value = document(
        "fit",
        watch,
        dimension=3,
        part=first.name,
        container=second.name,
        question="at",
        places=[list(place)],
        contact=contact,
        warnings=first.warnings + second.warnings,
        motion=BY_TRANSLATION,
        scales=range_documents(ranges),
        **extreme_scales(ranges),
        bounds=[_fit_bound(row) for row in bounds],
        proofs=proof_documents(proofs),
    )
    give(value, request.json, print_fit)


def _fit_bound(row: Any) -> dict[str, Any]:
    told = space_contact_document(row)
    return {
        "scale": told["scale"],
        "ends": told["event"] == "blocks",
        "event": "contact",
        "at": told["touching"],
        "contact": {key: told[key] for key in ("part", "obstacle")},
    }
