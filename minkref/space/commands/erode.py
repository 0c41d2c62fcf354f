"""`minkref erode`, `opening`, `closing`, `nofit` and `innerfit` of polyhedra."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, measure, print_lines, written_row
from minkref.cli.progress import told_of
from minkref.errors import Refusal, choice, refusing
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.commands.scale_index import cores
from minkref.plane.commands.sweep_folder import SPACE_FORMATS
from minkref.space.commands.rounding import beyond_doubles, rounding_of, rounding_rows
from minkref.space.commands.set_fields import mesh_of, set_fields
from minkref.space.operand import read_summand
from minkref.space.remaining import Find, closed, eroded, no_fit, opened
from minkref.space.scaling import text_of
from minkref.verbs.erode_request import SPACE_ROUTES, ErodeInSpace, InnerFitInSpace, NoFitInSpace


@dataclass(frozen=True)
class Question:
    """A command's question. `operands`: both document fields; `fits`: the field for exact fits;
    `told`: a phrase for people."""

    command: str
    operands: tuple[str, str]
    fits: str
    told: str
    find: Find


def run(request: ErodeInSpace) -> None:
    asked = Question("erode", ("P", "Q"), "remnants", "{0} less {1}", eroded)
    _answer(asked, request.P, request.Q, request)


def run_opening(request: ErodeInSpace) -> None:
    asked = Question("opening", ("P", "Q"), "exact_fits", "{0} by {1}", opened)
    _answer(asked, request.P, request.Q, request)


def run_closing(request: ErodeInSpace) -> None:
    asked = Question("closing", ("P", "Q"), "remnants", "{0} by {1}", closed)
    _answer(asked, request.P, request.Q, request)


def run_nofit(request: NoFitInSpace) -> None:
    asked = Question("nofit", ("A", "B"), "exact_fits", "{0} and {1}", no_fit)
    _answer(asked, request.A, request.B, request)


def run_innerfit(request: InnerFitInSpace) -> None:
    keys = ("container", "part")
    asked = Question("innerfit", keys, "exact_fits", "{1} in {0}", eroded)
    _answer(asked, request.container, request.part, request)


def _answer(
    asked: Question, P: str, Q: str, request: ErodeInSpace | NoFitInSpace | InnerFitInSpace
) -> None:
    watch = Stopwatch()
    scaling, output = request.scale, request.output
    route = request.route or SPACE_ROUTES[0]
    if route not in SPACE_ROUTES:
        mend = f"in space: {choice(route, SPACE_ROUTES)}"
        raise Refusal(f"there is no route {route!r} in space", "--route", mend)
    target = target_of(output, request.form, SPACE_FORMATS, "off", request.json)
    if request.triangles and target is None:
        raise Refusal("there is nothing to write", "--triangles", "add -o FILE.off")
    with memory_wall(request.memory, f"route {route}", f"{P} and {Q}", SIMPLER):
        first, second = read_summand(P), read_summand(Q)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
        found, seconds, fits = asked.find(
            first, second, scaling, route, request.passages, cores(), told_of
        )
        mesh = mesh_of(found, request.triangles)
        fields = set_fields(found)
    exact = rounding = None
    warnings = first.warnings + second.warnings
    if target is not None:
        text = refusing(target.name, lambda: _core.write_mesh(mesh, target.form))
        exact = _core.writes_mesh_exactly(mesh, target.form)
        if target.write(text, exact):
            return
        if target.form != "json":
            rounding = rounding_of(mesh, exact)
            warnings += beyond_doubles(mesh)
    value = document(
        asked.command,
        watch,
        dimension=3,
        **dict(zip(asked.operands, (first.name, second.name), strict=True)),
        scale=list(scaling),
        warnings=warnings,
        output=str(output) if output else None,
        output_exact=exact,
        rounding=rounding,
        route=route,
        compute_seconds=seconds,
        **fields,
        **{asked.fits: fits},
    )
    give(value, request.json, lambda value: _print(asked, value, text_of(scaling)))


def _print(asked: Question, value: dict[str, Any], scaling: str) -> None:
    first, second = (value[key] for key in asked.operands)
    rows = [
        (asked.command, asked.told.format(f"{scaling} {first}", second)),
        ("route", f"{value['route']}, exact"),
        ("volume", measure(value["volume"])),
        ("vertices, edges, facets",
         f"{value['vertices']:,}, {value['edges']:,}, {value['facets']:,}"),
        ("components, cavities, tunnels",
         f"{value['components']:,}, {value['cavities']:,}, {value['tunnels']:,}"),
    ]  # fmt: skip
    found = value[asked.fits]
    told = "not looked for; --passages finds them"
    if found is not None:
        told = ", ".join(f"{len(found[name]):,} {name}" for name in ("sheets", "lines", "points"))
    rows += [(asked.fits.replace("_", " "), told), ("digest", value["digest"])]
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows + written_row(value) + rounding_rows(value), value)
