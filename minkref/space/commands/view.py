"""`minkref view` of polyhedra: a page with a picture in space for each scale."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, print_lines
from minkref.cli.progress import progress
from minkref.errors import Refusal, refusing
from minkref.exact import rounded
from minkref.output.documents import Stopwatch, document
from minkref.output.signals import ending_in_order
from minkref.output.terminal import counted, escaped
from minkref.plane.commands.scale_index import cores
from minkref.space.general_sum import GENERAL_ROUTES, general_sum
from minkref.space.operand import SpaceOperand, read_summand, refuse_thin
from minkref.space.page.event_axis import events_text, frames_of
from minkref.space.page.general_frames import general_row, general_text
from minkref.space.page.view_page import (
    STEPS,
    Body,
    Frames,
    frame_row,
    frame_text,
    page,
    viewer,
    viewer_name,
)
from minkref.space.scaling import UNIT, Scaling, read_scalings, text_of
from minkref.space.sums import timed
from minkref.verbs.view import ViewInSpace, page_target

Maker = Callable[[Scaling], tuple[dict[str, Any], str]]


def run(request: ViewInSpace) -> None:
    watch = Stopwatch()
    P, Q, target = request.P, request.Q, page_target(request.output, request.json)
    window = _window(request.from_scale, request.to_scale)
    scalings = _scalings(request, window)
    library = viewer()
    first, second = read_summand(P), read_summand(Q)
    for operand in (first, second):
        refuse_thin(operand)
    shapes = Body(first), Body(second)
    frames = Frames(len(scalings))
    rows: list[dict[str, Any]] = []
    wall = memory_wall(request.memory, "the page", f"{P} and {Q}", SIMPLER)
    with wall, ending_in_order(), progress(len(scalings)) as line:
        make = _maker(first, second, scalings[0], shapes)
        for scaling in scalings:
            line.now(f"scale {escaped(text_of(scaling))[:30]}")
            row, text = make(scaling)
            frames.add(text)
            rows.append(row)
            line.done()
        axis, counts = "null", None
        if window is not None:
            line.now("finding all events")
            axis, counts = events_text(first, second, window, scalings, cores())
        count = target.write_pieces(page(*shapes, frames, library, axis))
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
        events=counts,
    )
    give(value, request.json, _print)


def _maker(P: SpaceOperand, Q: SpaceOperand, first: Scaling, shapes: tuple[Body, Body]) -> Maker:
    """The maker of frames: the frame's row in the document, and its text in the page. Each convex
    sum is got from the sum before."""
    where = f"{P.name} and {Q.name}"
    if P.body is None or Q.body is None:

        def scratch(scaling: Scaling) -> tuple[dict[str, Any], str]:
            answer = general_sum(P, Q, scaling, GENERAL_ROUTES[0], cores())
            row = general_row(answer)
            return row, general_text(row, answer, *shapes)

        return scratch
    operands = P.body, Q.body
    moving = refusing(where, lambda: _core.DynamicConvexSum(*operands, first))

    def update(scaling: Scaling) -> tuple[dict[str, Any], str]:
        did = dict(refusing(where, lambda: moving.update(scaling)))
        answer = timed(where, moving.sum)
        row = frame_row(scaling, answer, did)
        return row, frame_text(row, answer, *shapes)

    return update


def _window(first: Fraction | None, last: Fraction | None) -> tuple[str, str] | None:
    """The window of events."""
    if first is None and last is None:
        return None
    if first is None or last is None:
        missing = "--from" if first is None else "--to"
        raise Refusal("events are found in a window", missing, "give both --from and --to")
    if first >= last:
        where = f"--from {first} --to {last}"
        raise Refusal("the window is empty", where, "give the smaller first")
    return str(first), str(last)


def _scalings(request: ViewInSpace, window: tuple[str, str] | None) -> list[Scaling]:
    if request.scale is not None and request.scales is not None:
        raise Refusal("the scales are given twice", "--scale and --scales", "leave out one of them")
    if request.scales is not None:
        return read_scalings(request.scales)
    if request.scale is not None:
        return [request.scale]
    return frames_of(window) if window is not None else [UNIT]


def _print(value: dict[str, Any]) -> None:
    frames = value["frames"]
    last = frames[-1]
    kinds = ", ".join(
        f"{last['kinds'][kind]:,} {kind}" for kind in last["kinds"] if last["kinds"][kind]
    )
    steps = {name: sum(frame[name] or 0 for frame in frames) for name in STEPS}
    rows = [
        ("S P + Q", f"{value['P']} + {value['Q']}"),
        ("frames", counted(len(frames), "scale")),
        ("last frame", text_of(tuple(last["scale"]))),
        ("vertices, edges", f"{last['vertices']:,}, {last['edges']:,}"),
        ("facets", f"{last['facets']:,}: {kinds}"),
        ("volume", rounded(last["volume"], 10)),
        ("updates", ", ".join(f"{count:,} {_words(name)}" for name, count in steps.items())),
        *_events_row(value["events"]),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {value['bytes']:,} bytes"),
    ]
    if len(frames) == 1 or last[STEPS[0]] is None:
        rows = [row for row in rows if row[0] != "updates"]
    print_lines(rows, value)


def _words(name: str) -> str:
    """fv_errors: fv-errors; descent_steps: descent steps."""
    return name.replace("_errors", "-errors").replace("_", " ")


def _events_row(counts: dict[str, int] | None) -> list[tuple[str, str]]:
    if counts is None:
        return []
    told = ", ".join(f"{count:,} {kind}" for kind, count in counts.items() if count)
    return [("events", told or "none")]
