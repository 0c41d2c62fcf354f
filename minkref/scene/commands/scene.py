"""`minkref scene`: the union of the sums of a scene's copies with its robot."""

from __future__ import annotations

import json
import sys
import time
from collections import Counter
from typing import Any

from minkref import _core
from minkref.cli.memory import memory_wall
from minkref.cli.output import measure, print_lines, written_row
from minkref.cli.plot_option import check_plot, print_plot
from minkref.cli.progress import told_of
from minkref.errors import Refusal, refusing
from minkref.output.documents import Stopwatch, as_text, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.output.terminal import counted, escaped
from minkref.plane.commands.scale_index import cores
from minkref.plane.commands.sum_fields import set_fields
from minkref.plane.commands.sum_table import passage_rows
from minkref.plane.commands.written_set import FORMS, written_set
from minkref.plane.operand import Operand
from minkref.plane.parents import EdgeRow, parents
from minkref.scene.commands.questions import (
    answer_rows,
    answers,
    check_questions,
    free_components,
    free_rows,
    needs_passages,
    way_of,
)
from minkref.scene.scene_file import SceneFile, read_scene_file
from minkref.verbs.scene import SceneRequest

FEWER = "take fewer copies, or simpler shapes"
MOST_THREADS = 256
SHOWN = 5  # shapes that people see
OwnerRow = tuple[int, EdgeRow]


def run(request: SceneRequest) -> None:
    watch = Stopwatch()
    _check(request)
    check_questions(request)
    target = target_of(request.output, request.form, FORMS, "wkt", request.json)
    check_plot(request.plot, request.json, target)
    threads = request.threads or cores()
    with memory_wall(request.memory, "the scene", request.scene, FEWER):
        scene = read_scene_file(request.scene, request.copies)
        way = way_of(request)
        if request.output is not None:
            files = [*scene.files, *([way[1]] if way and way[1] else [])]
            refuse_overwriting(request.output, files)
        began = time.perf_counter()
        found = _found(scene, needs_passages(request), threads)
        region = found.region()
        seconds = time.perf_counter() - began
        answer = {
            **set_fields(region, found.components_of_set, found.holes),
            "owners": _owners(found) if request.owners else None,
            "passages": _passages(found) if request.passages else None,
            "free_components": free_components(found, request.contact),
            "asked": None if way is None else answers(scene, way[0], request.contact or "allowed"),
            "counts": dict(found.counts()),
        }
    is_exact = None
    if target is not None:
        text, is_exact = written_set(region, target)
        if target.write(text, is_exact):
            return
    value = document(
        "scene",
        watch,
        scene=scene.name,
        **parts_of(scene),
        threads=threads,
        warnings=scene.warnings,
        output=None if request.output is None else str(request.output),
        output_exact=is_exact,
        compute_seconds=seconds,
        **answer,
        result=json.loads(region.canonical_json()),
    )
    if request.json:
        sys.stdout.write(as_text(value))
        return
    _print(value)
    print_plot(request.plot, region)


def _check(request: SceneRequest) -> None:
    if request.owners and not request.json:
        raise Refusal("the owners are in the document only", "--owners", "add --json")
    if request.threads is not None and not 1 <= request.threads <= MOST_THREADS:
        what = f"this must be between 1 and {MOST_THREADS}"
        raise Refusal(what, f"--threads {request.threads}", "choose another number")


def _found(scene: SceneFile, passages: bool, threads: int) -> _core.SceneUnion:
    shapes = [operand.set for operand in scene.shapes.values()]
    with told_of("uniting the sums") as tell:
        return refusing(
            scene.name,
            lambda: _core.SceneUnion(
                scene.robot.set, shapes, scene.copies, passages, threads, 0, tell
            ),
        )


def parts_of(scene: SceneFile) -> dict[str, Any]:
    """The robot, the shapes and the number of copies, as documents tell them."""
    used = Counter(row.shape for row in scene.copies)

    def told(operand: Operand) -> dict[str, Any]:
        return {"name": operand.name, "vertices": operand.set.vertices}

    return {
        "robot": told(scene.robot),
        "shapes": [
            {**told(operand), "shape": name, "copies": used[number]}
            for number, (name, operand) in enumerate(scene.shapes.items())
        ],
        "copies": len(scene.copies),
    }


def _owners(found: _core.SceneUnion) -> list[list[list[dict[str, Any]]]]:
    return [[[_owner(row) for row in side] for side in ring] for ring in found.owners()]


def _passages(found: _core.SceneUnion) -> list[dict[str, Any]]:
    return [
        {
            "points": [list(point) for point in points],
            "owners": [[_owner(row) for row in side] for side in owners],
        }
        for points, owners in found.passages()
    ]


def _owner(row: OwnerRow) -> dict[str, Any]:
    copy, edge = row
    return {**parents(edge), "copy": copy}


def _print(value: dict[str, Any]) -> None:
    rows = [
        ("scene", value["scene"]),
        (
            "copies",
            f"{value['copies']:,} of {counted(len(value['shapes']), 'shape')}{_listed(value)}",
        ),
        ("area", measure(value["area"])),
        ("components, holes", f"{value['components']:,}, {value['holes']:,}"),
        ("vertices", f"{value['vertices']:,}"),
        ("digest", value["digest"]),
    ]
    if value["passages"] is not None:
        rows += passage_rows(value["passages"], "polyline")
    rows += free_rows(value["free_components"]) + answer_rows(value["asked"])
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    rows += written_row(value)
    print_lines(rows, value)


def _listed(value: dict[str, Any]) -> str:
    """The first shapes, with their copies."""
    shapes = [f"{one['copies']:,} {escaped(one['shape'])}" for one in value["shapes"]]
    more = ", ..." if len(shapes) > SHOWN else ""
    return f": {', '.join(shapes[:SHOWN])}{more}" if shapes else ""
