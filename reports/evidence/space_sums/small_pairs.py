"""Sums of polyhedra of any shape: routes, CGAL's Nef polyhedra, cells and the slow engine agree."""

from __future__ import annotations

import random
import time
from collections import Counter
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.judges.space.mesh_files import faults_of, read_as_written, sextuple_volume
from minkref.fuzz.judges.space.space_laws import LAWS
from minkref.fuzz.judges.space.space_nef import NefJudge
from minkref.fuzz.judges.space.space_routes import ROUTES, core_polyhedron, routes
from minkref.fuzz.judges.space.space_sums import SpaceSums
from minkref.fuzz.space.general_pairs import general_pair
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.2, 2, 36)

SEED = 2012
PAIRS = Counts(14, 300, 2000)
NEF_SECONDS = Counts(3.0, 10.0, 20.0)
POINTS = Counts(10, 20, 30)
EVERY_FOR_LAWS = Counts(5, 5, 3)  # one pair of so many; coprime to the 14 families

POLYCUBES = Counts(8, 200, 1500)
FORMS = ("off", "obj", "ply")

Task = tuple[int, Size]
_nef: dict[Size, NefJudge] = {}  # this process's judge, which ends with the process


def judge(task: Task) -> dict[str, Any]:
    """All answers on one pair, and for some pairs the laws, of each route."""
    index, size = task
    if size not in _nef:
        _nef[size] = NefJudge(size.of(NEF_SECONDS))
    since = time.perf_counter()
    sums = SpaceSums(general_pair(SEED, index))
    known = routes()
    sums.ask(known, _nef[size])
    sums.compare(size.of(POINTS))
    laws: Counter[str] = Counter()
    every = size.of(EVERY_FOR_LAWS)
    if index % every == 0 or sums.pair.parts:
        for name, route in known.items():
            for law, check in LAWS.items() if name in sums.answers else ():
                dice = random.Random(f"minkref laws {sums.pair.name} {law}")
                for held in check(sums.pair, route, sums.answers[name], dice):
                    laws[law] += 1
                    if not held:
                        sums.say(f"route {name} breaks the law of {law}")
    pair = sums.pair
    factor = str(pair.scale)
    found = _core.edge_sum_in_space(
        core_polyhedron(pair.P), core_polyhedron(pair.Q), (factor, factor, factor)
    )
    for fault in triangle_faults(found):
        sums.say(f"as triangles: {fault}")
    seconds = round(time.perf_counter() - since, 2)
    thin = sums.pair.P.is_thin or sums.pair.Q.is_thin
    return {
        "name": sums.pair.name,
        "asked nef": not thin,
        "answers": list(sums.answers),
        "compared": sums.compared,
        "laws": laws,
        "messages": sums.messages,
        "seconds": seconds,
    }


def triangle_faults(found: _core.PolyhedralSet) -> list[str]:
    """Faults of the triangle mesh, for each format. An exactly written mesh must also enclose the
    set's volume."""
    surface = found.mesh("triangles")
    faults = []
    for form in FORMS:
        mesh = read_as_written(_core.write_mesh(surface, form), form)
        exact = _core.writes_mesh_exactly(surface, form)
        told = faults_of(mesh)
        faults += [f"{form}: {one}" for one in told if exact or "area" not in one]
        if exact and sextuple_volume(mesh) != 6 * Fraction(found.volume()):
            faults.append(f"{form}: another volume")
    surface.validate()
    if _core.polyhedral_set(surface) != found:
        faults.append("another set")
    return faults


def polycube_faults(index: int) -> list[str]:
    """Faults of a sum with random cells, which touch along edges and at vertices."""
    dice = random.Random(f"minkref polycube {SEED} {index}")
    share = dice.choice((0.3, 0.5, 0.7))
    cells = [(x, y, z) for x in range(3) for y in range(3) for z in range(3)
             if dice.random() < share] or [(0, 0, 0)]  # fmt: skip
    cube = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    rings = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    points = [
        tuple(2 * c + d for c, d in zip(cell, corner, strict=True))
        for cell in cells
        for corner in cube
    ]
    faces = [[8 * k + v for v in ring] for k in range(len(cells)) for ring in rings]
    P, Q = _core.Polyhedron(points, faces), _core.Polyhedron(cube, [list(ring) for ring in rings])
    try:
        return triangle_faults(_core.edge_sum_in_space(P, Q, ("1", "1", "1")))
    except (ValueError, RuntimeError) as error:
        return [f"{sorted(cells)}: {error}"]


def run(findings: Findings, size: Size) -> None:
    count = size.of(PAIRS)
    answers: Counter[str] = Counter()
    points = asked = 0
    laws: Counter[str] = Counter()
    messages: list[str] = []
    slowest: tuple[float, str] = (0.0, "")
    tasks = [(index, size) for index in range(count)]
    for row in in_processes(judge, tasks, each=max(1, count // 20), what="pairs"):
        answers.update(row["answers"])
        laws.update(row["laws"])
        points += row["compared"]["points"]
        asked += row["asked nef"]
        messages += row["messages"]
        slowest = max(slowest, (row["seconds"], row["name"]))
        for message in row["messages"]:
            print(message, flush=True)
    findings.equal("routes in the module", ", ".join(ROUTES), ", ".join(routes()))
    findings.none("disagreements", messages)
    for name in routes():
        findings.equal(f"sums by route {name}", count, answers[name])
    for name in ("cells", "slow engine"):
        findings.law(f"sums by the {name}", answers[name] > 0, "some", f"{answers[name]:,}")
    wanted = asked * 9 // 10
    findings.target("Nef's answers in time", answers["nef"] >= wanted, wanted, answers["nef"])
    findings.law("points asked", points > 0, "some", f"{points:,}")
    for law in LAWS if routes() else ():
        findings.law(f"law of {law}", laws[law] > 0, "tried", f"{laws[law]:,}")
    polycubes = size.of(POLYCUBES)
    faults = [
        fault
        for row in in_processes(
            polycube_faults, range(polycubes), each=max(1, polycubes // 20), what="polycubes"
        )
        for fault in row
    ]
    findings.none(f"faults of {polycubes:,} polycubes as triangles", faults)
    findings.note(f"seed {SEED}; slowest: {slowest[1]}, {slowest[0]} s")
    findings.figures = {
        "pairs": count,
        "answers": dict(answers),
        "points": points,
        "polycubes": polycubes,
        "laws": dict(laws),
        "disagreements": messages[:20],
    }
