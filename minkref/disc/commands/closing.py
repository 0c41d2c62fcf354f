"""`minkref opening` and `minkref closing` by a disc."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certain_digits import between, root
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, print_lines, written_row
from minkref.disc.closed import (
    DiscClosing,
    closed_by_disc,
    closing_near,
    form_of,
    opened_by_disc,
    opening_near,
    steps_of,
)
from minkref.disc.commands.sum import FORMATS, WITH_ARCS, check_polygon, enclosed
from minkref.disc.disc import Disc, is_disc, read_disc
from minkref.errors import Refusal, refusing
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import read_operand
from minkref.verbs.erode_request import MorphologyWithDisc


@dataclass(frozen=True)
class Operation:
    """A command: what it finds, and its polygons for files."""

    command: str
    find: Callable[[_core.PolygonSet, str, str, int], DiscClosing]
    near: Callable[[_core.PolygonSet, Disc, Fraction, bool], _core.PolygonSet]


def run_opening(request: MorphologyWithDisc) -> None:
    _run(Operation("opening", opened_by_disc, opening_near), request)


def run_closing(request: MorphologyWithDisc) -> None:
    _run(Operation("closing", closed_by_disc, closing_near), request)


def _run(operation: Operation, request: MorphologyWithDisc) -> None:
    watch = Stopwatch()
    P, Q, output = request.P, request.Q, request.output
    if is_disc(P):
        line = shlex.join(["minkref", operation.command, Q, P])
        mend = "give a polygon" if is_disc(Q) else f"give `{line}`"
        raise Refusal("the first operand is a set of polygons", P, mend)
    offered = FORMATS if request.tolerance is not None else WITH_ARCS
    target = target_of(output, request.form, FORMATS, "json", request.json, offered=offered)
    check_polygon(request, target)
    if request.only_region and (target is None or target.form != "svg"):
        raise Refusal("no picture is written", "--only-region", "add -o FILE.svg")
    disc = read_disc(Q)
    with memory_wall(request.memory, f"the {operation.command} by a disc", f"{P} and {Q}", SIMPLER):
        operand = read_operand(P)
        if output is not None:
            refuse_overwriting(output, [operand.file])
        scaled = operand.set.scaled(str(request.scale))
        square = str(disc.squared_radius)
        found = refusing(
            operand.name, lambda: operation.find(scaled, square, operand.name, cores())
        )
        written = None
        if target is not None:
            written = _written(target, operation, found, scaled, disc, request)
        if target is not None and written is not None and target.write(*written):
            return
    value = document(
        operation.command,
        watch,
        P=operand.name,
        Q=Q,
        scale=str(request.scale),
        warnings=operand.warnings,
        output=str(output) if output else None,
        output_exact=written[1] if written else None,
        tolerance=None if request.tolerance is None else str(request.tolerance),
        radius=disc.radius,
        squared_radius=square,
        compute_seconds=found.seconds,
        digest=found.digest,
        components=found.components,
        holes=found.holes,
        area=enclosed(found.area),
        rings=steps_of(found),
        arcs=[
            {"centre": list(centre), "ends": [list(start), list(end)]}
            for centre, start, end in found.arcs
        ],
        result=form_of(found),
    )
    give(value, request.json, _print)


def _written(
    target: Target,
    operation: Operation,
    found: DiscClosing,
    scaled: _core.PolygonSet,
    disc: Disc,
    request: MorphologyWithDisc,
) -> tuple[str, bool]:
    """Write the output text; tell whether it is exact."""
    if target.form == "json":
        if found.canonical_json is None:
            what = "an opening through places at which the disc just fits has no canonical form"
            raise Refusal(what, target.name, "write .svg or .dxf", "no-form")
        return found.canonical_json + "\n", True
    if target.form == "dxf":
        from minkref.output.dxf import dxf_of_steps

        return dxf_of_steps(found.rings, target.name), False
    if target.form == "svg":
        from minkref.reports.closing_picture import closing_picture

        caption = f"the {operation.command} by a disc of radius {root(disc.squared_radius, 6)}"
        own = None if request.only_region else scaled
        return closing_picture(found.rings, own, caption), False
    assert request.tolerance is not None
    near = operation.near(scaled, disc, request.tolerance, request.outside)
    return refusing(target.name, lambda: _core.write(near, target.form)), False


def _print(value: dict[str, Any]) -> None:
    scaled = "" if value["scale"] == "1" else f"{value['scale']} "
    rows = [
        (value["command"], f"{scaled}{value['P']} by {value['Q']}"),
        ("radius of the disc", value["radius"]),
        ("components, holes", f"{value['components']:,}, {value['holes']:,}"),
        ("rings, arcs", f"{len(value['rings']):,}, {len(value['arcs']):,}"),
        ("area", between(**value["area"])),
        ("digest", value["digest"] or "none: the disc just fits somewhere"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines(rows + written_row(value), value)
