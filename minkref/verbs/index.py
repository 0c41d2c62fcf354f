"""`minkref index P Q -o FILE`: the sums at all scales of a window, built once."""

from __future__ import annotations

import random
from fractions import Fraction
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref import _core
from minkref.cli.memory import SMALLER, Memory, memory_wall
from minkref.cli.options import FirstOperand, Json, Schema, SecondOperand, WindowFrom, WindowTo
from minkref.cli.output import give, print_lines
from minkref.cli.progress import progress
from minkref.disc.disc import is_disc
from minkref.errors import Refusal, refusing
from minkref.exact import read_window
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
from minkref.plane.operand import read_operand
from minkref.space.operand import in_space

EXAMPLES = """Examples:

minkref index disc1 cells1815 -o cells.index

minkref index glyph1204 glyph275 --from 1/10 --to 10 -o glyphs.index --json

minkref sum disc1 cells1815 --index cells.index --scale 7/5

minkref index glyph1204 disc -o diagram.json"""

MOST_THREADS = 256
OTHER_FORMATS = {*_core.SET_FORMATS, *_core.MESH_FORMATS, "csv", "dxf", "html", "jsonl", "parquet",
                 "pdf", "png", "txt"}  # fmt: skip
MOST_CHECKS, CHECKS = 10_000, 3


def command(
    P: FirstOperand,
    Q: SecondOperand,
    output: Annotated[
        Path,
        typer.Option(
            "-o", help="The file to write, as FILE.index; of a disc .json.", metavar="FILE"
        ),
    ],
    from_scale: WindowFrom = None,
    to_scale: WindowTo = None,
    threads: Annotated[
        int | None,
        typer.Option("--threads", help="Threads of the build. Default: one per core.", metavar="N"),
    ] = None,
    memory: Memory = None,
    check: Annotated[
        int,
        typer.Option(
            "--check", help="Compare the sums at N scales with the static route.", metavar="N"
        ),
    ] = CHECKS,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Find the boundary of the sum as a function of the scale: all its vertices, with the scales at
    which they exist, in ring order. `sum`, `sweep`, `events` and `view` then read any sum of the
    window off it, exactly, with --index FILE. With `disc` as second operand: the outer Voronoi
    diagram of P, with all events, holes and components, as JSON: the same commands read the sum
    with a disc of any radius off it."""
    if is_disc(P) or is_disc(Q):
        from minkref.disc.commands.index import index_with_disc

        unknown = {"--from": from_scale is not None, "--to": to_scale is not None}
        unknown["--check"] = check != CHECKS
        index_with_disc(P, Q, unknown, threads, output, json, memory)
        return
    watch = Stopwatch()
    if in_space(P, Q):
        mend = "`minkref events P Q --from A --to B` finds what happens at all scales of a window"
        raise Refusal("there is no index in space", f"{P} and {Q}", mend, "not-in-space")
    window = read_window(from_scale, to_scale)
    _check_numbers(threads, check)
    refuse_stream(
        output, "an index is read at random places, so it cannot be a stream", "name a file"
    )
    check_writable(output)
    first, second = read_operand(P), read_operand(Q)
    refuse_overwriting(output, [first.file, second.file])
    if output.suffix.lower().removeprefix(".") in OTHER_FORMATS:
        what = f"an index has a format of its own, and {output.suffix} is the ending of another"
        raise Refusal(what, str(output), "name it FILE.index")
    with memory_wall(memory, "the index", f"{P} and {Q}", SMALLER):
        index = build_index(first, second, window[0], window[1], threads)
    checked = _checked(index, check)
    with replacing(output) as temporary:
        refusing(str(output), lambda: index.save(str(temporary)))
    counts = dict(index.counts())
    value = document(
        "index",
        watch,
        P=first.name,
        Q=second.name,
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
    give(value, json, _print)


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
    begin, end = index.window
    low = Fraction(begin) if begin is not None else None
    high = Fraction(end) if end is not None else None
    dice = random.Random(1)
    events = [Fraction(scale) for scale in index.event_scales()]
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
        ("index", f"{value['P']} + {value['Q']}, s {window}"),
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
