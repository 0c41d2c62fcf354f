"""`minkref view` of convex polyhedra: a page with a picture in space for each scale."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from minkref import _core
from minkref.commands.line.memory import SIMPLER, memory_wall
from minkref.commands.line.output import give, print_lines
from minkref.commands.line.progress import progress
from minkref.commands.pages.space.view_page import (
    KINDS,
    STEPS,
    Body,
    Frames,
    frame_row,
    frame_text,
    page,
    viewer,
    viewer_name,
)
from minkref.documents import Stopwatch, document
from minkref.errors import Refusal, refusing
from minkref.exact import approximate
from minkref.output_target import Target
from minkref.signals import ending_in_order
from minkref.space.operand import read_space_operand
from minkref.space.scaling import Scaling, read_scaling, read_scalings, text_of
from minkref.space.sums import bodies, timed
from minkref.terminal import counted, escaped


def view_in_space(
    P: str, Q: str, scale: str | None, scales: Path | None, given: list[str], target: Target,
    json: bool, memory: int | None = None,
) -> None:  # fmt: skip
    """The command, its options read but not yet checked. `given` are options of the plane."""
    watch = Stopwatch()
    scalings = _scalings(scale, scales, given)
    library = viewer()
    first, second = read_space_operand(P), read_space_operand(Q)
    operands = bodies(first, second)
    shapes = Body(first.name, operands[0]), Body(second.name, operands[1])
    frames = Frames(len(scalings))
    rows: list[dict[str, Any]] = []
    wall = memory_wall(memory, "the page", f"{P} and {Q}", SIMPLER)
    with wall, ending_in_order(), progress(len(scalings)) as line:
        where = f"{first.name} and {second.name}"
        moving = refusing(where, lambda: _core.DynamicConvexSum(*operands, scalings[0]))
        for scaling in scalings:
            line.now(f"scale {escaped(text_of(scaling))[:30]}")
            rows.append(_frame(moving, scaling, where, shapes, frames))
            line.done()
        count = target.write_pieces(page(*shapes, frames, library))
    if target.is_standard_output:
        return
    value = document(
        "view",
        watch,
        dimension=3,
        P=first.name,
        Q=second.name,
        warnings=first.warnings + second.warnings,
        output=str(target.path),
        bytes=count,
        viewer=viewer_name(),
        frames=rows,
    )
    give(value, json, _print)


def _frame(
    moving: _core.DynamicConvexSum, scaling: Scaling, where: str, shapes: tuple[Body, Body],
    frames: Frames,
) -> dict[str, Any]:  # fmt: skip
    """Adds a frame to the page; what the document says of it."""
    did = dict(refusing(where, lambda: moving.update(scaling)))
    answer = timed(where, moving.sum)
    row = frame_row(scaling, answer, did)
    frames.add(frame_text(row, answer, *shapes))
    return row


def _scalings(scale: str | None, scales: Path | None, given: list[str]) -> list[Scaling]:
    mend = "give --scale SX,SY,SZ, or --scales FILE with SX,SY,SZ (or S) in each line"
    if given:
        raise Refusal("these options are for windows of the plane", ", ".join(given), mend)
    if scale is not None and scales is not None:
        raise Refusal("the scales are given twice", "--scale and --scales", "leave out one of them")
    if scales is not None:
        return read_scalings(scales)
    return [read_scaling("1" if scale is None else scale)]


def _print(value: dict[str, Any]) -> None:
    frames = value["frames"]
    last = frames[-1]
    kinds = ", ".join(f"{last['kinds'][kind]:,} {kind}" for kind in KINDS if last["kinds"][kind])
    steps = {name: sum(frame[name] for frame in frames) for name in STEPS}
    rows = [
        ("S P + Q", f"{value['P']} + {value['Q']}"),
        ("frames", counted(len(frames), "scale")),
        ("last frame", text_of(tuple(last["scale"]))),
        ("vertices, edges", f"{last['vertices']:,}, {last['edges']:,}"),
        ("facets", f"{last['facets']:,}: {kinds}"),
        ("volume", f"{approximate(last['volume']):.10g}"),
        ("updates", ", ".join(f"{count:,} {_words(name)}" for name, count in steps.items())),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {value['bytes']:,} bytes"),
    ]
    if len(frames) == 1:
        rows = [row for row in rows if row[0] != "updates"]
    print_lines(rows, value)


def _words(name: str) -> str:
    """fv_errors: fv-errors; descent_steps: descent steps."""
    return name.replace("_errors", "-errors").replace("_", " ")
