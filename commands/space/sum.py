"""`minkref sum` of convex polyhedra."""

from __future__ import annotations

import json as json_text
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.commands.line.memory import SIMPLER, memory_wall
from minkref.commands.line.output import give, measure, print_lines, written_row
from minkref.commands.lists.sweep_folder import SPACE_FORMATS
from minkref.documents import Stopwatch, document, refuse_overwriting
from minkref.errors import Refusal, choice, refusing
from minkref.output_target import target_of
from minkref.space.operand import read_space_operand
from minkref.space.scaling import read_scaling, text_of
from minkref.space.sums import ROUTES, compute, sum_fields


def sum_in_space(
    P: str,
    Q: str,
    scale: str,
    route: str,
    arithmetic: str,
    output: Path | None,
    json: bool,
    form: str | None = None,
    memory: int | None = None,
) -> None:
    """The command, its options read but not yet checked."""
    watch = Stopwatch()
    scaling = read_scaling(scale)
    route = _checked_route(route, arithmetic)
    target = target_of(output, form, SPACE_FORMATS, "off", json)
    with memory_wall(memory, f"route {route}", f"{P} and {Q}", SIMPLER):
        first, second = read_space_operand(P), read_space_operand(Q)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
        answer = compute(first, second, scaling, route)
    exact = None
    if target is not None:
        text = refusing(target.name, lambda: _core.write_mesh(answer.surface, target.form))
        exact = _core.writes_mesh_exactly(answer.surface, target.form)
        if target.write(text, exact):
            return
    value = document(
        "sum",
        watch,
        dimension=3,
        P=first.name,
        Q=second.name,
        scale=list(scaling),
        warnings=first.warnings + second.warnings,
        output=str(output) if output else None,
        output_exact=exact,
        route=route,
        compute_seconds=answer.seconds,
        **sum_fields(answer),
        result=json_text.loads(answer.surface.canonical_json()),
        vertex_parents=answer.vertex_parents,
        facet_parents=[{"P": list(p), "Q": list(q)} for p, q in answer.facet_parents],
        operands={
            name: json_text.loads(operand.canonical().canonical_json())
            for name, operand in (("P", first), ("Q", second))
        },
    )
    give(value, json, lambda value: _print(value, text_of(scaling)))


def _checked_route(route: str, arithmetic: str) -> str:
    """`paper`, the default, is the traversal of the Gaussian maps: there is nothing to cull."""
    if arithmetic != "rational":
        raise Refusal(
            "sums in space are exact only", f"--arithmetic {arithmetic}", "leave the option out"
        )
    chosen = "traversal" if route == "paper" else route
    if chosen not in ROUTES:
        mend = f"in space: {choice(route, ROUTES)}"
        raise Refusal(f"there is no route {route!r} in space", "--route", mend)
    return chosen


def _print(value: dict[str, Any], scaling: str) -> None:
    rows = [
        ("sum", f"{scaling} {value['P']} + {value['Q']}"),
        ("route", f"{value['route']}, exact"),
        ("volume", measure(value["volume"], value["volume_approximate"])),
        ("vertices, edges, facets",
         f"{value['vertices']:,}, {value['edges']:,}, {value['facets']:,}"),
        ("digest", value["digest"]),
        ("seconds", f"{value['seconds']:.3f}"),
    ]  # fmt: skip
    rows += written_row(value)
    print_lines(rows, value)
