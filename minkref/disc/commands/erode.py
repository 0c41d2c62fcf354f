"""`minkref erode P disc:R`: the inset, or inward offset, of P."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.certain_digits import between, root
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, print_lines, written_row
from minkref.disc.commands.sum import FORMATS, WITH_ARCS, check_polygon, described, passage_document
from minkref.disc.disc import Disc, is_disc, read_disc
from minkref.disc.polygons import inset_near
from minkref.errors import Refusal, refusing
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.plane.commands.scale_index import chosen_route, cores
from minkref.plane.commands.sum_table import passage_rows
from minkref.plane.operand import read_operand
from minkref.verbs.erode_request import DISC_ROUTES, ErodeWithDisc


def run(request: ErodeWithDisc) -> None:
    watch = Stopwatch()
    P, Q, output = request.P, request.Q, request.output
    if is_disc(P):
        raise Refusal("a disc is not eroded", P, "give a polygon first, and the disc after it")
    route = chosen_route(None, request.route, DISC_ROUTES)
    offered = FORMATS if request.tolerance is not None else WITH_ARCS
    target = target_of(output, request.form, FORMATS, "json", request.json, offered=offered)
    check_polygon(request, target)
    if request.only_region and (target is None or target.form != "svg"):
        raise Refusal("no picture is written", "--only-region", "add -o FILE.svg")
    disc = read_disc(Q)
    with memory_wall(request.memory, "the erosion by a disc", f"{P} and {Q}", SIMPLER):
        operand = read_operand(P)
        if output is not None:
            refuse_overwriting(output, [operand.file])
        scaled = operand.set.scaled(str(request.scale))
        square = str(disc.squared_radius)
        found = refusing(operand.name, lambda: _core.inset(scaled, square, cores(), route))
        canonical = found.canonical_json()
        remnants = found.tight_passages(cores())
        written = None
        if target is not None:
            near = [points for _, points, _ in remnants]
            written = _written(target, found, scaled, disc, canonical, request, near)
        if target is not None and written is not None and target.write(*written):
            return
    value = document(
        "erode",
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
        route=route,
        compute_seconds=found.seconds,
        **described(found, canonical),
        remnants=[passage_document(*row) for row in remnants],
    )
    give(value, request.json, _print)


def _written(
    target: Target,
    found: _core.Offset,
    scaled: _core.PolygonSet,
    disc: Disc,
    canonical: str,
    request: ErodeWithDisc,
    remnants: list[list[tuple[float, float]]],
) -> tuple[str, bool]:
    """Write the output text; tell whether it is exact."""
    if target.form == "json":
        return canonical + "\n", True
    if target.form == "dxf":
        from minkref.output.dxf import dxf_text

        return dxf_text(found, target.name), False
    if target.form == "svg":
        from minkref.offset_picture import offset_picture

        caption = f"the erosion by a disc of radius {root(disc.squared_radius, 6)}"
        own = None if request.only_region else scaled
        return offset_picture(found, own, caption, remnants, beneath=True), False
    assert request.tolerance is not None
    near = inset_near(scaled, disc, request.tolerance, request.outside)
    return refusing(target.name, lambda: _core.write(near, target.form)), False


def _print(value: dict[str, Any]) -> None:
    scaled = "" if value["scale"] == "1" else f"{value['scale']} "
    rows = [
        ("erode", f"{scaled}{value['P']} less {value['Q']}"),
        ("radius of the disc", value["radius"]),
        ("route", value["route"]),
        ("components, holes", f"{value['components']:,}, {value['holes']:,}"),
        ("curves", f"{value['curves']:,}"),
        ("area", between(**value["area"])),
        ("length of the boundary", between(**value["length"])),
        ("digest", value["digest"]),
        *passage_rows(value["remnants"], "segment", "remnants"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines(rows + written_row(value), value)
