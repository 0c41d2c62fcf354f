"""`minkref index P Q` in the plane: the sums at all scales of a window, built once."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import give, print_lines
from minkref.cli.progress import progress
from minkref.errors import Refusal, refusing
from minkref.exact import text_of_bounds
from minkref.output.documents import (
    Stopwatch,
    check_writable,
    document,
    refuse_overwriting,
    replacing,
)
from minkref.output.output_target import refuse_stream
from minkref.output.terminal import counted
from minkref.plane.commands.scale_index import build_index, cores
from minkref.plane.eroded import eroding_pair
from minkref.plane.operand import Operand, read_operand
from minkref.verbs.index import IndexInPlane

MOST_THREADS = 256
OTHER_FORMATS = {*_core.SET_FORMATS, *_core.MESH_FORMATS, "csv", "dxf", "html", "jsonl", "parquet",
                 "pdf", "png", "txt"}  # fmt: skip
MOST_CHECKS = 10_000


def run(request: IndexInPlane) -> None:
    watch = Stopwatch()
    P, Q, output, threads = request.P, request.Q, request.output, request.threads
    window = text_of_bounds(request.from_scale, request.to_scale)
    _check_numbers(threads, request.check)
    refuse_stream(
        output, "an index is read at random places, so it cannot be a stream", "name a file"
    )
    check_writable(output)
    lines = not request.erode
    first, second = read_operand(P, lines), read_operand(Q, lines)
    refuse_overwriting(output, [first.file, second.file])
    if output.suffix.lower().removeprefix(".") in OTHER_FORMATS:
        what = f"an index has a format of its own, and {output.suffix} is the ending of another"
        raise Refusal(what, str(output), "name it FILE.index")
    with memory_wall(request.memory, "the index", f"{P} and {Q}", SMALLER):
        index = build_index(*_asked(request, first, second), threads)
    checked = _checked(index, request.check)
    with replacing(output) as temporary:
        refusing(str(output), lambda: index.save(str(temporary)))
    counts = dict(index.counts())
    value = document(
        "index",
        watch,
        P=first.name,
        Q=second.name,
        erode=request.erode,
        **{"from": window[0], "to": window[1]},
        warnings=first.warnings + second.warnings,
        output=str(output),
        bytes=counts.pop("bytes"),
        threads=threads or cores(),
        build_seconds=index.seconds,
        segments={"S": counts.pop("s_edges"), "T": counts.pop("t_edges")},
        checked=checked,
        statistics=counts,
    )
    give(value, request.json, _print)


def _asked(
    request: IndexInPlane, P: Operand, Q: Operand
) -> tuple[Operand, Operand, Fraction | None, Fraction | None]:
    """The operands and the window of the sum that is indexed."""
    window = request.from_scale, request.to_scale
    if not request.erode:
        return P, Q, *window
    eroding = eroding_pair(P, Q)
    return eroding.P, eroding.Q, *eroding.window(*window)


def _check_numbers(threads: int | None, check: int) -> None:
    limits = (
        ("--threads", 1 if threads is None else threads, 1, MOST_THREADS),
        ("--check", check, 0, MOST_CHECKS),
    )
    for option, value, least, most in limits:
        if not least <= value <= most:
            raise Refusal(
                f"this must be between {least} and {most:,}",
                f"{option} {value}",
                "choose another number",
            )


def _checked(index: _core.ScaleIndex, count: int) -> dict[str, Any]:
    """The scales at which the sum was compared with that of another route: all equal."""
    scales = scales_of(index, count)
    with progress(len(scales)) as line:
        for scale in scales:
            line.now("comparing with the static route")
            if index.first_difference([scale]):
                raise AssertionError(f"the index differs from the static route at {scale}")
            line.done()
    return {"routes": ["index", "paper"], "scales": scales}


def scales_of(index: _core.ScaleIndex, count: int) -> list[str]:
    """Scales of the window, the same ones each time; every other one at an event."""
    low, high = index.window
    dice = random.Random(1)
    events = index.event_scales()
    scales: list[str] = []
    for k in range(count):
        if k % 2 == 1 and events:
            scales.append(str(dice.choice(events)))
            continue
        least = low or (events[0] if events else high or Fraction(1)) / 2
        most = high or 2 * (events[-1] if events else least)
        scales.append(str(least + (most - least) * Fraction(dice.randrange(1, 1000), 1000)))
    return scales


def _print(value: dict[str, Any]) -> None:
    window = f"from {value['from'] or 'above 0'} to {value['to'] or 'infinity'}"
    statistics, segments = value["statistics"], value["segments"]
    size = value["bytes"]
    rows = [
        ("index", f"{value['P']} {'less' if value['erode'] else '+'} {value['Q']}, s {window}"),
        ("edges", f"{segments['S']:,} S, {segments['T']:,} T"),
        ("boundary events", f"{statistics['boundary_events']:,}"),
        ("topology events", f"{statistics['topology_events']:,}"),
        ("vertices ever", f"{statistics['tracks']:,}"),
        ("built in", f"{value['build_seconds']:.3f} s, {counted(value['threads'], 'thread')}"),
        (
            "checked",
            f"{counted(len(value['checked']['scales']), 'sum')} equal by the static route"
            if value["checked"]["scales"]
            else "not: --check 0",
        ),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {size:,} bytes"),
    ]
    print_lines(rows, value)
