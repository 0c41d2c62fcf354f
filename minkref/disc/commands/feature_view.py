"""`minkref view P --features`: concave features at any diameter, as a page with sliders."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, print_lines
from minkref.cli.progress import progress
from minkref.disc.commands.index_file import disc_index_of
from minkref.disc.commands.view import window_of
from minkref.disc.page.features.picture import counts, picture
from minkref.disc.page.features.write_page import page
from minkref.errors import refusing
from minkref.exact import approximate
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.signals import ending_in_order
from minkref.plane.commands.scale_index import cores, refuse_overwriting_index
from minkref.plane.operand import read_operand
from minkref.plane.page.boundary import Window
from minkref.verbs.view import ViewOfFeatures, page_target


def run(request: ViewOfFeatures) -> None:
    watch = Stopwatch()
    target = page_target(request.output, request.json)
    operand = read_operand(request.P)
    if not target.is_standard_output:
        refuse_overwriting(target.path, [operand.file])
        refuse_overwriting_index(target.path, request.index)
    with memory_wall(request.memory, "features", request.P, SIMPLER), ending_in_order():
        with progress(1) as line:
            line.now("finding all events")
            index = disc_index_of(request.index, operand)
            line.now("finding all features")
            found = _core.features(operand.set, cores(), index.places())
        first, last = window_of(
            request.from_scale, request.to_scale, index, operand.set, "diameter"
        )
        radii = Window(str(first / 2), str(last / 2))
        data = refusing(operand.name, lambda: picture(index, found, operand.set, radii))
        count = target.write_pieces([page(operand.name, data)])
    if target.is_standard_output:
        return
    value = document(
        "view",
        watch,
        P=operand.name,
        features=True,
        **{"from": str(first), "to": str(last)},
        warnings=operand.warnings,
        output=str(target.path),
        bytes=count,
        compute_seconds=index.seconds + found.seconds,
        **counts(data),
    )
    give(value, request.json, _print)


def _print(value: dict[str, Any]) -> None:
    ends = (f"{approximate(value[name]):.6g}" for name in ("from", "to"))
    rows = [
        ("features of", value["P"]),
        ("diameters", f"[{', '.join(ends)}]"),
        ("bars", f"{value['bars']:,}, {value['endless_bars']:,} without end"),
        ("merge tree", f"{value['nodes']:,} nodes"),
        ("diagram", f"{value['parts_of_the_diagram']:,} parts"),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {value['bytes']:,} bytes"),
    ]
    print_lines(rows, value)
