"""`minkref sweep` of convex polyhedra: each sum got from the one before."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import plain_table
from minkref.cli.progress import progress
from minkref.cli.row_spool import Row, RowSpool
from minkref.errors import Refusal, refusing
from minkref.exact import rounded
from minkref.output.documents import Stopwatch, document, listing
from minkref.output.signals import ending_in_order
from minkref.output.terminal import counted, escaped
from minkref.plane.commands.sweep_folder import SPACE_FORMATS, sweep_folder
from minkref.plane.commands.sweep_rows import SHOWN, Setting, print_sweep, sweep_rows, write_index
from minkref.space.commands.paper_repair import RepairWalk, print_repair
from minkref.space.commands.paper_sweep import paper_sweep
from minkref.space.operand import SpaceOperand, read_space_operand
from minkref.space.scaling import Scaling, read_scalings, text_of
from minkref.space.space_sum import SpaceSum
from minkref.space.sums import compute, sum_fields, timed
from minkref.verbs.repair_options import asked_repair
from minkref.verbs.sweep import SCALINGS, SweepInSpace

SPACE = Setting[Scaling, _core.Polyhedron](
    lambda scaling: escaped(text_of(scaling))[:30], _core.write_mesh, _core.writes_mesh_exactly
)
IN_TRIANGLES = Setting[Scaling, _core.Polyhedron](
    SPACE.told,
    lambda mesh, form: _core.write_mesh(mesh.cut_into_triangles(), form),
    lambda mesh, form: _core.writes_mesh_exactly(mesh.cut_into_triangles(), form),
)
COUNTS = ("fv_errors", "vf_errors", "ee_errors", "descent_steps", "chains_walked")


def run(request: SweepInSpace) -> None:
    if request.route is not None:
        paper_sweep(request)
        return
    watch = Stopwatch()
    P, Q, output, triangles = request.P, request.Q, request.output, request.triangles
    repair = asked_repair(
        request.repair, request.arithmetic, request.as_read, request.reading, request.trace
    )
    if request.scales_file is None:
        raise Refusal("the scales are not given", "minkref sweep", SCALINGS)
    scalings = read_scalings(request.scales_file)
    folder = sweep_folder(output, request.form, SPACE_FORMATS, "in space: ")
    if triangles and folder is None:
        raise Refusal("there is nothing to write", "--triangles", "add -o DIR")
    first, second = read_space_operand(P), read_space_operand(Q)
    if folder is not None:
        folder.refuse_overwriting([first.file, second.file])
    wall = memory_wall(request.memory, "the update", f"{P} and {Q}", SIMPLER)
    with wall, ending_in_order(), progress(len(scalings)) as line:
        start = time.perf_counter()
        step = (
            _steps(first, second, scalings[0])
            if repair is None
            else RepairWalk(first, second, scalings[0], repair).row
        )
        first_seconds = time.perf_counter() - start
        rows = sweep_rows(scalings, step, IN_TRIANGLES if triangles else SPACE, folder, line)
        value = document(
            "sweep",
            watch,
            dimension=3,
            P=first.name,
            Q=second.name,
            warnings=first.warnings + second.warnings,
            output=str(output) if output else None,
            format=folder.form if folder else None,
            preprocessing_seconds=first_seconds,
            **({} if repair is None else repair.fields()),
        )
        write_index(folder, value, rows)
    if request.json:
        sys.stdout.writelines(listing(value, "rows", rows))
    elif repair is not None:
        print_repair(value, rows)
    else:
        _print(value, rows)


def _steps(
    P: SpaceOperand, Q: SpaceOperand, first: Scaling
) -> Callable[[Scaling], tuple[Row, _core.Polyhedron]]:
    """The maker of the rows. Beside the empty set, a point or a segment there is nothing to update:
    all counts are 0."""
    where = f"{P.name} and {Q.name}"
    if P.body is None or Q.body is None:
        nothing = dict.fromkeys(COUNTS, 0) | {"seconds": 0.0}
        return lambda scaling: _row(scaling, nothing, compute(P, Q, scaling, "traversal"))
    operands = P.body, Q.body
    moving = refusing(where, lambda: _core.DynamicConvexSum(*operands, first))

    def step(scaling: Scaling) -> tuple[Row, _core.Polyhedron]:
        did = dict(refusing(where, lambda: moving.update(scaling)))
        return _row(scaling, did, timed(where, moving.sum))

    return step


def _row(scaling: Scaling, did: dict[str, Any], answer: SpaceSum) -> tuple[Row, _core.Polyhedron]:
    row: Row = {
        "scale": list(scaling),
        **sum_fields(answer),
        **{name: did[name] for name in COUNTS},
        "update_seconds": did["seconds"],
        "sum_seconds": answer.seconds,
    }
    return row, answer.surface


def _print(value: dict[str, Any], rows: RowSpool) -> None:
    headings = ("scale", "volume", "vertices", "facets", "fv", "vf", "ee", "steps", "chains",
                "update µs", "sum ms")  # fmt: skip
    table = plain_table(*headings, right=headings, whole=True)
    for row in rows.first(SHOWN):
        table.add_row(
            text_of((row["scale"][0], row["scale"][1], row["scale"][2])),
            rounded(row["volume"], 8),
            f"{row['vertices']:,}",
            f"{row['facets']:,}",
            *(f"{row[name]:,}" for name in COUNTS),
            f"{row['update_seconds'] * 1e6:,.1f}",
            f"{row['sum_seconds'] * 1000:,.2f}",
        )
    summary = [
        ("sweep", f"{value['P']} + {value['Q']}, {counted(len(rows), 'scaling')}"),
        ("fv, vf, ee", "facets of P and Q whose vertex changed, pairs of edges that are no more"),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_sweep(table, rows, summary, value)
