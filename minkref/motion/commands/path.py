"""`minkref path`: the scales at which a part passes along a path, in the plane and in space."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from minkref import _core
from minkref.errors import refusing
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_input import PathInput, input_in_plane, input_in_space
from minkref.motion.commands.path_proof import proved
from minkref.motion.commands.path_rows import (
    contact_document,
    extreme_scales,
    range_documents,
    space_contact_document,
)
from minkref.motion.scale_ranges import range_values
from minkref.verbs.path import PathInPlane, PathInSpace
from minkref.verbs.proof_option import proof_document, proof_files

MOTION = "translations only, along the path"


def run(request: PathInPlane) -> None:
    if request.clearance is not None:
        from minkref.motion.commands.clear import run_path

        run_path(request)
        return
    asked = input_in_plane(request)
    proof = proof_files(request.certify, asked.files, request.output)
    with asked.memory_wall("the path"):
        rows = refusing(asked.where, lambda: asked.scales(_core.valid_scales))
        proven = proved(
            proof,
            asked.names,
            (asked.part, asked.obstacles),
            asked.way.points,
            lambda made: made.valid(request.contact, *asked.window, range_values(rows[0])),
        )
    answer = {**_answer(asked, rows, contact_document), "certificate": proof_document(proven)}
    value = asked.document("path", MOTION, answer)
    drawn = partial(_drawn, asked, rows[0], rows[1])
    finish(value, asked.target, request.json, drawn, [] if proven is None else [proven[0]])


def run_in_space(request: PathInSpace) -> None:
    asked = input_in_space(request)
    with asked.memory_wall("the path"):
        rows = refusing(asked.where, lambda: asked.scales(_core.valid_scales_in_space))
    value = asked.document("path", MOTION, _answer(asked, rows, space_contact_document))
    finish(value, asked.target, request.json)


def _answer(asked: PathInput, rows: Any, told: Callable[[Any], dict[str, Any]]) -> dict[str, Any]:
    ranges, bounds, statistics = rows
    points = asked.way.points
    return {
        "is_closed": len(points) > 1 and points[0] == points[-1],
        "valid": range_documents(ranges),
        **extreme_scales(ranges),
        "bounds": [told(row) for row in bounds],
        "statistics": dict(statistics),
    }


def _drawn(asked: PathInput, ranges: Any, bounds: Any) -> str:
    """The diagram of places and scales that collide."""
    from minkref.motion.page.diagram_svg import diagram_svg
    from minkref.motion.page.picture import PathQuestion, picture, window_around

    question = PathQuestion(asked.part, asked.obstacles, asked.way.points, asked.request.contact)
    shown = window_around(bounds, *asked.window)
    data = refusing(asked.where, lambda: picture(question, ranges, bounds, shown))
    return diagram_svg(data)
