"""`minkref view P Q` in the plane: the sum over a window of scales as a page with a slider."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from functools import cache

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import give
from minkref.cli.progress import told_of
from minkref.cli.readings import ROUTE as PAPER_UPDATE
from minkref.errors import Refusal, refusing
from minkref.output.documents import Stopwatch, document
from minkref.plane.commands.scale_index import chosen_route, index_of, refuse_overwriting_index
from minkref.plane.commands.view_table import counts, counts_of_erosion, print_view
from minkref.plane.eroded import ErodingPair, eroding_pair, refuse_others
from minkref.plane.operand import read_operand
from minkref.plane.page.boundary import Progress, Sums, Window
from minkref.plane.page.picture import picture
from minkref.plane.page.write_page import page
from minkref.verbs.paper_options import asked_program, told
from minkref.verbs.view import FROM, TO, ViewInPlane, page_target
from rich.console import Console

ROUTES = ("index", "dynamic", PAPER_UPDATE)


def run(request: ViewInPlane) -> None:
    watch = Stopwatch()
    P, Q, index, output = request.P, request.Q, request.index, request.output
    begin, end = _bounds(request)
    window = Window(str(begin), str(end))
    route = chosen_route(index, request.route, ROUTES)
    program = asked_program(
        route, request.arithmetic, request.as_read, request.reading, request.steps
    )
    target = page_target(output, request.json)
    refuse_others(request.erode, route, ROUTES[:2])
    refuse_overwriting_index(output, index)
    lines = not request.erode and route != PAPER_UPDATE
    named = first, second = read_operand(P, lines), read_operand(Q, lines)
    if request.erode:
        eroding = eroding_pair(first, second)
        first, second = eroding.P, eroding.Q
        window = _with_room(eroding, begin, end)

    @cache
    def sums() -> Sums:
        if route == "dynamic":
            return _core.DynamicSum(first.set, second.set, window.first, window.last)
        return index_of(index, first, second, Fraction(window.first), Fraction(window.last))

    with memory_wall(request.memory, f"route {route}", f"{P} and {Q}", SMALLER):
        with ring_progress() as progress:
            data = refusing(
                f"{first.name} and {second.name}",
                lambda: picture(first.set, second.set, window, sums, progress),
            )
        if program is not None:
            from minkref.plane.page.paper_run import paper_run

            exact = sums()
            assert isinstance(exact, _core.ScaleIndex)
            data["paper"] = paper_run(first, second, window, program, exact.sum)
        if request.erode:
            data["erode"] = True
        text = page(named[0].name, named[1].name, data)
    count = target.write_pieces([text])
    if target.is_standard_output:
        return
    value = document(
        "view",
        watch,
        P=named[0].name,
        Q=named[1].name,
        erode=request.erode,
        **{"from": window.first, "to": window.last},
        route=route,
        warnings=first.warnings + second.warnings,
        output=str(output),
        bytes=count,
        **(counts_of_erosion(data) if request.erode else counts(data)),
        **told(data.get("paper")),
    )
    give(value, request.json, print_view)


def _with_room(eroding: ErodingPair, begin: Fraction, end: Fraction) -> Window:
    """The part of the window at which the sum of the outside counts. Refuses one without."""
    first, last = max(begin, eroding.least), end
    if first >= last:
        raise Refusal(
            "Q has no room in P at any scale of the window",
            "--from, --to",
            f"give a --to above {eroding.least}",
            "empty-window",
        )
    return Window(str(first), str(last))


def _bounds(request: ViewInPlane) -> tuple[Fraction, Fraction]:
    """The window of the page; of an index, where no other is given."""
    first, last = request.from_scale, request.to_scale
    if request.index is not None:
        path = str(request.index)
        begin, end = refusing(path, lambda: _core.ScaleIndex.open(path).window)
        first = begin if first is None else first
        last = end if last is None else last
    first = Fraction(FROM) if first is None else first
    last = Fraction(TO) if last is None else last
    if first >= last:
        raise Refusal(
            f"the window from {first} to {last} is empty or a single scale",
            "--from, --to",
            "give a --from that is smaller than --to",
            "empty-window",
        )
    return first, last


@contextmanager
def ring_progress() -> Iterator[Progress]:
    """A bar on a terminal, else lines."""
    from rich.progress import Progress as Bar

    if not sys.stderr.isatty():
        with told_of("rings") as tell:
            yield tell
        return
    with Bar(console=Console(stderr=True), transient=True) as bar:
        bar.console.show_cursor(True)  # Ctrl-C ends the process at once
        task = bar.add_task("events", total=None)

        def progress(done: int, total: int) -> None:
            bar.update(task, description="rings", completed=done, total=total)

        yield progress
