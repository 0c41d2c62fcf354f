"""`minkref sum` of polyhedra."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, measure, print_lines, written_row
from minkref.cli.progress import told_of
from minkref.cli.readings import ROUTE as PAPER_UPDATE
from minkref.errors import Refusal, choice, refusing
from minkref.output.documents import Stopwatch, document, refuse_overwriting
from minkref.output.output_target import target_of
from minkref.plane.commands.scale_index import cores
from minkref.plane.commands.sweep_folder import SPACE_FORMATS
from minkref.plane.place import place_rows, placed
from minkref.space.commands.paper_update import (
    SpaceWalk,
    answer_rows,
    asked_readings,
    refuse_axes,
    refuse_output,
)
from minkref.space.commands.rounding import beyond_doubles, rounding_of, rounding_rows
from minkref.space.commands.sum_document import of_convex_sum, of_general_sum
from minkref.space.general_sum import GENERAL_ROUTES, chosen_space_route, general_sum
from minkref.space.operand import SpaceOperand, read_summand
from minkref.space.scaling import Scaling, text_of
from minkref.space.sums import ROUTES, compute
from minkref.space.tight_passages import NONE, tight_passages
from minkref.verbs.sum import SumInSpace

ALL_ROUTES = (*ROUTES, *GENERAL_ROUTES, PAPER_UPDATE)


def run(request: SumInSpace) -> None:
    watch = Stopwatch()
    P, Q, scaling, output = request.P, request.Q, request.scale, request.output
    wanted = _checked_route(request.route)
    readings = asked_readings(wanted, request.arithmetic, request.as_read, request.reading)
    if readings is not None:
        refuse_axes(scaling)
        refuse_output(output)
    target = target_of(output, request.form, SPACE_FORMATS, "off", request.json)
    if request.triangles and target is None:
        raise Refusal("there is nothing to write", "--triangles", "add -o FILE.off")
    work = "the sum" if wanted is None else f"route {wanted}"
    instead = f"{SIMPLER}, or the route edges" if wanted == "definition" else SIMPLER
    with memory_wall(request.memory, work, f"{P} and {Q}", instead):
        first, second = read_summand(P), read_summand(Q)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
        exact_route = None if readings is not None else wanted
        chosen = chosen_space_route(first, second, exact_route, ROUTES)
        paper = None if readings is None else _paper(first, second, request, readings)
        mesh, whole, fields = summed(first, second, scaling, chosen)
        tight = _passages(first, second, scaling, chosen, request.passages)
        at = placed(request.at, whole()) if request.at is not None else None
    exact = rounding = None
    warnings = first.warnings + second.warnings
    if target is not None:
        surface = mesh(request.triangles)
        text = refusing(target.name, lambda: _core.write_mesh(surface, target.form))
        exact = _core.writes_mesh_exactly(surface, target.form)
        if target.write(text, exact):
            return
        if target.form != "json":
            rounding = rounding_of(surface, exact)
            warnings += beyond_doubles(surface)
    value = document(
        "sum",
        watch,
        dimension=3,
        P=first.name,
        Q=second.name,
        scale=list(scaling),
        warnings=warnings,
        output=str(output) if output else None,
        output_exact=exact,
        rounding=rounding,
        at=at,
        route=chosen if paper is None else PAPER_UPDATE,
        paper=paper,
        **fields,
        tight_passages=tight,
        passages_complete=tight is not None,
    )
    give(value, request.json, lambda value: _print(value, text_of(scaling)))


def summed(
    P: SpaceOperand, Q: SpaceOperand, scaling: Scaling, route: str
) -> tuple[Callable[[bool], _core.Polyhedron], Callable[[], _core.PolyhedralSet], dict[str, Any]]:
    """The maker of the mesh that is written, of triangles or not; that of the set; and the
    document's fields of the sum."""
    if route in ROUTES or 0 in (P.surface.vertices, Q.surface.vertices):
        answer = compute(P, Q, scaling, route)
        surface = answer.surface
        return (
            lambda triangles: surface.cut_into_triangles() if triangles else surface,
            lambda: _core.PolyhedralSet(surface),
            of_convex_sum(answer, P, Q),
        )
    with told_of(f"route {route}") as tell:
        found = general_sum(P, Q, scaling, route, cores(), tell)
    return found.mesh, lambda: found.set, of_general_sum(found, P, Q)


def _passages(
    P: SpaceOperand, Q: SpaceOperand, scaling: Scaling, route: str, wanted: bool
) -> dict[str, Any] | None:
    """Convex operands have none. None where they were not looked for."""
    if route in ROUTES or 0 in (P.surface.vertices, Q.surface.vertices):
        return NONE
    return tight_passages(P, Q, scaling) if wanted else None


def _paper(
    P: SpaceOperand, Q: SpaceOperand, request: SumInSpace, readings: dict[str, str]
) -> dict[str, Any]:
    """What the paper's own program answers."""
    walk = SpaceWalk(P, Q, request.scale[0], request.arithmetic, readings)
    return {
        "arithmetic": request.arithmetic,
        "readings": readings,
        **walk.preparation(),
        **walk.answer(),
    }


def _checked_route(route: str | None) -> str | None:
    """None leaves the choice to the operands."""
    if route is not None and route not in ALL_ROUTES:
        mend = f"leave it out, or in space: {choice(route, ALL_ROUTES)}"
        raise Refusal(f"there is no route {route!r} in space", "--route", mend)
    return route


def _print(value: dict[str, Any], scaling: str) -> None:
    paper = value["paper"]
    rows = [("sum", f"{scaling} {value['P']} + {value['Q']}")]
    if paper is not None:
        rows += [("route, arithmetic", f"{value['route']}, {paper['arithmetic']}")]
        rows += [*answer_rows(paper), ("exact", "")]
    else:
        rows.append(("route", f"{value['route']}, exact"))
    rows += [
        ("volume", measure(value["volume"])),
        ("vertices, edges, facets",
         f"{value['vertices']:,}, {value['edges']:,}, {value['facets']:,}"),
    ]  # fmt: skip
    if not value["convex"]:
        shape = f"{value['components']:,}, {value['cavities']:,}, {value['tunnels']:,}"
        rows.append(("components, cavities, tunnels", shape))
    if value["passages_complete"] and value["route"] in GENERAL_ROUTES:
        found = value["tight_passages"]
        counts = ", ".join(f"{len(found[name]):,}" for name in ("sheets", "lines", "points"))
        rows.append(("tight sheets, lines, points", counts))
    rows += place_rows(value)
    if value["signs"]:
        total, shares = value["signs"]["total"], value["signs"]["shares"]
        told = ", ".join(f"{share:.2%} {name.replace('_', ' ')}" for name, share in shares.items())
        rows.append(("signs", f"{total:,}: {told}"))
    rows += [("digest", value["digest"]), ("seconds", f"{value['seconds']:.3f}")]
    rows += written_row(value) + rounding_rows(value)
    print_lines(rows, value)
