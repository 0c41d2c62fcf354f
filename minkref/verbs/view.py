"""`minkref view P Q`: the sum over a window of scales as a page with a slider."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Annotated

import typer
from minkref import _core
from minkref.cli.memory import SMALLER, Memory, memory_wall
from minkref.cli.options import FirstOperand, Json, Schema, SecondOperand
from minkref.cli.output import give
from minkref.cli.readings import ROUTE as PAPER_UPDATE
from minkref.cli.readings import Form, Reading
from minkref.disc.disc import is_disc
from minkref.errors import Refusal, refusing
from minkref.exact import read_scale
from minkref.output.documents import Stopwatch, document
from minkref.output.output_target import Target, target_of
from minkref.plane.commands.scale_index import (
    IndexFile,
    chosen_route,
    index_of,
    refuse_overwriting_index,
)
from minkref.plane.commands.view_table import counts, print_view
from minkref.plane.operand import read_operand
from minkref.plane.page.picture import Progress, Sums, Window, picture
from minkref.plane.page.write_page import page
from minkref.space.operand import in_space
from minkref.verbs.paper_options import MOST_STEPS, STEPS, asked_program, told
from rich.console import Console

EXAMPLES = """Examples:

minkref view disc1 cells1815

minkref view g1 g2 --from 1/2 --to 2 -o g1-g2.html

minkref view g1 g2 --route paper-update --arithmetic double -o paper.html

minkref view glyph1204 disc -o grown.html

minkref view disc1 g2 --path "LINESTRING (-60 55, 60 55)" -o way.html

minkref view gs3 rod --scale 2,1/3,5 -o gs3-rod.html

minkref view gs3 rod --scales scales.txt -o gs3-rod.html"""

ROUTES = ("index", "dynamic", PAPER_UPDATE)
FROM, TO = "1/10", "10"
ENDINGS = ("html", "htm")


def command(
    P: FirstOperand,
    Q: SecondOperand,
    from_scale: Annotated[
        str | None,
        typer.Option(
            "--from",
            help=f"Smallest scale, included. Default: {FROM}. In space "
            "a window, --from A --to B, has an axis of the events of facets.",
            metavar="A",
        ),
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
            "default), or by the paper's dynamic update (dynamic). paper-update: read off, and "
            "beside them what the paper's own program answers, formula by formula.",
        ),
    ] = None,
    arithmetic: Annotated[
        str | None,
        typer.Option(
            "--arithmetic",
            help=f"With --route {PAPER_UPDATE}: rational (the default), interval, double or "
            "mpfr:BITS.",
            metavar="A",
        ),
    ] = None,
    as_read: Form = None,
    reading: Reading = None,
    steps: Annotated[
        int | None,
        typer.Option(
            "--steps",
            help=f"With --route {PAPER_UPDATE}: how many scales of the slider the program goes "
            f"through, at most {MOST_STEPS}. Default: {STEPS}.",
            metavar="N",
        ),
    ] = None,
    index: IndexFile = None,
    path: Annotated[
        str | None,
        typer.Option(
            "--path",
            help="Show P, the part, on this polyline of its origin among the obstacles Q, and the "
            "places and scales at which it collides: WKT, GeoJSON or CSV, file or text.",
            metavar="PATH",
        ),
    ] = None,
    contact: Annotated[
        str | None,
        typer.Option(
            "--contact",
            help="With --path: allowed (the default), the part may touch, or forbidden.",
            metavar="RULE",
        ),
    ] = None,
    output: Annotated[
        Path,
        typer.Option("-o", help="The .html page to write; - is standard output.", metavar="FILE"),
    ] = Path("view.html"),
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """Write one self-contained HTML page with a slider over the scale: the sum, its convolution,
    and the holes from birth to death. In space P and Q are polyhedra: the page shows the sum at
    each scale, lets you turn it and cut it open, and names the parents of its facets and
    vertices. With `disc` as second operand the slider is the radius of a disc. With --path the
    page shows a part on a path: the scales at which it passes, and why at no others."""
    of_scales = _given(
        ("--route", route), ("--index", index),
        ("--arithmetic", arithmetic), ("--form", as_read), ("--reading", reading or None),
        ("--steps", steps),
    )  # fmt: skip
    of_space = _given(("--scale", scale), ("--scales", scales))
    if path is not None:
        from minkref.motion.commands.path_view import view_with_path

        target = _page_target(output, json)
        window_given, given = (from_scale, to_scale), of_space + of_scales
        rule = contact or "allowed"
        view_with_path(P, Q, path, rule, window_given, given, target, json, memory)
        return
    if contact is not None:
        has_paths = not (is_disc(P) or is_disc(Q) or in_space(P, Q))
        mend = "add --path PATH, or leave it out" if has_paths else "leave it out"
        raise Refusal("a rule of contact is one of a path", "--contact", mend)
    if is_disc(P) or is_disc(Q):
        from minkref.disc.commands.view import view_with_disc

        target = _page_target(output, json)
        taken = ("--index", "--route") if route == "index" else ("--index",)
        given = of_space + [option for option in of_scales if option not in taken]
        view_with_disc(P, Q, from_scale, to_scale, index, given, target, json, memory)
        return
    if in_space(P, Q):
        from minkref.space.commands.view import view_in_space

        target = _page_target(output, json)
        view_in_space(P, Q, from_scale, to_scale, scale, scales, of_scales, target, json, memory)
        return
    watch = Stopwatch()
    if index is not None:
        bounds = refusing(str(index), lambda: _core.ScaleIndex.open(str(index)).window)
        from_scale = bounds[0] if from_scale is None else from_scale
        to_scale = bounds[1] if to_scale is None else to_scale
    window = _window(from_scale, to_scale, of_space)
    route = chosen_route(index, route, ROUTES)
    program = asked_program(route, arithmetic, as_read, reading, steps)
    target = _page_target(output, json)
    refuse_overwriting_index(output, index)
    first, second = read_operand(P), read_operand(Q)

    @cache
    def sums() -> Sums:
        if route == "dynamic":
            return _core.DynamicSum(first.set, second.set, window.first, window.last)
        return index_of(index, first, second, window.first, window.last)

    with memory_wall(memory, f"route {route}", f"{P} and {Q}", SMALLER):
        with _progress() as progress:
            data = refusing(
                f"{first.name} and {second.name}",
                lambda: picture(first.set, second.set, window, sums, progress),
            )
        if program is not None:
            from minkref.plane.page.paper_run import paper_run

            exact = sums()
            assert isinstance(exact, _core.ScaleIndex)
            data["paper"] = paper_run(first, second, window, program, exact.sum)
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
        **counts(data),
        **told(data.get("paper")),
    )
    give(value, json, print_view)


def _given(*options: tuple[str, object | None]) -> list[str]:
    return [name for name, value in options if value is not None]


def _page_target(output: Path, json: bool) -> Target:
    target = target_of(output, None, ENDINGS, ENDINGS[0], json, has_format=False)
    assert target is not None
    return target


def _window(from_scale: str | None, to_scale: str | None, given: list[str]) -> Window:
    """`given` are options of space."""
    if given:
        mend = "give a window, --from A --to B, or polyhedra"
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
