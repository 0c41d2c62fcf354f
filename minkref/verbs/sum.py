"""`minkref sum P Q`: the static sum sP + Q, exact."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from minkref import _core
from minkref.cli.arithmetic import check_arithmetic
from minkref.cli.memory import SIMPLER, Memory, memory_wall
from minkref.cli.options import Json, Scale, Schema, Triangles, refuse_triangles
from minkref.cli.readings import ROUTE as PAPER_UPDATE
from minkref.cli.readings import Form, Reading, readings_of, refuse_options
from minkref.disc.disc import is_disc
from minkref.errors import Refusal, refusing
from minkref.exact import read_scale
from minkref.output.documents import Stopwatch, as_text, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.output.terminal import console
from minkref.plane.commands.scale_index import (
    IndexFile,
    chosen_route,
    index_of,
    refuse_overwriting_index,
)
from minkref.plane.commands.sum_fields import SUM_FIELDS, sum_fields
from minkref.plane.commands.sum_table import print_table
from minkref.plane.operand import Operand, read_operand
from minkref.plane.operand_text import STANDARD_INPUT
from minkref.plane.parents import PassageRows, passages_of
from minkref.space.general_sum import GENERAL_ROUTES
from minkref.space.operand import in_space
from minkref.space.sums import ROUTES as SPACE_ROUTES

if TYPE_CHECKING:
    from minkref.verbs.paper_update import PaperWalk

EXAMPLES = """Examples:

minkref sum glyph1204 glyph275

minkref sum disc1 cells1815 --scale 541/186 --json

minkref sum P.wkt Q.geojson --scale 7/5 -o sum.svg

minkref sum g1 o1 --plot

minkref sum "POLYGON ((0 0, 2 0, 0 2, 0 0))" g1 -o -

cat P.wkt | minkref sum - Q.wkt --scale 7/5 -o - --format geojson

minkref sum g1 g2 --arithmetic mpfr:53

minkref sum g1 g2 --route paper-update --arithmetic mpfr:200 --reading observation=corrected

minkref sum disc1 cells1815 --index cells.index --scale 7/5

minkref sum gs3 rod --scale 2,1/3,5 -o sum.off

minkref sum cup.stl plate.stl --scale 3/2 -o sum.stl

minkref sum cup.stl plate.stl -o sum.ply --triangles

minkref sum g1 disc:7/5 -o offset.svg

minkref sum g1 disc:7/5 --route paper

minkref sum g1 disc:7/5 --measures --json

