"""Sums of polyhedra of any shape: routes, CGAL's Nef polyhedra, cells and the slow engine agree."""

from __future__ import annotations

import random
import time
from collections import Counter
from typing import Any

from minkref.fuzz.judges.space_laws import LAWS
from minkref.fuzz.judges.space_nef import NefJudge
from minkref.fuzz.judges.space_routes import ROUTES, routes
from minkref.fuzz.judges.space_sums import SpaceSums
from minkref.fuzz.space.general_pairs import general_pair
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import CGAL, COMPARISON, REFERENCE, Findings

SUBJECT = (
    "Sums of pairs of polyhedra of any shape, half of them degenerate: the routes, CGAL's Nef "
    "polyhedra, the cells of polycubes under matrices and the slow engine agree, text for text and "
    "at points; the laws of sums hold; each disagreement is settled by a witness."
)
MINUTES = (36, 0.5)
DEPENDS = (*REFERENCE, *COMPARISON, *CGAL, "oracle/slow/*.py")

SEED = 2012
PAIRS, QUICK_PAIRS = 2000, 28
NEF_SECONDS, QUICK_NEF_SECONDS = 20.0, 3.0
POINTS, QUICK_POINTS = 30, 10
EVERY_FOR_LAWS, QUICK_EVERY_FOR_LAWS = 3, 5  # one pair in so many, prime to the 14 families

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
    findings.note(f"seed {SEED}; slowest: {slowest[1]}, {slowest[0]} s")
    findings.figures = {
        "pairs": count,
        "answers": dict(answers),
        "points": points,
        "laws": dict(laws),
        "disagreements": messages[:20],
    }
