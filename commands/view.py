"""`minkref view P Q`: the sum over a window of scales as a page with a slider."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import Annotated, Any

import typer
from minkref import _core
from minkref.commands.line.memory import SMALLER, Memory, memory_wall
from minkref.commands.line.options import FirstOperand, Json, Schema, SecondOperand
from minkref.commands.line.output import give, print_lines
from minkref.commands.lists.scale_index import (
    IndexFile,
    chosen_route,
    index_of,
    refuse_overwriting_index,
)
from minkref.commands.pages.plane.picture import Progress, Sums, Window, picture
from minkref.commands.pages.plane.write_page import page
from minkref.documents import Stopwatch, document
from minkref.errors import Refusal, refusing
from minkref.exact import approximate, read_scale
from minkref.operand import read_operand
from minkref.output_target import Target, target_of
from minkref.space.operand import in_space
from rich.console import Console

EXAMPLES = """Examples:

minkref view disc1 cells1815

minkref view g1 g2 --from 1/2 --to 2 -o g1-g2.html

minkref view gs3 rod --scale 2,1/3,5 -o gs3-rod.html

minkref view gs3 rod --scales scales.txt -o gs3-rod.html"""

ROUTES = ("index", "dynamic")
FROM, TO = "1/10", "10"
ENDINGS = ("html", "htm")


def command(
    P: FirstOperand,
    Q: SecondOperand,
    from_scale: Annotated[
        str | None,
        typer.Option("--from", help=f"Smallest scale, included. Default: {FROM}.", metavar="A"),
    ] = None,
    to_scale: Annotated[
        str | None,
        typer.Option("--to", help=f"Largest scale, included. Default: {TO}.", metavar="B"),
    ] = None,
    scale: Annotated[
        str | None,
        typer.Option("--scale", help="In space: the only scale. Default: 1.", metavar="SX,SY,SZ"),
    ] = None,
    scales: Annotated[
        Path | None,
        typer.Option(
            "--scales",
            help="In space: a file with SX,SY,SZ (or S) in each line, for a slider.",
            metavar="FILE",
        ),
    ] = None,
    route: Annotated[
        str | None,
        typer.Option(
            "--route",
            help="How the sums are computed: read off an index of all scales (index, the "
            "default), or by the paper's dynamic update (dynamic).",
        ),
    ] = None,
    index: IndexFile = None,
    output: Annotated[
        Path,
        typer.Option("-o", help="The .html page to write; - is standard output.", metavar="FILE"),
    ] = Path("view.html"),
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Write one self-contained HTML page with a slider over the scale: the sum, its convolution,
    and the holes from birth to death. In space P and Q are convex polyhedra: the page shows the sum
    at each scale, lets you turn it, and names the parents of its facets and vertices."""
    if in_space(P, Q):
        given = _given(
            ("--from", from_scale), ("--to", to_scale), ("--route", route), ("--index", index)
        )
        from minkref.commands.space.view import view_in_space

        view_in_space(P, Q, scale, scales, given, _page_target(output, json), json, memory)
        return
    watch = Stopwatch()
    if index is not None:
        bounds = refusing(str(index), lambda: _core.ScaleIndex.open(str(index)).window)
        from_scale = bounds[0] if from_scale is None else from_scale
        to_scale = bounds[1] if to_scale is None else to_scale
    window = _window(from_scale, to_scale, _given(("--scale", scale), ("--scales", scales)))
    route = chosen_route(index, route, ROUTES)
    target = _page_target(output, json)
    refuse_overwriting_index(output, index)
    first, second = read_operand(P), read_operand(Q)

    def sums() -> Sums:
        if route == "index":
            return index_of(index, first, second, window.first, window.last)
        return _core.DynamicSum(first.set, second.set, window.first, window.last)

    wall = memory_wall(memory, f"route {route}", f"{P} and {Q}", SMALLER)
    with wall, _progress() as progress:
        data = refusing(
            f"{first.name} and {second.name}",
            lambda: picture(first.set, second.set, window, sums, progress),
        )
        text = page(first.name, second.name, data)
    count = target.write_pieces([text])
    if target.is_standard_output:
        return
    value = document(
        "view",
        watch,
        P=first.name,
        Q=second.name,
        **{"from": window.first, "to": window.last},
        route=route,
        warnings=first.warnings + second.warnings,
        output=str(output),
        bytes=count,
        **_counts(data),
    )
    give(value, json, _print)


def _given(*options: tuple[str, object | None]) -> list[str]:
    return [name for name, value in options if value is not None]


def _page_target(output: Path, json: bool) -> Target:
    target = target_of(output, None, ENDINGS, ENDINGS[0], json)
    assert target is not None
    return target


def _window(from_scale: str | None, to_scale: str | None, given: list[str]) -> Window:
    """`given` are options of space."""
    if given:
        mend = "give a window, --from A --to B, or convex polyhedra"
        raise Refusal("these options are for polyhedra in space", ", ".join(given), mend)
    window = Window(
        read_scale(FROM if from_scale is None else from_scale, "--from"),
        read_scale(TO if to_scale is None else to_scale, "--to"),
    )
    if Fraction(window.first) >= Fraction(window.last):
        raise Refusal(
            f"the window from {window.first} to {window.last} is empty or a single scale",
            "--from, --to",
            "give a --from that is smaller than --to",
            "empty-window",
        )
    return window


@contextmanager
def _progress() -> Iterator[Progress]:
    """A bar on a terminal, nothing elsewhere."""
    from rich.progress import Progress as Bar

    with Bar(console=Console(stderr=True), transient=True, disable=not sys.stderr.isatty()) as bar:
        bar.console.show_cursor(True)  # Ctrl-C ends the process at once
        task = bar.add_task("events", total=None)

        def progress(done: int, total: int) -> None:
            bar.update(task, description="rings", completed=done, total=total)

        yield progress


def _counts(data: dict[str, Any]) -> dict[str, Any]:
    changes = [state for state in data["states"] if state]
    return {
        "segments": {kind: len(data[kind]) // 2 for kind in ("S", "T")},
        "boundary_events": len(data["scales"]),
        "topology_events": len(data["topology"]),
        "holes": sum(life is not None for life in data["holes"][1:]),
        "components": sum(life is not None for life in data["components"]),
        "tracks": len(data["tracks"]) // 4,
        "splices": sum(len(ring) - 4 for state in changes for ring in state[1:]),
    }


def _print(value: dict[str, Any]) -> None:
    window = f"[{value['from']}, {value['to']}]"
    if Fraction(value["from"]).denominator > 10**6 or Fraction(value["to"]).denominator > 10**6:
        window += f", about [{approximate(value['from']):.6g}, {approximate(value['to']):.6g}]"
    segments = value["segments"]
    rows = [
        ("sP + Q", f"{value['P']} + {value['Q']}"),
        ("window", window),
        ("route", value["route"]),
        ("edges", f"{segments['S']:,} S, {segments['T']:,} T"),
        ("boundary events", f"{value['boundary_events']:,}"),
        ("topology events", f"{value['topology_events']:,}"),
        ("holes ever", f"{value['holes']:,}"),
        ("components ever", f"{value['components']:,}"),
        ("vertices ever", f"{value['tracks']:,}"),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {value['bytes']:,} bytes"),
    ]
    print_lines(rows, value)
