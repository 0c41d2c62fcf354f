"""`minkref erode` of polyhedra."""

from __future__ import annotations

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
from minkref.space.eroded import cavities, negated, outside_of, room
from minkref.space.general_sum import general_sum
from minkref.space.operand import SpaceOperand, read_summand
from minkref.space.scaling import Scaling, text_of
from minkref.space.tight_passages import NONE, tight_passages
from minkref.verbs.erode_request import SPACE_ROUTES, ErodeInSpace


def run(request: ErodeInSpace) -> None:
    watch = Stopwatch()
    P, Q, scaling, output = request.P, request.Q, request.scale, request.output
    route = request.route or SPACE_ROUTES[0]
    if route not in SPACE_ROUTES:
        mend = f"in space: {choice(route, SPACE_ROUTES)}"
        raise Refusal(f"there is no route {route!r} of an erosion in space", "--route", mend)
    target = target_of(output, request.form, SPACE_FORMATS, "off", request.json)
    if request.triangles and target is None:
        raise Refusal("there is nothing to write", "--triangles", "add -o FILE.off")
    with memory_wall(request.memory, f"route {route}", f"{P} and {Q}", SIMPLER):
        first, second = read_summand(P), read_summand(Q)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
        found, seconds, remnants = eroded(first, second, scaling, route, request.passages)
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
        "erode",
        watch,
        dimension=3,
        P=first.name,
        Q=second.name,
        scale=list(scaling),
        warnings=warnings,
        output=str(output) if output else None,
        output_exact=exact,
        rounding=rounding,
        route=route,
        compute_seconds=seconds,
        **fields,
        remnants=remnants,
    )
    give(value, request.json, lambda value: _print(value, text_of(scaling)))


def eroded(
    P: SpaceOperand, Q: SpaceOperand, scaling: Scaling, route: str, passages: bool
) -> tuple[_core.PolyhedralSet, float, dict[str, Any] | None]:
    """Erode: the set, its sum's seconds, and remnants if wanted or known to be none."""
    if Q.surface.vertices == 0:
        what = "Q is empty, so that every place is in the erosion"
        mend = "give a polyhedron, a plane polygon, a segment or a point"
        raise Refusal(what, Q.name, mend, "empty-operand")
    if P.surface.vertices == 0:
        return _core.PolyhedralSet(P.surface), 0.0, NONE
    outside, turned, places = outside_of(P), negated(Q), room(P, Q, scaling)
    if places.is_empty:
        return _core.PolyhedralSet(_core.Polyhedron([], [])), 0.0, NONE
    with told_of(f"route {route}") as tell:
        summed = general_sum(outside, turned, scaling, route, cores(), tell)
    tight = tight_passages(outside, turned, scaling) if passages else None
    return cavities(summed.set, places), summed.seconds, tight


def _print(value: dict[str, Any], scaling: str) -> None:
    rows = [
        ("erode", f"{scaling} {value['P']} less {value['Q']}"),
        ("route", f"{value['route']}, exact"),
        ("volume", measure(value["volume"])),
        ("vertices, edges, facets",
         f"{value['vertices']:,}, {value['edges']:,}, {value['facets']:,}"),
        ("components, cavities, tunnels",
         f"{value['components']:,}, {value['cavities']:,}, {value['tunnels']:,}"),
    ]  # fmt: skip
    found = value["remnants"]
    told = "not looked for; --passages finds them"
    if found is not None:
        told = ", ".join(f"{len(found[name]):,} {name}" for name in ("sheets", "lines", "points"))
    rows += [("remnants", told), ("digest", value["digest"])]
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows + written_row(value) + rounding_rows(value), value)
