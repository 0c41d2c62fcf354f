"""`minkref path` and `minkref fit` of polyhedra."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.errors import Refusal, refusing
from minkref.exact import read_space_point
from minkref.motion.commands.path_rows import (
    BY_TRANSLATION,
    extreme_scales,
    proof_documents,
    range_documents,
    space_contact_document,
)
from minkref.motion.path_text import read_space_path
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.space.operand import read_summand


def path_in_space(
    watch: Stopwatch,
    robot: str,
    obstacles: str,
    path: str,
    contact: str,
    window: Sequence[str | None],
    route: str,
    output: Path | None,
    memory: int | None,
) -> dict[str, Any]:
    """The document of the command, its options read."""
    if route == "index":
        what = "this route is of paths in the plane"
        raise Refusal(what, "--route index", "choose pieces or contacts", "no-route")
    first, second, way = read_summand(robot), read_summand(obstacles), read_space_path(path)
    if output is not None:
        files = [first.file, second.file, *([way.file] if way.file else [])]
        refuse_overwriting(output, files)
    with memory_wall(memory, "the path", f"{robot} and {obstacles}", SMALLER):
        ranges, bounds, statistics = refusing(
            f"{robot}, {obstacles}",
            lambda: _core.valid_scales_in_space(
                first.surface, second.surface, way.points, contact, window[0], window[1], route
            ),
        )
    return document(
        "path",
        watch,
        dimension=3,
        robot=first.name,
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


def fit_in_space(
    watch: Stopwatch, part: str, container: str, at: str | None, contact: str, memory: int | None
) -> dict[str, Any]:
    """The document of a fit at a place. Refuses the other questions."""
    if at is None:
        what = "in space a fit is found at one place"
        raise Refusal(what, "minkref fit", "give --at X,Y,Z", "not-in-space")
    place = read_space_point(at, "--at")
    first, second = read_summand(part), read_summand(container)
    with memory_wall(memory, "the fit", f"{part} and {container}", SMALLER):
        (ranges, bounds, _), proofs = refusing(
            f"{part}, {container}",
            lambda: _core.fit_at_in_space(first.surface, second.surface, place, contact),
        )
    return document(
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


def _fit_bound(row: Any) -> dict[str, Any]:
    told = space_contact_document(row)
    return {
        "scale": told["scale"],
        "ends": told["event"] == "blocks",
        "event": "contact",
        "at": told["touching"],
        "contact": {key: told[key] for key in ("part", "obstacle")},
    }
