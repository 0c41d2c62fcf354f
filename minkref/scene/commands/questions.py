"""Free places in `minkref scene`: components, a place, a way."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import Refusal, choice, refusing
from minkref.motion.commands.path_rows import feature_text, number_text, point_text
from minkref.motion.path_text import read_path
from minkref.scene.free_values import CONTACTS
from minkref.scene.scene_file import SceneFile
from minkref.verbs.scene import SceneRequest

SHOWN = 8  # copies that people see
Points = Sequence[tuple[str, str]]


def check_questions(request: SceneRequest) -> None:
    """Refuse unknown rules, and two questions at once."""
    if request.contact is not None and request.contact not in CONTACTS:
        mend = choice(request.contact, CONTACTS)
        raise Refusal("there is no rule of this name", f"--contact {request.contact}", mend)
    if request.at is not None and request.way is not None:
        raise Refusal("one question is asked at a time", "--at, --way", "leave out one of the two")


def needs_passages(request: SceneRequest) -> bool:
    """Whether free components are counted that hang together along tight passages."""
    return request.passages or request.contact == "allowed"


def way_of(request: SceneRequest) -> tuple[Points, Path | None] | None:
    """The vertices to ask about (one for a place), and the way's file."""
    if request.at is not None:
        return [request.at], None
    if request.way is None:
        return None
    way = read_path(request.way)
    return way.points, way.file


def free_components(found: _core.SceneUnion, contact: str | None) -> dict[str, Any] | None:
    """The free components by the rule, as documents tell them."""
    if contact is None:
        return None
    count, cells = found.free_components(contact)
    return {
        "contact": contact,
        "count": count,
        "cells": [
            {
                "component": component,
                "outer": [list(point) for point in outer] or None,
                "holes": [[list(point) for point in hole] for hole in holes],
            }
            for component, outer, holes in cells
        ],
    }


def answers(scene: SceneFile, points: Points, contact: str) -> dict[str, Any]:
    """Answers about a place or a way, as documents tell them."""
    shapes = [operand.set for operand in scene.shapes.values()]
    asked = refusing(
        scene.name, lambda: _core.SceneQuestions(scene.robot.set, shapes, scene.copies)
    )
    path = list(points)
    free, stopped_by = refusing(scene.name, lambda: asked.way(path, contact))
    holders = asked.holders(*path[0]) if len(path) == 1 else None
    growth = asked.growth(path, contact) if free else None
    return {
        "points": [list(point) for point in points],
        "contact": contact,
        "free": free,
        "stopped_by": stopped_by,
        "holders": None
        if holders is None
        else [{"copy": copy, "contact": each} for copy, each in holders],
        "growth": None if growth is None else _growth(growth),
    }


def _growth(row: tuple[Any, ...]) -> dict[str, Any]:
    factor, included, stop, seam = row
    if seam is not None:
        names = ("copies", "segment", "t", "at", "touching")
        told = dict(zip(names, map(_listed, seam), strict=True))
        return {"factor": factor, "included": included, "stop": None, "seam": told}
    if stop is None:
        return {"factor": None, "included": included, "stop": None, "seam": None}
    copy, segment, t, at, robot, shape, touching = stop
    return {
        "factor": factor,
        "included": included,
        "stop": {
            "copy": copy,
            "segment": segment,
            "t": t,
            "at": list(at),
            "robot": _feature(robot),
            "shape": _feature(shape),
            "touching": list(touching),
        },
        "seam": None,
    }


def _listed(value: Any) -> Any:
    return list(value) if isinstance(value, tuple) else value


def _feature(row: tuple[bool, int, int]) -> dict[str, list[int]]:
    is_edge, ring, index = row
    return {"edge" if is_edge else "vertex": [ring, index]}


def free_rows(found: dict[str, Any] | None) -> list[tuple[str, str]]:
    """A row for people; none if nothing was asked."""
    if found is None:
        return []
    return [("free components", f"{found['count']:,}, contact {found['contact']}")]


def answer_rows(found: dict[str, Any] | None) -> list[tuple[str, str]]:
    """Rows for people; none if nothing was asked."""
    if found is None:
        return []
    is_place = len(found["points"]) == 1
    about = point_text(found["points"][0]) if is_place else f"{len(found['points']):,} vertices"
    rows = [
        ("place" if is_place else "way", f"{about}, contact {found['contact']}"),
        ("free", _free(found)),
    ]
    if found["holders"]:
        told = [f"{one['copy']} {one['contact']}" for one in found["holders"][:SHOWN]]
        more = ", ..." if len(found["holders"]) > SHOWN else ""
        rows.append(("copies there", ", ".join(told) + more))
    growth = found["growth"]
    if growth is not None:
        rows.append(("all may grow", _growth_text(growth)))
    return rows


def _free(found: dict[str, Any]) -> str:
    if found["free"]:
        return "yes"
    copies = found["stopped_by"]
    if not copies:
        return "no: a seam between copies"
    more = ", ..." if len(copies) > SHOWN else ""
    who = "copy" if len(copies) == 1 else "copies"
    return f"no: {who} {', '.join(map(str, copies[:SHOWN]))}{more}"


def _growth_text(growth: dict[str, Any]) -> str:
    stop, seam = growth["stop"], growth["seam"]
    below = "by" if growth["included"] else "by less than"
    if seam is not None:
        copies = ", ".join(map(str, seam["copies"][:SHOWN]))
        return (
            f"{below} {number_text(growth['factor'])}: then a seam of copies {copies} closes at "
            f"{point_text(seam['touching'])}"
        )
    if stop is None:
        return "without bound"
    return (
        f"{below} {number_text(growth['factor'])}: then {feature_text(stop['shape'])} of copy "
        f"{stop['copy']} and {feature_text(stop['robot'])} of the robot touch at "
        f"{point_text(stop['touching'])}"
    )
