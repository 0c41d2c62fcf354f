"""`minkref sweep` of polyhedra by the paper's own program, with the exact sums beside it."""

from __future__ import annotations

import sys

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.progress import progress, told_on
from minkref.cli.readings import ROUTE
from minkref.errors import Refusal
from minkref.output.documents import Stopwatch, document, listing
from minkref.output.signals import ending_in_order
from minkref.output.terminal import escaped
from minkref.plane.commands.sweep_rows import Setting, sweep_rows
from minkref.space.commands.paper_update import (
    SpaceWalk,
    asked_readings,
    print_sweep_rows,
    refuse_axes,
    refuse_output,
)
from minkref.space.operand import read_summand
from minkref.space.scaling import Scaling, read_scalings, text_of
from minkref.verbs.sweep import SCALINGS, SweepInSpace

UNWRITTEN = Setting[Scaling, _core.Polyhedron](
    lambda scaling: escaped(text_of(scaling))[:30], _core.write_mesh, _core.writes_mesh_exactly
)


def paper_sweep(request: SweepInSpace) -> None:
    watch = Stopwatch()
    readings = _readings(request)
    if request.scales_file is None:
        raise Refusal("the scales are not given", "minkref sweep", SCALINGS)
    scalings = read_scalings(request.scales_file)
    for scaling in scalings:
        refuse_axes(scaling)
    first, second = read_summand(request.P), read_summand(request.Q)
    wall = memory_wall(request.memory, f"route {ROUTE}", f"{request.P} and {request.Q}", SIMPLER)
    with wall, ending_in_order(), progress(len(scalings)) as line:
        walk = SpaceWalk(first, second, scalings[0][0], request.arithmetic, readings, told_on(line))
        rows = sweep_rows(scalings, walk.row, UNWRITTEN, None, line)
        value = document(
            "sweep",
            watch,
            dimension=3,
            P=first.name,
            Q=second.name,
            warnings=first.warnings + second.warnings,
            output=None,
            format=None,
            route=ROUTE,
            arithmetic=request.arithmetic,
            readings=readings,
            **walk.preparation(),
        )
    if request.json:
        sys.stdout.writelines(listing(value, "rows", rows))
    else:
        print_sweep_rows(value, rows)


def _readings(request: SweepInSpace) -> dict[str, str]:
    """Refuses other routes, and options that this one does not have."""
    route = request.route
    if route != ROUTE:
        mend = f"leave it out, or in space: {ROUTE}"
        raise Refusal(f"there is no route {route!r} in space", "--route", mend)
    refuse_output(request.output)
    others = {
        "--repair": request.repair is not None,
        "--trace": request.trace,
        "--format": request.form is not None,
        "--triangles": request.triangles,
    }
    for option, given in others.items():
        if given:
            mend = f"leave it out, or leave out --route {ROUTE}"
            raise Refusal(f"the route {ROUTE} has no such option", option, mend)
    return asked_readings(route, request.arithmetic, request.as_read, request.reading) or {}
