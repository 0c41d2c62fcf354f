"""`minkref view SCENE`: a page to drag and scale copies."""

from __future__ import annotations

from typing import Any

from minkref.cli.memory import memory_wall
from minkref.cli.output import give, print_lines
from minkref.errors import refusing
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.terminal import counted
from minkref.plane.commands.scale_index import cores
from minkref.plane.commands.view import ring_progress
from minkref.plane.operand import Operand
from minkref.scene.commands.scene import FEWER, parts_of
from minkref.scene.page.picture import picture
from minkref.scene.page.write_page import page
from minkref.scene.scene_file import read_scene_file
from minkref.verbs.view import ViewOfScene, page_target


def run(request: ViewOfScene) -> None:
    watch = Stopwatch()
    target = page_target(request.output, request.json)
    with memory_wall(request.memory, "the page", request.P, FEWER):
        scene = read_scene_file(request.P, request.copies)
        if not target.is_standard_output:
            refuse_overwriting(target.path, scene.files)
        sets = {name: operand.set for name, operand in scene.shapes.items()}
        with ring_progress() as progress:
            data = refusing(
                scene.name, lambda: picture(scene.robot.set, sets, scene.copies, cores(), progress)
            )
        count = target.write_pieces([page(scene.name, _robot(scene.robot), data)])
    if target.is_standard_output:
        return
    value = document(
        "view",
        watch,
        scene=scene.name,
        **parts_of(scene),
        sums=len(data["sums"]),
        tracks=sum(len(each["tracks"]) for each in data["sums"]) // 4,
        boundary_events=sum(len(each["about"]) for each in data["sums"]),
        warnings=scene.warnings,
        output=str(target.path),
        bytes=count,
    )
    give(value, request.json, _print)


def _robot(robot: Operand) -> str:
    """Name the robot; sets within the scene's file have no name of their own."""
    return robot.name if robot.source != robot.name else "robot"


def _print(value: dict[str, Any]) -> None:
    events, sums = value["boundary_events"], counted(value["sums"], "sum")
    rows = [
        ("scene", value["scene"]),
        ("copies", f"{value['copies']:,} of {counted(len(value['shapes']), 'shape')}"),
        ("kept", f"{sums} at all scales, {counted(events, 'boundary event')}"),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {value['bytes']:,} bytes"),
    ]
    print_lines(rows, value)
