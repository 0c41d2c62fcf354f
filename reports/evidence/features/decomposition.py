"""Cuts and pieces before their laws, the rule word for word, and CGAL's convex partitions."""

from __future__ import annotations

import random
import statistics
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import combinations, pairwise
from typing import Any

from minkref import BadInput, Decomposition, PolygonSet, _core, decompose, read_text
from minkref.fuzz.judges.plane.convex_partition import PartitionJudge, absence
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.of_tests import module
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT

MINUTES = Minutes(0.1, 1, 15)

SEED = 840
KINDS = (
    "random", "holes", "dents", "touching", "passing", "cells", "nested", "comb", "star", "spiral",
    "lattice", "rational", "leaning", "offset", "magnitude",
)  # fmt: skip
EACH = Counts(2, 12, 200)  # sets of a family
LARGE = ("neuron", "monkey", "bird")
SECONDS = 2.0
MOST_EDGES = 60  # for the rule word for word
MOST_PIECES = 24  # of which each two are intersected
MOST_CORNERS = 40  # for the optimal partition
TURNED = (Fraction(3, 5), Fraction(4, 5))

TILE = "decompositions whose pieces do not tile the set"
OVERLAP = "decompositions in which two pieces overlap"
NOT_CONVEX = "decompositions at alpha 0 and persistence 0 with a piece that is not convex"
TOO_MANY = "decompositions with more pieces than notches and components"
RULE = "decompositions with another cut than the rule in fractions"
NESTED = "persistences with a notch that a smaller one lacks"
WRITTEN = "sets that are cut in another way when written in another way"
MOVED = "sets with other notches, or other cuts at these, when turned, scaled and moved"
CUTS = "cuts before the rule in fractions"
LAWS = (TILE, OVERLAP, NOT_CONVEX, TOO_MANY, RULE, NESTED, WRITTEN, MOVED)


@dataclass
class Found:
    """Faults by law, how often each law was tried, and numbers of pieces: ours, Hertel and
    Mehlhorn's, the least."""

    wrong: dict[str, list[str]] = field(default_factory=dict)
    tried: Counter[str] = field(default_factory=Counter)
    partitions: list[tuple[int, int, int | None]] = field(default_factory=list)

    def check(self, law: str, is_right: bool, about: str, count: int = 1) -> None:
        self.tried[law] += count
        if not is_right:
            self.wrong.setdefault(law, []).append(about)


def run(findings: Findings, size: Size) -> None:
    total = Found()
    tasks = [(name, size.of(EACH)) for name in KINDS]
    for found in in_processes(examined, tasks, what="families"):
        total.tried.update(found.tried)
        total.partitions += found.partitions
        for law, faults in found.wrong.items():
            total.wrong.setdefault(law, []).extend(faults)
    for law in LAWS:
        findings.none(f"{law} (of {total.tried[law]:,})", total.wrong.get(law, []))
    least = min(total.tried[law] for law in LAWS)
    findings.law("times that each law was tried, at the least", least > 0, "some", least)
    findings.note(f"{total.tried[CUTS]:,} cuts before the rule in fractions")
    rows = _large(findings, size)
    _tell_partitions(findings, total.partitions)
    findings.figures = {"tried": dict(total.tried), "partitions": total.partitions, "large": rows}


def examined(task: tuple[str, int]) -> Found:
    name, count = task
    found = Found()
    dice = random.Random(f"{SEED} {name}")
    with PartitionJudge(20.0) as judge:
        for index in range(count):
            pair = FAMILIES[name].pair(SEED, 7 * index)
            for text in (pair.P, pair.Q):
                P = read_text(text, "json")
                if P.is_region:
                    _examine(P, f"{name} {index}: {text}", dice, judge, found)
    return found


def _examine(P: PolygonSet, about: str, dice: random.Random, judge: PartitionJudge,
             found: Found) -> None:  # fmt: skip
    whole = decompose(P)
    convex = all(piece.is_convex and not piece.slits for piece in whole.pieces)
    found.check(NOT_CONVEX, convex, about)
    _check(P, whole, about, found)
    alpha = dice.choice([Fraction(0), _length(P, dice)])
    steps = sorted(_length(P, dice) for _ in range(2))
    persistences: list[Fraction | str] = [Fraction(0), *steps, "inf"]
    levels = [decompose(P, alpha, each) for each in persistences]
    for less, more in pairwise(levels):
        is_nested = set(_vertices(more)) <= set(_vertices(less))
        found.check(NESTED, is_nested, f"{alpha} {steps} {about}")
    _check(P, levels[1], f"alpha {alpha}, persistence {steps[0]}, {about}", found)
    other = _written_otherwise(P, dice)
    found.check(WRITTEN, _cuts(decompose(other, alpha, steps[0])) == _cuts(levels[1]), about)
    _check_moved(P, alpha, steps[0], about, dice, found)
    _count(P, whole, judge, found)


