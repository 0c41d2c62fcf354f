"""`minkref view P disc`: the sum with a disc at any radius, as a page with a slider."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import give, print_lines
from minkref.cli.progress import progress
from minkref.disc.commands.index_file import disc_index_of
from minkref.disc.disc import ANY
from minkref.disc.eroded import eroded_by_disc
from minkref.disc.page.picture import counts, picture, window_around
from minkref.disc.page.write_page import page
from minkref.errors import Refusal, refusing
from minkref.exact import approximate
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.signals import ending_in_order
from minkref.plane.commands.scale_index import refuse_overwriting_index
from minkref.plane.operand import read_operand
from minkref.plane.page.boundary import Window
from minkref.verbs.view import ViewWithDisc, page_target

RADII = {"radius": 1, "diameter": 2}
LEAST_WINDOW = 10  # the last radius over the first, where only one of them is given


def run(request: ViewWithDisc) -> None:
    watch = Stopwatch()
    P, Q, index_file = request.P, request.Q, request.index
    target = page_target(request.output, request.json)
    if Q != ANY or P == ANY:
        mend = "give `minkref view P disc`, and the radii by --from and --to"
        raise Refusal("the radius is that of the slider, and P stays", f"{P} {Q}", mend)
    if request.route not in (None, "index"):
        what = "the page of a disc is read off an index alone"
        raise Refusal(what, "--route", "leave it out")
    operand = named = read_operand(P)
    if request.erode:
        around = eroded_by_disc(operand.set, operand.name).set
        operand = replace(operand, name=f"the outside of {operand.name}", set=around)
    if not target.is_standard_output:
        refuse_overwriting(target.path, [operand.file])
        refuse_overwriting_index(target.path, index_file)
    with memory_wall(request.memory, "the index of all radii", P, SMALLER), ending_in_order():
        with progress(1) as line:
            line.now("finding all events" if index_file is None else "proving all events again")
            index = disc_index_of(index_file, operand)
        ends = window_of(request.from_scale, request.to_scale, index, operand.set)
        window = Window(*map(str, ends))
        data = refusing(operand.name, lambda: picture(index, operand.set, window))
        count = target.write_pieces([page(operand.name, data)])
    if target.is_standard_output:
        return
    value = document(
        "view",
        watch,
        P=named.name,
        Q=Q,
        erode=request.erode,
        **{"from": window.first, "to": window.last},
        warnings=operand.warnings,
        output=str(target.path),
        bytes=count,
        preprocessing_seconds=index.seconds,
        **counts(data),
    )
    give(value, request.json, _print)


def window_of(
    first: Fraction | None,
    last: Fraction | None,
    index: _core.DiscIndex,
    P: _core.PolygonSet,
    length: str = "radius",
) -> tuple[Fraction, Fraction]:
    """The ends of the slider of radii, or diameters: as asked, and else around all events."""
    if first is None or last is None:
        begin, end = (RADII[length] * bound for bound in window_around(index, P))
        if first is None:
            first = begin if last is None else min(begin, last / LEAST_WINDOW)
        if last is None:
            last = max(end, first * LEAST_WINDOW)
    if first >= last:
        raise Refusal(
            f"the window from {first} to {last} is empty or a single {length}",
            "--from, --to",
            "give a --from that is smaller than --to",
            "empty-window",
        )
    return first, last


def _print(value: dict[str, Any]) -> None:
    kinds = ", ".join(f"{kind} {n:,}" for kind, n in value["events"].items() if n)
    sign = "less" if value["erode"] else "+"
    ends = (f"{approximate(value[name]):.6g}" for name in ("from", "to"))
    rows = [
        (f"P {sign} disc", f"{value['P']} {sign} {value['Q']}"),
        ("radii", f"[{', '.join(ends)}]"),
        ("radii of events", f"{value['radii_of_events']:,}"),
        ("events", kinds or "none"),
        ("holes ever", f"{value['holes']:,}"),
        ("diagram", f"{value['parts_of_the_diagram']:,} parts"),
        ("all events", f"{value['preprocessing_seconds']:.3f} s"),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {value['bytes']:,} bytes"),
    ]
    print_lines(rows, value)