minkref sum P.wkt disc:sqrt:2 --scale 3/2 -o offset.wkt --tolerance 1/1000"""

MOVING = ("dynamic", "index")  # routes that find all scales of a window
ROUTES = (*_core.ROUTES, *MOVING, PAPER_UPDATE)
DEFAULT = "paper"
INSTEAD = dict.fromkeys(ROUTES, SIMPLER) | {
    "definition": f"{SIMPLER}, or the route paper",
    "dynamic": f"{SIMPLER}, or the route paper",
    "index": f"{SIMPLER}, or the route paper",
    PAPER_UPDATE: f"{SIMPLER}, or the route paper",
}
OUTPUTS = ("wkt", "geojson", "poly", "json", "svg")


def command(
    P: Annotated[
        str,
        typer.Argument(
            help="First operand, which is scaled: a file, a model, the WKT or JSON text itself, "
            "or `-` for standard input."
        ),
    ],
    Q: Annotated[str, typer.Argument(help="Second operand: given in the same ways.")],
    scale: Scale = "1",
    route: Annotated[
        str | None,
        typer.Option(
            "--route",
            help=f"How it is computed: {', '.join(ROUTES)}. Default: {DEFAULT}, or index with "
            f"--index. In space: {', '.join(GENERAL_ROUTES)}, and of convex polyhedra also "
            f"{', '.join(SPACE_ROUTES)}. Default: {SPACE_ROUTES[0]} for these, else "
            f"{GENERAL_ROUTES[0]}. With a disc: definition (the default), paper or index.",
        ),
    ] = None,
    index: IndexFile = None,
    arithmetic: Annotated[
        str,
        typer.Option(
            "--arithmetic",
            help="rational (exact), interval, double or mpfr:BITS. All but the first report "
            "their own result next to the true one.",
        ),
    ] = "rational",
    as_read: Form = None,
    reading: Reading = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            help="Write the sum to this file: .wkt, .geojson, .poly, .json or .svg; with a disc "
            "also .dxf; in space .off, .obj, .stl, .ply or .json. `-`: print the sum alone on "
            "standard output.",
            metavar="FILE",
        ),
    ] = None,
    form: Annotated[
        str | None,
        typer.Option(
            "--format",
            help="Format to write, whatever the name of the file ends in. Default for `-`: WKT, "
            "in space OFF.",
        ),
    ] = None,
    only_sum: Annotated[
        bool, typer.Option("--only-sum", help="In an SVG, draw the sum alone, without P and Q.")
    ] = False,
    plot: Annotated[
        bool, typer.Option("--plot", help="Draw a small picture of the sum below the table.")
    ] = False,
    passages: Annotated[
        bool,
        typer.Option(
            "--passages",
            help="In space: find the tight passages too, for operands of few convex pieces. In the "
            "plane they are always found.",
        ),
    ] = False,
    triangles: Triangles = False,
    tolerance: Annotated[
        str | None,
        typer.Option(
            "--tolerance",
            help="With a disc, in formats without arcs: write a polygon inside of the sum, all "
            "points of which are within this of it.",
            metavar="T",
        ),
    ] = None,
    outside: Annotated[
        bool,
        typer.Option("--outside", help="The polygon that --tolerance asks for contains the sum."),
    ] = False,
    measures: Annotated[
        bool,
        typer.Option(
            "--measures", help="With a disc and --json: length and area exact, as sums of terms."
        ),
    ] = False,
    memory: Memory = None,
    json: Json = False,
    schema: Schema = False,
) -> None:
    """The Minkowski sum of P, scaled by S about the origin, and Q: exact, in canonical form, and
    its tight passages. One of the two may be a disc about the origin, as disc:7/5 or disc:sqrt:2:
    the sum has arcs then. In space P and Q are polyhedra of any shape (.off, .obj, .stl, .ply,
    .json); one may be a plane polygon, a segment or a point. In another arithmetic, or by the
    paper's own program (--route paper-update), what these answer, with the exact sum beside it."""
    if is_disc(P) or is_disc(Q):
        _refuse_without_arcs(arithmetic, as_read, reading, plot, passages, triangles)
        from minkref.disc.commands.sum import sum_with_disc

        sum_with_disc(
            P, Q, scale, route, output, form, only_sum, tolerance, outside, measures, memory,
            index, json,
        )  # fmt: skip
        return
    options = {"--tolerance": tolerance is not None, "--outside": outside, "--measures": measures}
    for option, is_given in options.items():
        if is_given:
            raise Refusal("there are no arcs without a disc", option, "leave it out")
    if in_space(P, Q):
        for option, given in (("--form", as_read), ("--reading", reading)):
            if given:
                raise Refusal("there are no readings in space", option, "leave it out")
        if index is not None:
            raise Refusal("there is no index in space", f"--index {index}", "leave it out")
        if plot or only_sum:
            option = "--plot" if plot else "--only-sum"
            raise Refusal("no picture is drawn in space", option, "see `minkref view P Q`")
        from minkref.space.commands.sum import sum_in_space

        sum_in_space(
            P, Q, scale, route, arithmetic, output, json, form, memory, passages, triangles
        )
        return
    refuse_triangles(triangles)
    if P == Q == STANDARD_INPUT:
        raise Refusal("standard input is one operand", "P and Q", "name a file for the other")
    watch = Stopwatch()
    exact_scale = read_scale(scale)
    route = chosen_route(index, route, ROUTES, DEFAULT)
    _check_arithmetic(arithmetic, route)
    refuse_options(route, as_read, reading)
    readings = readings_of(as_read, reading) if route == PAPER_UPDATE else None
    target = target_of(output, form, OUTPUTS, "wkt", json)
    _check_pictures(plot, only_sum, target, json)
    with memory_wall(memory, f"route {route}", f"{P} and {Q}", INSTEAD[route]):
        first, second = read_operand(P), read_operand(Q)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
            refuse_overwriting_index(output, index)
        result = compute(first, second, exact_scale, route, arithmetic, index, readings)
        region, truth = result.pop("region"), result.pop("truth")
    drawn = (first, second, exact_scale, result, truth) if not only_sum else None
    written = _written(region, target, drawn) if target is not None else None
    if target is not None and written is not None:
        if target.write(*written):
            return
    value = document(
        "sum",
        watch,
        P=first.name,
        Q=second.name,
        scale=exact_scale,
        warnings=first.warnings + second.warnings,
        output=str(output) if output else None,
        output_exact=written[1] if written else None,
        **result,
    )
    if json:
        sys.stdout.write(as_text(value))
        return
    print_table(value)
    if plot:
        _plot(region)