def _length(P: PolygonSet, dice: random.Random) -> Fraction:
    """About the width of a bay."""
    sides = [Fraction(0)]
    for rings in _rings(P):
        xs, ys = zip(*rings[0], strict=True)
        sides += [max(xs) - min(xs), max(ys) - min(ys)]
    return max(sides) * dice.randint(1, 24) / 48


def _check(P: PolygonSet, cut: Decomposition, about: str, found: Found) -> None:
    pieces = [piece.region for piece in cut.pieces]
    area = sum((Fraction(piece.area()) for piece in pieces), Fraction(0))
    united = _core.combined("union", pieces)[0]
    components = _core.combined("union", [P])[1]
    found.check(TILE, area == Fraction(P.area()) and united == P, about)
    found.check(TOO_MANY, len(pieces) <= len(cut.notches) + components, about)
    if len(pieces) <= MOST_PIECES:
        apart = not any(_core.combined("intersection", two)[0].rings()
                        for two in map(list, combinations(pieces, 2)))  # fmt: skip
        found.check(OVERLAP, apart, about)
    rule = module("cut_rule", ROOT / "tests" / "plane")
    edges = [
        wall
        for rings in _rings(P)
        for ring in rings
        for wall in zip(ring, ring[1:] + ring[:1], strict=True)
    ]
    if len(edges) <= MOST_EDGES:
        right = rule.cuts(edges, [notch.vertex for notch in cut.notches])
        found.check(RULE, right == _cuts(cut), about)
        found.tried[CUTS] += len(right)


def _cuts(cut: Decomposition) -> list[tuple[int, Any, Any]]:
    return [(one.notch, one.start, one.end) for one in cut.cuts]


def _vertices(cut: Decomposition) -> list[Any]:
    return [notch.vertex for notch in cut.notches]


def _rings(P: PolygonSet) -> list[list[list[tuple[Fraction, Fraction]]]]:
    return [
        [[(Fraction(x), Fraction(y)) for x, y in ring] for ring in rings] for rings in P.rings()
    ]


def _mapped(P: PolygonSet, image: Callable[[Fraction, Fraction], Any]) -> PolygonSet:
    return PolygonSet([[[image(*p) for p in ring] for ring in rings] for rings in _rings(P)],
                      validate=False)  # fmt: skip


def _written_otherwise(P: PolygonSet, dice: random.Random) -> PolygonSet:
    """With rings in another order and from another start, and a straight vertex in each."""
    shape = []
    for rings in _rings(P):
        turned = []
        for ring in rings:
            k = dice.randrange(len(ring))
            ring = ring[k:] + ring[:k]
            middle = tuple((a + b) / 2 for a, b in zip(ring[0], ring[1], strict=True))
            turned.append([ring[0], middle, *ring[1:]])
        shape.append([turned[0], *dice.sample(turned[1:], len(turned) - 1)])
    return PolygonSet(dice.sample(shape, len(shape)), validate=False)


def _check_moved(P: PolygonSet, alpha: Any, step: Fraction, about: str, dice: random.Random,
                 found: Found) -> None:  # fmt: skip
    """Shakes the vertices first, so that no two ends are equally near."""
    unit = _length(P, random.Random(0)) / 2**24

    def shaken(x: Fraction, y: Fraction) -> tuple[Fraction, Fraction]:
        own = random.Random(f"{x} {y}")
        return x + unit * own.randint(-999, 999), y + unit * own.randint(-999, 999)

    Q = _mapped(P, shaken)
    try:
        Q.validate("shaken")
    except BadInput:
        return
    (c, s), factor, far = TURNED, Fraction(dice.randint(1, 9), dice.randint(1, 9)), 10**9

    def image(x: Fraction, y: Fraction) -> tuple[Fraction, Fraction]:
        return factor * (c * x - s * y) + far, factor * (s * x + c * y) - far

    cut = decompose(Q, alpha, step)
    if any(notch.tie for notch in cut.notches):
        return
    R = _mapped(Q, image)
    moved = {notch.vertex for notch in decompose(R, alpha * factor, step * factor).notches}
    places = [image(*vertex) for vertex in _vertices(cut)]  # equally long bars come by place
    cuts, _ = _core.cut_at_notches(R, [(str(x), str(y)) for x, y in places])
    right = [(image(*one.start), image(*one.end)) for one in cut.cuts]
    given = [tuple((Fraction(x), Fraction(y)) for x, y in (start, end)) for start, end, *_ in cuts]
    found.check(MOVED, moved == set(places) and given == right, about)


