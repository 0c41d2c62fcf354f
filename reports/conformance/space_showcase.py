"""Sums of arbitrary polyhedra for the front page: from both routes of the reference and CGAL's Nef
polyhedra, compared as text, with pictures."""

from __future__ import annotations

import random
import time
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.space.space_nef import NEF, NefJudge
from minkref.fuzz.judges.space.space_planes import planes_of_solid, planes_of_text
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.generators.machined import cup, plate, prism_over, u_solid
from minkref.fuzz.space.generators.round import geodesic_sphere, triangulated_torus
from minkref.fuzz.space.generators.tube import knot_tube
from minkref.fuzz.space.generators.workshop import hollow_block, rounded_bracket, spur_gear
from minkref.output.terminal import counted
from minkref.reports.conformance.showcase import Showcase
from minkref.reports.conformance.solid_view import solid_view

NEF_SECONDS = 10.0
EDGES, DEFINITION = "edges", "definition"
Solids = tuple[Polyhedron, Polyhedron]
ROUTES: dict[str, Callable[[_core.Polyhedron, _core.Polyhedron], _core.PolyhedralSet]] = {
    EDGES: lambda P, Q: _core.edge_sum_in_space(P, Q, ("1", "1", "1")),
    DEFINITION: lambda P, Q: _core.definition_sum_in_space(P, Q, ("1", "1", "1")),
}


@dataclass(frozen=True)
class SpaceShowcase(Showcase):
    """`seconds` for each source, None without a sum. `differ` lists sources whose sum differs from
    the route edges."""

    seconds: dict[str, float | None]
    differ: list[str]


def _l(size: int) -> Polyhedron:
    outline = [(0, 0), (3 * size, 0), (3 * size, size), (size, size), (size, 3 * size)]
    return prism_over([*outline, (0, 3 * size)], [], 0, size)


def _dice() -> random.Random:
    return random.Random("minkref shown")


PAIRS: dict[str, Callable[[], Solids]] = {
    "trefoil + icosahedron": lambda: (knot_tube(_dice(), 2, 3, 14, 3, 100), geodesic_sphere(0, 30)),
    "gear + U": lambda: (spur_gear(6, 30, 10, 6), u_solid(_dice(), 4, 3)),
    "torus + L": lambda: (triangulated_torus(6, 4, 60, 20), _l(8)),
    "bracket with bores + pin": lambda: (rounded_bracket(6, 2, 60), plate(8, 8, 20)),
    "cup + L": lambda: (cup(12, 12, 9, (3, 3, 3, 3), 3), _l(2)),
    "cube minus a sphere + block": lambda: (hollow_block(0, 60), plate(30, 20, 10)),
}


def space_showcases() -> list[SpaceShowcase]:
    """Showcases, made in a few seconds; slow Nef polyhedra give no sum."""
    with NefJudge(NEF_SECONDS) as nef:
        return [_shown(title, *make(), nef) for title, make in PAIRS.items()]


def told(shown: list[SpaceShowcase]) -> str:
    """A line with the number of sums, their sources, and whether all are the same."""
    seconds = sum(each for show in shown for each in show.seconds.values() if each is not None)
    names = [name for name in (EDGES, DEFINITION, NEF) if any(show.seconds[name] for show in shown)]
    line = f"in space, polyhedra of any shape: {counted(len(shown), 'sum')} by {', '.join(names)}"
    differ = [show.title for show in shown if show.differ]
    what = f"NOT the same of {'; '.join(differ)}" if differ else "all the same"
    return f"{line}: {what}, plane by plane ({seconds:.1f} s)"


def _shown(title: str, P: Polyhedron, Q: Polyhedron, nef: NefJudge) -> SpaceShowcase:
    first, second = core_polyhedron(P), core_polyhedron(Q)
    texts: dict[str, str] = {}
    seconds: dict[str, float | None] = {}
    volume = ""
    for name, route in ROUTES.items():
        start = time.perf_counter()
        found = route(first, second)
        seconds[name] = time.perf_counter() - start
        texts[name] = found.canonical_json()
        volume = volume or found.volume()
    answer = nef.timed_sum(P, Q)
    seconds[NEF] = answer.seconds
    if answer.text is not None:
        texts[NEF] = answer.text
    differ = [name for name, text in texts.items() if text != texts[EDGES]]
    planes = planes_of_text(texts[EDGES])
    took = ", ".join(
        f"{name} {'gives none' if spent is None else f'{spent:.3f} s'}"
        for name, spent in seconds.items()
    )
    verdict = f"{' and '.join(differ)} differ from {EDGES}" if differ else "all the same"
    text = (
        f"{len(P.triangles):,} and {len(Q.triangles):,} triangles; faces of the sum in "
        f"{len(planes):,} planes, volume {float(Fraction(volume)):,.6g}; {took}: {verdict}."
    )
    pictures = [
        (caption, solid_view(solid, style, caption))
        for caption, solid, style in (
            ("P", planes_of_solid(P), "first"),
            ("Q", planes_of_solid(Q), "second"),
            (title, planes, "sum"),
        )
    ]
    return SpaceShowcase(title, text, pictures, seconds, differ)