def _refuse_without_arcs(
    arithmetic: str, as_read: str | None, reading: list[str] | None, plot: bool, passages: bool,
    triangles: bool,
) -> None:  # fmt: skip
    """Options that sums with a disc do not have."""
    others = {
        "--arithmetic": arithmetic != "rational",
        "--form": as_read is not None,
        "--reading": bool(reading),
        "--plot": plot,
        "--passages": passages,
        "--triangles": triangles,
    }
    for option, is_given in others.items():
        if is_given:
            raise Refusal("sums with a disc do not have this option", option, "leave it out")


def _check_pictures(plot: bool, only_sum: bool, target: Target | None, json: bool) -> None:
    if only_sum and (target is None or target.form != "svg"):
        raise Refusal("no picture is written", "--only-sum", "add -o FILE.svg")
    if not plot:
        return
    if json or (target is not None and target.is_standard_output):
        other = "--json" if json else "-o -"
        what = "standard output takes only one of them"
        raise Refusal(what, f"--plot {other}", "leave out one of the two")
    from minkref.cli.terminal_picture import check_drawable

    check_drawable()


def _plot(region: _core.PolygonSet | None) -> None:
    from minkref.cli.terminal_picture import terminal_picture

    if region is not None:
        sys.stdout.write("\n" + terminal_picture(region, console().width))


def _written(
    region: _core.PolygonSet | None,
    target: Target,
    drawn: tuple[Operand, Operand, str, dict[str, Any], _core.PolygonSet | None] | None,
) -> tuple[str, bool]:
    """The text of the output, and whether it is exact. `drawn`: what an SVG shows beside the
    sum."""
    if region is None:
        raise Refusal(
            "the arithmetic could not decide a sign: there is nothing to write",
            target.name,
            "use --arithmetic rational",
            "undecided-sign",
        )
    if target.form == "svg" and drawn is not None:
        P, Q, scale, found, truth = drawn
        from minkref.reports.sum_picture import sum_picture

        counts = (found["components"], found["holes"])
        passages = [passage["points"] for passage in found["tight_passages"] or ()]
        return sum_picture(P, Q, scale, region, *counts, truth, passages), False
    text = refusing(target.name, lambda: _core.write(region, target.form))
    return text, _core.writes_exactly(region, target.form)