def _count(P: PolygonSet, cut: Decomposition, judge: PartitionJudge, found: Found) -> None:
    """Numbers of convex pieces of a simple polygon, ours and CGAL's."""
    polygons = _core.combined("union", [P])[0].rings()
    if len(polygons) != 1 or len(polygons[0]) != 1:
        return
    told = judge.count(polygons[0][0], len(polygons[0][0]) <= MOST_CORNERS)
    if told.approximate is not None:
        found.partitions.append((len(cut.pieces), told.approximate, told.optimal))


def _tell_partitions(findings: Findings, rows: Sequence[tuple[int, int, int | None]]) -> None:
    if not rows:
        findings.note(f"no convex partitions to compare with: {absence()}")
        return
    ours, theirs = sum(row[0] for row in rows), sum(row[1] for row in rows)
    fewer = sum(row[0] < row[1] for row in rows)
    more = sum(row[0] > row[1] for row in rows)
    findings.note(
        f"{len(rows):,} simple polygons: {ours:,} pieces by our cuts, {theirs:,} by CGAL's "
        f"approx_convex_partition_2 (Hertel and Mehlhorn), whose cuts join vertices; ours has "
        f"fewer for {fewer:,} and more for {more:,}"
    )
    least = [(own, few) for own, _, few in rows if few is not None]
    if least:
        own, few = (sum(column) for column in zip(*least, strict=True))
        findings.note(
            f"{len(least):,} of them with at most {MOST_CORNERS} corners: {own:,} pieces by our "
            f"cuts, {few:,} at the least between vertices "
            "(CGAL's optimal_convex_partition_2)"
        )


def _large(findings: Findings, size: Size) -> list[dict[str, Any]]:
    tell_absent(findings, *LARGE)
    rows = []
    for name in LARGE:
        known, P = operand(name).name, operand(name).set
        spent = []
        for _ in range(1 if size is Size.QUICK else 5):
            began = time.process_time()
            cut = decompose(P)
            spent.append(time.process_time() - began)
        places = [(str(x), str(y)) for x, y in _vertices(cut)]
        began = time.process_time()
        _core.cut_at_notches(P, places)
        only_cuts = time.process_time() - began
        area = sum(Fraction(piece.region.area()) for piece in cut.pieces)
        right = area == Fraction(P.area()) and all(piece.is_convex for piece in cut.pieces)
        findings.law(f"{known}: convex pieces that tile it", right, True, right)
        seconds = statistics.median(spent)
        told = f"{seconds:.2f}"
        findings.target(f"{known}: CPU seconds", seconds <= SECONDS, f"at most {SECONDS:g}", told)
        rows.append({
            "model": known, "vertices": P.vertices, "notches": len(cut.notches),
            "cuts": len(cut.cuts), "pieces": len(cut.pieces), "seconds": seconds,
            "seconds of cuts and pieces": only_cuts, **_by_cgal(P),
        })  # fmt: skip
        beside = rows[-1].get("approximate")
        findings.note(
            f"{known}: {len(cut.notches):,} notches, {len(cut.cuts):,} cuts, "
            f"{len(cut.pieces):,} pieces in {seconds:.2f} CPU seconds, {only_cuts:.2f} of them for "
            "cuts and pieces" + (f"; {beside:,} pieces by Hertel and Mehlhorn" if beside else "")
        )
    return rows


def _by_cgal(P: PolygonSet) -> dict[str, Any]:
    polygons = _core.combined("union", [P])[0].rings()
    if len(polygons) != 1 or len(polygons[0]) != 1:
        return {}
    with PartitionJudge(60.0) as judge:
        return {"approximate": judge.count(polygons[0][0], False).approximate}
