"""The input of `minkref path` and `minkref hold`, in the plane and in space: a part, obstacles
and a polyline, read once for both."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.errors import Refusal
from minkref.exact import text_of_bounds
from minkref.motion.path_text import read_path, read_space_path
from minkref.motion.scale_ranges import CONTACTS, PATH_ROUTES
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.plane.operand import read_operand
from minkref.space.operand import read_summand
from minkref.verbs.path import PathInPlane, PathInSpace, check_words


@dataclass(frozen=True)
class PathInput:
    """A request as read. `part`, `obstacles`: sets, or surfaces in space; `files`: of all
    operands."""

    request: PathInPlane | PathInSpace
    watch: Stopwatch
    names: tuple[str, str]
    part: Any
    obstacles: Any
    way: Any
    window: tuple[str | None, str | None]
    target: Target | None
    files: list[Path]
    warnings: list[str]

    @property
    def where(self) -> str:
        return f"{self.request.part}, {self.request.obstacles}"

    def memory_wall(self, what: str) -> AbstractContextManager[None]:
        operands = f"{self.request.part} and {self.request.obstacles}"
        return memory_wall(self.request.memory, what, operands, SMALLER)

    def scales(self, ask: Callable[..., Any]) -> Any:
        """The answer of a function that takes the whole question."""
        request, points = self.request, self.way.points
        return ask(self.part, self.obstacles, points, request.contact, *self.window, request.route)

    def document(self, name: str, motion: str, answer: dict[str, Any]) -> dict[str, Any]:
        request, in_space = self.request, isinstance(self.request, PathInSpace)
        star_shaped = _core.star_shaped_in_space if in_space else _core.star_shaped
        return document(
            name,
            self.watch,
            **({"dimension": 3} if in_space else {}),
            part=self.names[0],
            obstacles=self.names[1],
            path=self.way.name,
            vertices=len(self.way.points),
            contact=request.contact,
            route=request.route,
            **{"from": self.window[0], "to": self.window[1]},
            motion=motion,
            **answer,
            star_shaped=star_shaped(self.part),
            warnings=self.warnings,
            output=None if request.output is None else str(request.output),
        )


def input_in_plane(request: PathInPlane) -> PathInput:
    watch = Stopwatch()
    check_words(contact=(request.contact, CONTACTS), route=(request.route, PATH_ROUTES))
    forms = ("json", "svg")
    target = target_of(request.output, None, forms, forms[0], request.json, has_format=False)
    operands = read_operand(request.part), read_operand(request.obstacles)
    bodies = operands[0].set, operands[1].set
    return _input(request, watch, operands, bodies, read_path(request.path), target)


def input_in_space(request: PathInSpace) -> PathInput:
    """Refuses the route and the pictures that are of the plane alone."""
    watch = Stopwatch()
    if request.route == PATH_ROUTES[2]:
        what = "this route is of paths in the plane"
        raise Refusal(what, "--route index", "choose pieces or contacts", "no-route")
    check_words(contact=(request.contact, CONTACTS), route=(request.route, PATH_ROUTES[:2]))
    target = _json_target(request.output, request.json)
    operands = read_summand(request.part), read_summand(request.obstacles)
    bodies = operands[0].surface, operands[1].surface
    return _input(request, watch, operands, bodies, read_space_path(request.path), target)


def _input(
    request: PathInPlane | PathInSpace,
    watch: Stopwatch,
    operands: tuple[Any, Any],
    bodies: tuple[Any, Any],
    way: Any,
    target: Target | None,
) -> PathInput:
    first, second = operands
    files = [first.file, second.file, *([way.file] if way.file else [])]
    if request.output is not None:
        refuse_overwriting(request.output, files)
    lowest, highest = text_of_bounds(request.from_scale, request.to_scale)
    return PathInput(
        request,
        watch,
        (first.name, second.name),
        *bodies,
        way,
        (lowest, highest),
        target,
        files,
        first.warnings + second.warnings,
    )


def _json_target(output: Path | None, json: bool) -> Target | None:
    """The file of -o. Refuses a picture."""
    if output is not None and output.suffix.lower() == ".svg":
        raise Refusal("no picture is drawn in space", str(output), "name a .json file")
    return target_of(output, None, ("json",), "json", json)
