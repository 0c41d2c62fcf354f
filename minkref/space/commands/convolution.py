"""`minkref convolution` of convex polyhedra: the facets of the sum with their parents."""

from __future__ import annotations

import json as json_text
import sys
from collections import Counter
from dataclasses import replace
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.errors import Refusal, refusing
from minkref.output.documents import (
    Stopwatch,
    as_text,
    document,
    lasting,
    listing,
    refuse_overwriting,
)
from minkref.output.output_target import target_of
from minkref.output.terminal import escaped, lines
from minkref.space.commands.facet_files import WRITERS
from minkref.space.facets import KINDS, Facet, facets_of
from minkref.space.operand import SpaceOperand, read_space_operand
from minkref.space.scaling import text_of
from minkref.space.space_sum import SpaceSum
from minkref.space.sums import ROUTES, compute
from minkref.verbs.convolution import ConvolutionInSpace

OUTPUTS = ("json", *WRITERS)


def run(request: ConvolutionInSpace) -> None:
    """For convex operands nothing has to be culled: the convolution is the boundary of the sum."""
    watch = Stopwatch()
    P, Q, scaling, output = request.P, request.Q, request.scale, request.output
    json, triangles = request.json, request.triangles
    target = target_of(output, request.form, OUTPUTS, "json", json)
    if triangles and (target is None or target.form == "json"):
        raise Refusal("no mesh is written", "--triangles", "add -o FILE.off or .ply")
    with memory_wall(request.memory, "the convolution", f"{P} and {Q}", SIMPLER):
        first, second = read_space_operand(P), read_space_operand(Q)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
        answer = compute(first, second, scaling, ROUTES[0])
        facets = facets_of(answer)
        exact = None
        if target is not None:
            exact = target.form == "json" or _core.writes_mesh_exactly(answer.surface, target.form)
        counts = Counter(facet.kind for facet in facets)
        fields: dict[str, Any] = {
            "dimension": 3,
            "P": first.name,
            "Q": second.name,
            "scale": list(scaling),
            "warnings": first.warnings + second.warnings,
            "output": str(output) if output else None,
            "output_exact": exact,
            "compute_seconds": answer.seconds,
            "count": len(facets),
            "kinds": {kind: counts[kind] for kind in KINDS},
        }
        head = document("convolution", watch, **fields, **_shape(answer, first, second))
        if target is not None and target.form == "json":
            target.write_pieces(listing(lasting(head), "facets", map(_document, facets)))
        elif target is not None:
            write = WRITERS[target.form]
            mesh = _in_triangles(answer.surface, facets) if triangles else (answer.surface, facets)
            target.write_pieces([refusing(target.name, lambda: write(*mesh))])
            target.tell_rounding(bool(exact))
    if json and target is None:
        sys.stdout.writelines(listing(head, "facets", map(_document, facets)))
    elif json:
        sys.stdout.write(as_text({**head, "facets": None}))
    elif target is None or not target.is_standard_output:
        _print(head, text_of(scaling))


def _in_triangles(
    surface: _core.Polyhedron, facets: list[Facet]
) -> tuple[_core.Polyhedron, list[Facet]]:
    """Each triangle with the parents of its facet."""
    cut = [
        replace(facet, ring=list(triangle))
        for facet, triangles in zip(facets, surface.triangles(), strict=True)
        for triangle in triangles
    ]
    return _core.Polyhedron(surface.written_points(), [facet.ring for facet in cut]), cut


def _shape(answer: SpaceSum, P: SpaceOperand, Q: SpaceOperand) -> dict[str, Any]:
    return {
        "vertices": [list(point) for point in answer.surface.written_points()],
        "vertex_parents": answer.vertex_parents,
        "operands": {
            name: json_text.loads(operand.canonical().canonical_json())
            for name, operand in (("P", P), ("Q", Q))
        },
    }


def _document(facet: Facet) -> dict[str, Any]:
    return {"kind": facet.kind, "P": facet.P, "Q": facet.Q, "ring": facet.ring}


def _print(value: dict[str, Any], scaling: str) -> None:
    kinds = value["kinds"]
    rows = [
        ("convolution", f"{scaling} {value['P']} and {value['Q']}"),
        ("facets", f"{value['count']:,}"),
        *((f"  {kind}", f"{kinds[kind]:,}: {KINDS[kind]}") for kind in KINDS if kinds[kind]),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    if value["output"]:
        rounded = "" if value["output_exact"] else " (rounded; .json is exact)"
        rows.append(("written", value["output"] + rounded))
    sys.stdout.write(lines(rows))
    for warning in value["warnings"]:
        sys.stderr.write(f"warning: {escaped(warning)}\n")
