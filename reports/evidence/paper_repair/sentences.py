"""The paper's repair of convex sums (Section 6), followed literally: how often it gets the sum's
facets, and which sentence to blame."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, product

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.judges.space.convex_claims import (
    ClaimComparison,
    compare_claims,
    largest_distance,
)
from minkref.fuzz.space.convex_sum import body_of, reference_sum
from minkref.fuzz.space.generators.convex import box, random_hull
from minkref.fuzz.space.hull import convex_hull
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.5, 3)

SEED = 6
RANDOM_PAIRS, OTHER_PAIRS, SHARE = 1000, 250, Counts(50, 4, 1)
STEPS = 5  # scalings of the law
BLOCK = 25  # pairs of a task
BITS = {"double": 53, "mpfr:200": 200}
CORRECTED = {name: corrected for name, _, corrected, _ in _core.repair_readings()}
PRINTED = {name: values[0] for name, values, *_ in _core.repair_readings()}
WRONG = [name for name in CORRECTED if CORRECTED[name] != PRINTED[name]]
# Variants that start at facet errors, and nowhere else.
FROM_ERRORS = {
    "chains from errors of facets of both bodies": CORRECTED | {"search": "beside-errors"},
    "chains from errors of facets of P": CORRECTED
    | {"errors": "chains-from-P", "search": "beside-errors"},
}
VARIANTS = {
    "all corrected": CORRECTED,
    **{f"{name} as printed": CORRECTED | {name: PRINTED[name]} for name in WRONG},
    "ties by open arcs": CORRECTED | {"ties": "open"},
    **FROM_ERRORS,
    "all as printed": PRINTED,
    **{f"all as printed but {name}": PRINTED | {name: CORRECTED[name]} for name in WRONG},
}
THEOREM_1 = "chains from errors of facets of both bodies"

Scaling = tuple[str, str, str]
UNIT = ("1", "1", "1")
Pair = tuple[Polyhedron, Polyhedron]


def _fractions(dice: random.Random) -> Scaling:
    x, y, z = (str(Fraction(dice.randint(1, 9), dice.randint(1, 4))) for _ in range(3))
    return (x, y, z)


def _hull(dice: random.Random, grid: int) -> Polyhedron:
    return random_hull(dice, dice.randint(4, 10), grid)


def _box(dice: random.Random) -> Polyhedron:
    low, high = (
        tuple(Fraction(dice.randint(*ends)) for _ in range(3)) for ends in ((-3, 0), (1, 4))
    )
    return box(_point(low), _point(high))


def _prism(dice: random.Random) -> Polyhedron:
    """Upright, over a polygon of an integer grid."""
    while True:
        flat = {(dice.randint(0, 6), dice.randint(0, 6)) for _ in range(dice.randint(3, 7))}
        height = dice.randint(1, 5)
        try:
            return convex_hull(_point((x, y, z)) for x, y in flat for z in (0, height))
        except ValueError:
            continue


def _with_a_part_in_common(dice: random.Random) -> Pair:
    """A + B and A + C: both have facets parallel to A's facets."""
    A, B, C = (_hull(dice, 4) for _ in "ABC")
    return reference_sum(A, B, Fraction(1)), reference_sum(A, C, Fraction(1))


def _point(numbers: tuple[Fraction | int, ...]) -> Point:
    x, y, z = map(Fraction, numbers)
    return (x, y, z)


FAMILIES: dict[str, Callable[[random.Random], Pair]] = {
    "random": lambda dice: (_hull(dice, 40), _hull(dice, 40)),
    "grid of 2": lambda dice: (_hull(dice, 2), _hull(dice, 2)),
    "boxes": lambda dice: (_box(dice), _box(dice)),
    "prisms": lambda dice: (_prism(dice), _prism(dice)),
    "prism and hull": lambda dice: (_prism(dice), _hull(dice, 6)),
    "a part in common": _with_a_part_in_common,
    "one body twice": lambda dice: (_hull(dice, 6),) * 2,
}