def compute(
    P: Operand,
    Q: Operand,
    scale: str,
    route: str,
    arithmetic: str,
    index: Path | None = None,
    readings: dict[str, str] | None = None,
) -> dict[str, Any]:
    """The fields of the document that describe the sum, and `region` (None where the arithmetic
    could not decide a sign), and `truth`, the exact sum where the paper's program has answered. For
    another arithmetic than rational, `exact` says what is true."""
    import json

    where = f"{P.name} and {Q.name}"
    exact = arithmetic == "rational" and readings is None
    undecided = False
    answer: _core.Sum | None = None
    seconds: float | None = None
    passages: PassageRows | None = None
    walk: PaperWalk | None = None
    try:
        if route == "dynamic":
            answer, passages, seconds = refusing(where, lambda: _dynamic(P, Q, scale))
        elif readings is not None:
            from minkref.verbs.paper_update import PaperWalk

            walk = PaperWalk(P, Q, scale, arithmetic, readings)
            answer = refusing(where, walk.sum)
            seconds = walk.seconds + answer.seconds
        elif route == "index":
            built = index_of(index, P, Q, scale, scale)
            answer = refusing(where, lambda: built.sum(scale, True))
            passages = answer.passage_rows()
            seconds = answer.seconds if index else built.seconds + answer.seconds
        else:
            answer = refusing(
                where, lambda: _core.minkowski_sum(P.set, Q.set, scale, route, arithmetic, exact)
            )
            passages, seconds = answer.passage_rows() if exact else None, answer.seconds
    except _core.UndecidedSign:
        undecided = True
    fields: dict[str, Any] = {
        "route": route,
        "arithmetic": arithmetic,
        "undecided": undecided,
        "compute_seconds": seconds,
        **_description(answer),
        "tight_passages": None if passages is None else passages_of(passages),
        "signs": _signs(answer.statistics) if answer and route in _core.ROUTES else None,
        "statistics": dict(answer.statistics) if answer else None,
        "exact": None,
        "readings": readings,
        "comparison": None,
    }
    if not exact:
        truth = refusing(
            where, lambda: _core.minkowski_sum(P.set, Q.set, scale, "paper", "rational")
        )
        described = _description(truth)
        equal = described["digest"] == fields["digest"] if answer else None
        fields["exact"] = {**described, "equal": equal}
        del fields["exact"]["result"]
        if walk is not None and answer is not None:
            fields["comparison"] = walk.beside_exact(scale, answer, truth)
    canonical = answer.region.canonical_json() if answer else None
    fields["result"] = json.loads(canonical) if canonical else None
    fields["region"] = answer.region if answer else None
    fields["truth"] = truth.region if readings is not None else None
    return fields


def _dynamic(P: Operand, Q: Operand, scale: str) -> tuple[_core.Sum, PassageRows, float]:
    """By dynamic update, over a window that is this scale only. The passages are not kept while the
    scale changes: they are those of the static arrangement."""
    start = time.perf_counter()
    moving = _core.DynamicSum(P.set, Q.set, scale, scale)
    moving.move_to(scale)
    answer = moving.sum()
    passages = _core.tight_passages(P.set, Q.set, scale)
    return answer, passages, time.perf_counter() - start


def _description(answer: _core.Sum | None) -> dict[str, Any]:
    fields = dict.fromkeys(SUM_FIELDS) if answer is None else sum_fields(answer)
    return {**fields, "result": None}


def _signs(statistics: dict[str, Any]) -> dict[str, Any]:
    counts = {name: int(statistics[name]) for name in ("by_float", "by_integer", "by_rational")}
    total = sum(counts.values())
    shares = {name: count / total if total else 0.0 for name, count in counts.items()}
    return {**counts, "total": total, "shares": shares}


def _check_arithmetic(arithmetic: str, route: str) -> None:
    check_arithmetic(arithmetic)
    if arithmetic != "rational" and route not in ("paper", PAPER_UPDATE):
        raise Refusal(
            f"the route {route} is exact only",
            f"--route {route} --arithmetic {arithmetic}",
            "leave out one of the two options",
        )
