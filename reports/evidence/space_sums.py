"""Sums of polyhedra of any shape: routes, CGAL's Nef polyhedra, cells and the slow engine agree."""

from __future__ import annotations

import random
import time
from collections import Counter
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.fuzz.judges.mesh_files import faults_of, read_as_written, sextuple_volume
from minkref.fuzz.judges.space_laws import LAWS
from minkref.fuzz.judges.space_nef import NefJudge
from minkref.fuzz.judges.space_routes import ROUTES, core_polyhedron, routes
from minkref.fuzz.judges.space_sums import SpaceSums
from minkref.fuzz.space.general_pairs import general_pair
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import CGAL, COMPARISON, REFERENCE, Findings

SUBJECT = (
    "Sums of pairs of polyhedra of any shape, half of them degenerate: the routes, CGAL's Nef "
    "polyhedra, the cells of polycubes under matrices and the slow engine agree, text for text and "
    "at points; the laws of sums hold; each disagreement is settled by a witness. Each sum, and "
    "polycubes that touch themselves, written as triangles is closed and manifold edge by edge in "
    "OFF, OBJ and PLY, by a reader from the formats' definitions."
)
MINUTES = (36, 0.5)
DEPENDS = (*REFERENCE, *COMPARISON, *CGAL, "oracle/slow/*.py")

SEED = 2012
PAIRS, QUICK_PAIRS = 2000, 28
NEF_SECONDS, QUICK_NEF_SECONDS = 20.0, 3.0
POINTS, QUICK_POINTS = 30, 10
EVERY_FOR_LAWS, QUICK_EVERY_FOR_LAWS = 3, 5  # one pair in so many, prime to the 14 families

POLYCUBES, QUICK_POLYCUBES = 1500, 40
FORMS = ("off", "obj", "ply")

Task = tuple[int, bool]
_nef: dict[bool, NefJudge] = {}  # of this process, which ends it


def judge(task: Task) -> dict[str, Any]:
    """All answers on one pair, and for some pairs the laws, of each route."""
    index, quick = task
    if quick not in _nef:
        _nef[quick] = NefJudge(QUICK_NEF_SECONDS if quick else NEF_SECONDS)
    since = time.perf_counter()
    sums = SpaceSums(general_pair(SEED, index))
    known = routes()
    sums.ask(known, _nef[quick])
    sums.compare(QUICK_POINTS if quick else POINTS)
    laws: Counter[str] = Counter()
    every = QUICK_EVERY_FOR_LAWS if quick else EVERY_FOR_LAWS
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
    """What is wrong with the mesh of triangles in any format. Where its text is exact it also
    encloses the volume of the set."""
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
    """Of random cells, which touch along edges and in vertices."""
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


def run(findings: Findings, quick: bool) -> None:
    count = QUICK_PAIRS if quick else PAIRS
    answers: Counter[str] = Counter()
    points = asked = 0
    laws: Counter[str] = Counter()
    messages: list[str] = []
    slowest: tuple[float, str] = (0.0, "")
    tasks = [(index, quick) for index in range(count)]
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
    polycubes = QUICK_POLYCUBES if quick else POLYCUBES
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