@dataclass(frozen=True)
class Task:
    family: str
    first: int
    count: int


@dataclass
class Found:
    """Findings on some pairs of a family, each after one scaling from the exact sum at scale 1."""

    family: str
    right: Counter[str]  # by variant
    faults: Counter[str]  # all as printed
    not_proven: list[str]  # laws broken
    without_end: Counter[str]  # pairs with a descent that never ends
    ee_alone: int  # ee-errors without a facet error of P
    structure: Counter[str]  # right, by rounding arithmetic
    most_ulps: dict[str, float]


def examine(task: Task) -> Found:
    found = Found(task.family, Counter(), Counter(), [], Counter(), 0, Counter(),
                  dict.fromkeys(BITS, 0.0))  # fmt: skip
    for index in range(task.first, task.first + task.count):
        dice = random.Random(f"{SEED} {task.family} {index}")
        P, Q = map(body_of, FAMILIES[task.family](dice))
        scalings = [_fractions(dice) for _ in range(STEPS)]
        if task.family == "a part in common" and index % 2:  # parallel facets stay so
            scalings = [(x, x, x) if k % 2 else (x, x, z) for k, (x, _, z) in enumerate(scalings)]
        if not _is_proven(P, Q, scalings):
            found.not_proven.append(f"{task.family} {index}")
        for name, readings in VARIANTS.items():
            repair = _core.PaperRepair(P, Q, UNIT, "rational", readings)
            did = dict(repair.update(scalings[0]))
            fault = _fault(P, Q, scalings[0], repair)
            found.right[name] += fault is None
            found.without_end[name] += did["without_end"] > 0
            if name == "all as printed":
                found.faults[fault or "none"] += 1
            if name == "all corrected":
                found.ee_alone += did["ee_errors"] > 0 and did["fv_errors"] == 0
        for arithmetic, bits in BITS.items():
            repair = _core.PaperRepair(P, Q, UNIT, arithmetic, CORRECTED)
            repair.update(scalings[0])
            if _fault(P, Q, scalings[0], repair) is None:
                found.structure[arithmetic] += 1
                off = float(largest_distance(P, Q, scalings[0], repair, bits))
                found.most_ulps[arithmetic] = max(found.most_ulps[arithmetic], off)
    return found


def _fault(
    P: _core.ConvexPolyhedron, Q: _core.ConvexPolyhedron, scaling: Scaling,
    repair: _core.PaperRepair,
) -> str | None:  # fmt: skip
    if repair.has_exact_pairs():
        return None
    return compare_claims(P, Q, scaling, repair.facets()).fault


def _is_proven(
    P: _core.ConvexPolyhedron, Q: _core.ConvexPolyhedron, scalings: list[Scaling]
) -> bool:
    """Whether the fully corrected variant, in rational numbers, equals the proven update at every
    scaling, and its facets, found without a common pair, are the sum's facets."""
    repair = _core.PaperRepair(P, Q, UNIT, "rational", CORRECTED)
    proven = _core.DynamicConvexSum(P, Q, UNIT)
    for scaling in scalings:
        repair.update(scaling)
        proven.update(scaling)
        corners = {pair for _, ring in repair.facets() for pair in ring}
        if not (repair.has_exact_pairs() and proven.equals_route("traversal")
                and corners == set(proven.pairs())):  # fmt: skip
            return False
    return compare_claims(P, Q, scalings[-1], repair.facets()).fault is None


