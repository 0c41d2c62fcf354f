"""`minkref sum` and `minkref erode` with a ball: two polyhedral sets, and the answer between."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.certain_digits import enclosing
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, print_lines, written_row
from minkref.cli.progress import told_of
from minkref.disc.disc import Disc, is_disc
from minkref.errors import Refusal, refusing
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.commands.scale_index import cores
from minkref.plane.commands.sweep_folder import SPACE_FORMATS
from minkref.plane.place import place_rows, placed_between
from minkref.space.ball import is_ball, read_ball
from minkref.space.ball_sum import Between, sum_between
from minkref.space.commands.rounding import beyond_doubles, rounding_of, rounding_rows
from minkref.space.commands.set_fields import mesh_of, set_fields
from minkref.space.erosion_between import erosion_between
from minkref.space.operand import SpaceOperand, read_summand
from minkref.space.scaling import UNIT, Scaling, text_of
from minkref.verbs.erode_request import ErodeWithBall
from minkref.verbs.sum import SumWithBall

COUNTS = ("components", "cavities", "tunnels")


def run_sum(request: SumWithBall) -> None:
    """The sum of a polyhedron and a ball, in either order."""
    P, Q = request.P, request.Q
    if is_ball(P) and is_ball(Q):
        raise Refusal("the sum of two balls is one", f"{P} and {Q}", "add their radii")
    ball, other, scaling = read_ball(P if is_ball(P) else Q), Q, request.scale
    if is_ball(P):
        if len(set(scaling)) > 1:
            mend = "give one factor, or the ball as the second operand"
            raise Refusal("a ball has one factor for all axes", f"--scale {text_of(scaling)}", mend)
        ball, scaling = ball.scaled(Fraction(scaling[0])), UNIT
    else:
        other = P

    def between_of(operand: SpaceOperand, within: Fraction) -> Between:
        return sum_between(operand, ball, within, scaling, cores(), told_of)

    _run("sum", request, other, ball, between_of)


def run_erode(request: ErodeWithBall) -> None:
    """The erosion of a polyhedron by a ball."""
    if is_ball(request.P):
        raise Refusal("a ball is what erodes", request.P, "give a polyhedron first")
    ball, scaling = read_ball(request.Q), request.scale

    def between_of(operand: SpaceOperand, within: Fraction) -> Between:
        return erosion_between(operand, ball, within, scaling, cores(), told_of)

    _run("erode", request, request.P, ball, between_of)


def _run(
    command: str, request: SumWithBall | ErodeWithBall, name: str, ball: Disc, between_of: Any
) -> None:
    watch, output = Stopwatch(), request.output
    within = request.tolerance
    if within is None:
        mend = "say how far polyhedra may be off, as --tolerance 1/100"
        raise Refusal("a ball is no polyhedron", ball.name, mend, "no-tolerance")
    if is_disc(name):
        raise Refusal("a disc lies in the plane", name, "give a polyhedron", "mixed-dimensions")
    target = target_of(output, request.form, SPACE_FORMATS, "off", request.json)
    for option, given in (("--triangles", request.triangles), ("--outside", request.outside)):
        if given and target is None:
            raise Refusal("there is nothing to write", option, "add -o FILE.off")
    with memory_wall(request.memory, f"the {command} with a ball", name, SIMPLER):
        operand = read_summand(name)
        if output is not None:
            refuse_overwriting(output, [operand.file])
        found = between_of(operand, within)
        chosen = found.outer if request.outside else found.inner
        mesh = mesh_of(chosen, request.triangles) if target is not None else None
        asked = {}
        if isinstance(request, SumWithBall):
            asked["at"] = placed_between(request.at, found.inner, found.outer)
        sets = {"inner": set_fields(found.inner), "outer": set_fields(found.outer)}
    exact = rounding = None
    warnings = list(operand.warnings)
    if target is not None and mesh is not None:
        text = refusing(target.name, lambda: _core.write_mesh(mesh, target.form))
        exact = _core.writes_mesh_exactly(mesh, target.form)
        if target.write(text, exact):
            return
        if target.form != "json":
            rounding = rounding_of(mesh, exact)
            warnings += beyond_doubles(mesh)
    value = document(
        command,
        watch,
        dimension=3,
        P=request.P if is_ball(request.P) else operand.name,
        Q=request.Q if is_ball(request.Q) else operand.name,
        scale=list(request.scale),
        warnings=warnings,
        output=str(output) if output else None,
        output_exact=exact,
        output_is=None if target is None else "outer" if request.outside else "inner",
        rounding=rounding,
        radius=ball.radius,
        squared_radius=str(ball.squared_radius),
        tolerance=str(within),
        components=_proven_components(command, sets),
        **asked,
        **sets,
    )
    give(value, request.json, lambda value: _print(value, request.scale))


def _proven_components(command: str, sets: dict[str, dict[str, Any]]) -> int | None:
    """Return the number that both sets have, which proves the number for a sum: each component of
    the sum contains a component of `inner`, and each component of `outer` one of the sum. None for
    an erosion."""
    inner, outer = (sets[name]["components"] for name in ("inner", "outer"))
    return inner if command == "sum" and inner == outer else None


def _print(value: dict[str, Any], scaling: Scaling) -> None:
    inner, outer = value["inner"], value["outer"]
    sign = "+" if value["command"] == "sum" else "less"
    scaled = "" if set(scaling) == {"1"} else f"{text_of(scaling)} "
    rows = [
        (value["command"], f"{scaled}{value['P']} {sign} {value['Q']}"),
        ("radius of the ball", value["radius"]),
        ("tolerance", value["tolerance"]),
        ("volume", enclosing(inner["volume"], outer["volume"])),
    ]
    rows += [(name, _in_words(value, name)) for name in COUNTS]
    rows += place_rows(value) if "at" in value else []
    rows += [
        (f"{name} set", f"{each['facets']:,} facets, digest {each['digest']}")
        for name, each in (("inner", inner), ("outer", outer))
    ]
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    written = written_row(value)
    if written:
        written = [("written", f"{written[0][1]}, the {value['output_is']} set")]
    print_lines(rows + written + rounding_rows(value), value)


def _in_words(value: dict[str, Any], name: str) -> str:
    inner, outer = value["inner"][name], value["outer"][name]
    if inner != outer:
        return f"undecided at this tolerance: {inner:,} of the inner set, {outer:,} of the outer"
    if name == "components" and value["components"] is not None:
        return f"{inner:,}"
    return f"{inner:,} of both sets"