def run(findings: Findings, size: Size) -> None:
    tasks = []
    for family in FAMILIES:
        pairs = RANDOM_PAIRS if family == "random" else OTHER_PAIRS
        pairs = pairs // size.of(SHARE)
        tasks += [
            Task(family, first, min(BLOCK, pairs - first)) for first in range(0, pairs, BLOCK)
        ]
    results = list(in_processes(examine, tasks, 10, "blocks of pairs"))
    asked = Counter[str]()
    for task in tasks:
        asked[task.family] += task.count
    findings.none(
        "all corrected, rational: pairs whose repair is not the proven update",
        [name for found in results for name in found.not_proven],
    )
    lost = {family: asked[family] - right for family, right in _right(results, THEOREM_1).items()}
    findings.target(f"{THEOREM_1}: sums that are lost", not any(lost.values()), 0,
                    sum(lost.values()))  # fmt: skip
    findings.figures["pairs"] = dict(asked)
    findings.figures["right after one scaling, by readings"] = {
        name: _right(results, name) for name in VARIANTS
    }
    findings.figures["pairs with a descent that never ends, all but the degree corrected"] = {
        family: sum(f.without_end["degree as printed"] for f in results if f.family == family)
        for family in FAMILIES
    }
    findings.figures["pairs with ee-errors and no error of a facet of P"] = {
        family: sum(f.ee_alone for f in results if f.family == family) for family in FAMILIES
    }
    findings.figures["all as printed: what is wrong first"] = dict(
        sum((found.faults for found in results), Counter[str]())
    )
    findings.figures["all corrected, right, and the most ulps off"] = {
        arithmetic: {
            family: f"{sum(f.structure[arithmetic] for f in results if f.family == family)}, "
            f"{max(f.most_ulps[arithmetic] for f in results if f.family == family):.3g}"
            for family in FAMILIES
        }
        for arithmetic in BITS
    }
    smallest = {name: _smallest(VARIANTS[name]) for name in VARIANTS if _is_wrong(name)}
    findings.figures["smallest tetrahedra of the unit cube, from scale 1"] = smallest
    findings.law("readings with a smallest pair that is lost, all of them wrong",
                 all(smallest.values()), "all", sum(map(bool, smallest.values())))  # fmt: skip


def _is_wrong(name: str) -> bool:
    """Whether a variant may be wrong: all but the variants believed right."""
    return name not in ("all corrected", THEOREM_1)


def _right(results: list[Found], name: str) -> dict[str, int]:
    return {
        family: sum(found.right[name] for found in results if found.family == family)
        for family in FAMILIES
    }


def _smallest(readings: dict[str, str]) -> str | None:
    """The first pair of tetrahedra with corners from the unit cube, and the first scaling by 1 and
    2, for which these readings lose the sum."""
    scalings = [s for s in product("12", repeat=3) if len(set(s)) > 1]
    for P, Q in _tetrahedra():
        for x, y, z in scalings:
            repair = _core.PaperRepair(P, Q, UNIT, "rational", readings)
            repair.update((x, y, z))
            if repair.has_exact_pairs():
                continue
            found = compare_claims(P, Q, (x, y, z), repair.facets())
            if found.fault is not None:
                return f"P {_told(P)}, Q {_told(Q)}, scaled by {x}, {y}, {z}: {_in_words(found)}"
    return None


def _tetrahedra() -> Iterator[tuple[_core.ConvexPolyhedron, _core.ConvexPolyhedron]]:
    """All pairs, those with small coordinates first."""
    solids = []
    for corners in combinations(product((0, 1), repeat=3), 4):
        try:
            solid = body_of(convex_hull(_point(corner) for corner in corners))
        except ValueError:
            continue
        solids.append((sum(map(sum, corners)), solid))
    pairs = sorted(product(solids, solids), key=lambda pair: pair[0][0] + pair[1][0])
    return ((P, Q) for (_, P), (_, Q) in pairs)


def _told(body: _core.ConvexPolyhedron) -> str:
    return " ".join("".join(point) for point in body.surface().written_points())


def _in_words(found: ClaimComparison) -> str:
    ring = " ".join(f"{p}+{q}" for p, q in found.ring)
    if found.vertex is not None:
        return f"{found.kind}-facet {ring}, {found.vertex[0]}+{found.vertex[1]} is above it"
    return f"{found.kind or 'facet'} {ring}, {found.fault}"
