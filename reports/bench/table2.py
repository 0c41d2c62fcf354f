"""Table 2 of Behar & Lien 2012: convex polyhedra under non-uniform scaling, updated and afresh."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable
from dataclasses import asdict, dataclass, field
from fractions import Fraction
from itertools import product
from statistics import fmean, geometric_mean
from typing import Any

from minkref import _core
from minkref.fuzz.space.hull import convex_hull
from minkref.reports.bench.cgal_space_service import CgalSpaceService, NoSumError
from minkref.reports.bench.spread import least, spread
from minkref.space.operand import SpaceOperand, read_space_operand
from minkref.space.scaling import Scaling

MODELS = ("ellipsoid", "gs3", "gs4", "ti", "rod")
PAPER = {"least": 13.050, "mean": 27.7, "greatest": 97.410}
RANDOM, STEPS = "random", "steps"
ABOUT = {
    RANDOM: "each axis log-uniform in [0.1, 10], a range of ours",
    STEPS: "each axis changed by up to 1 %",
}
COUNT, QUICK_COUNT = 100, 10
PASSES = 3
ALL_EVERY = 25  # every so many re-scalings brute force, CGAL and the surface are timed
RATIOS = ("brute_force_ratio", "traversal_ratio", "cgal_hull_ratio", "cgal_hull_surface_ratio",
          "floor_ratio")  # fmt: skip
SIX_DIGITS = 1_000_000

Row = dict[str, Any]
Tell = Callable[[str], None]


@dataclass
class Table2:
    seed: int
    rescalings: int
    passes_of_cgal: int = PASSES  # CGAL takes nearly all the time
    rows: list[Row] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)  # updated sums that differ from others


def pair_count() -> int:
    return len(MODELS) ** 2


def run(quick: bool, seed: int, tell: Tell, done: Callable[[], None]) -> Table2:
    """Times all pairs, at random factors and at small steps."""
    table = Table2(seed, QUICK_COUNT, 1) if quick else Table2(seed, COUNT)
    operands = [read_space_operand(name) for name in MODELS]
    service: CgalSpaceService | None = None
    try:
        service = CgalSpaceService()
    except NoSumError as error:
        table.notes.append(f"CGAL's hull is left out: {error}")
    try:
        for P, Q in product(operands, operands):
            for kind in (RANDOM, STEPS):
                tell(f"{P.name}, {Q.name}: {ABOUT[kind]}")
                _time_pair(table, P, Q, kind, service, tell)
            done()
    finally:
        if service is not None:
            service.close()
    return table


def random_scalings(seed: int, count: int) -> list[Scaling]:
    """Factors with six decimals, each axis log-uniform in [0.1, 10]."""
    dice = random.Random(seed)
    return [_scaling([10 ** dice.uniform(-1, 1) for _ in range(3)]) for _ in range(count)]


def scalings_in_steps(seed: int, count: int) -> list[Scaling]:
    """A walk: each axis changes by up to 1 %, within [0.1, 10]."""
    dice = random.Random(seed)
    factors = [10 ** dice.uniform(-0.5, 0.5) for _ in range(3)]
    walk = []
    for _ in range(count):
        walk.append(_scaling(factors))
        factors = [min(10, max(0.1, f * dice.uniform(0.99, 1.01))) for f in factors]
    return walk


def _scaling(factors: list[float]) -> Scaling:
    x, y, z = (str(Fraction(round(f * SIX_DIGITS), SIX_DIGITS)) for f in factors)
    return (x, y, z)


def _time_pair(
    table: Table2,
    P: SpaceOperand,
    Q: SpaceOperand,
    kind: str,
    service: CgalSpaceService | None,
    tell: Tell,
) -> None:
    choose = random_scalings if kind == RANDOM else scalings_in_steps
    scalings = choose(table.seed, table.rescalings + 1)
    if P.body is None or Q.body is None:
        raise ValueError("the models of Table 2 have volume")
    every = min(ALL_EVERY, table.rescalings)
    walks = [dict(_core.timed_convex_walk(P.body, Q.body, scalings, every)) for _ in range(PASSES)]
    updates, coordinates, traversals, brute_force, surfaces = (
        least([walk[f"{name}_seconds"] for walk in walks])
        for name in ("update", "coordinate", "traversal", "brute_force", "surface")
    )
    if any(walk["differences"] for walk in walks):
        table.wrong.append(f"{P.name}, {Q.name}: not the static pairs after an update")
    ours = [a + b for a, b in zip(updates, coordinates, strict=True)]
    chosen = range(every, len(scalings), every)
    at_chosen = [ours[k - 1] for k in chosen]
    with_surface = [updates[k - 1] + s for k, s in zip(chosen, surfaces, strict=True)]
    walk = walks[0]
    row: Row = {
        "P": P.name,
        "Q": Q.name,
        "kind": kind,
        "facets": [P.body.facets, Q.body.facets],
        "vertex_pairs_mean": fmean(walk["vertex_pairs"]),
        "ee_pairs_mean": fmean(walk["ee_pairs"]),
        "surface_facets_mean": fmean(walk["surface_facets"]),
        "update": asdict(spread(updates)),
        "ours": asdict(spread(ours)),
        "with_surface": asdict(spread(with_surface)),
        "coordinates": asdict(spread(coordinates)),
        "floor_ratio": sum(ours) / sum(coordinates),
        "traversal": asdict(spread(traversals)),
        "traversal_ratio": _ratio(traversals, ours),
        "traversal_ratios_mean": _mean_of_ratios(traversals, ours),
        "brute_force": asdict(spread(brute_force)),
        "brute_force_ratio": _ratio(brute_force, at_chosen),
        "brute_force_ratios_mean": _mean_of_ratios(brute_force, at_chosen),
        "cgal_hull": None,
        "cgal_hull_ratio": None,
        "cgal_hull_ratios_mean": None,
        "cgal_hull_surface_ratio": None,
        **_per_step(walk, len(ours)),
    }
    if service is not None:
        tell(f"{P.name}, {Q.name}: CGAL's hull")
        seconds = _cgal(table, service, P, Q, scalings, chosen)
        row["cgal_hull"] = asdict(spread(seconds))
        row["cgal_hull_ratio"] = _ratio(seconds, at_chosen)
        row["cgal_hull_ratios_mean"] = _mean_of_ratios(seconds, at_chosen)
        row["cgal_hull_surface_ratio"] = _ratio(seconds, with_surface)
    table.rows.append(row)


def _ratio(theirs: list[float], ours: list[float]) -> float:
    return sum(theirs) / sum(ours)


def _mean_of_ratios(theirs: list[float], ours: list[float]) -> float:
    return fmean(b / a for a, b in zip(ours, theirs, strict=True))


def _per_step(walk: Row, steps: int) -> Row:
    """Means of the update's counts over the re-scalings."""
    errors = walk["fv_errors"] + walk["vf_errors"] + walk["ee_errors"]
    counts = ("fv_errors", "vf_errors", "ee_errors", "descent_steps", "chains_walked", "signs",
              "exact_signs")  # fmt: skip
    return {
        **{name: walk[name] / steps for name in counts},
        "signs_per_error": walk["signs"] / errors if errors else None,
        "chains_without_error": walk["chains_without_error"],
    }


def _cgal(
    table: Table2,
    service: CgalSpaceService,
    P: SpaceOperand,
    Q: SpaceOperand,
    scalings: list[Scaling],
    chosen: range,
) -> list[float]:
    """Seconds for CGAL's hull at the chosen scalings. Its vertices determine a convex body, and
    must equal the vertices of the sum updated through all scalings."""
    if P.body is None or Q.body is None:
        raise ValueError("the models of Table 2 have volume")
    moving = _core.DynamicConvexSum(P.body, Q.body, scalings[0])
    result = []
    for k, scaling in enumerate(scalings):
        moving.update(scaling)
        if k not in chosen:
            continue
        sums = [sum_of_cgal(service, P, Q, scaling) for _ in range(table.passes_of_cgal)]
        if not _same(moving.sum().surface, sums[0][1]):
            table.wrong.append(f"{P.name}, {Q.name} at {','.join(scaling)}: not CGAL's hull")
        result.append(min(seconds for seconds, _ in sums))
    return result


Corner = tuple[str, str, str]


def is_sum_of_cgal(
    service: CgalSpaceService,
    P: SpaceOperand,
    Q: SpaceOperand,
    scaling: Scaling,
    sum_: _core.Polyhedron,
) -> bool:
    """Whether a sum has CGAL's vertices, which determine a convex body."""
    return _same(sum_, sum_of_cgal(service, P, Q, scaling)[1])


def sum_of_cgal(
    service: CgalSpaceService, P: SpaceOperand, Q: SpaceOperand, scaling: Scaling
) -> tuple[float, set[Corner]]:
    """CGAL's seconds, and the vertices of CGAL's sum."""
    factors = [Fraction(f) for f in scaling]
    scaled = [_point([f * Fraction(c) for f, c in zip(factors, point, strict=True)])
              for point in P.surface.points()]  # fmt: skip
    service.load(Q.surface)
    seconds, hull = service.sum(_core.Polyhedron(scaled, P.surface.rings()))
    return seconds, {_point(vertex) for vertex in hull["vertices"]}


def _same(sum_: _core.Polyhedron, theirs: set[Corner]) -> bool:
    mine = set(sum_.written_points())
    return mine == theirs or (mine < theirs and _flat(mine, theirs))


def _point(vertex: Iterable[str | Fraction]) -> Corner:
    x, y, z = (str(Fraction(number)) for number in vertex)
    return (x, y, z)


def _flat(mine: set[Corner], theirs: set[Corner]) -> bool:
    """Whether the hull of CGAL's vertices has our vertices; CGAL may keep points inside facets and
    edges."""
    hull = convex_hull((Fraction(x), Fraction(y), Fraction(z)) for x, y, z in theirs)
    return {(str(x), str(y), str(z)) for x, y, z in hull.vertices} == mine


def summary(table: Table2) -> Row:
    """Geometric means over all pairs, and the extremes."""
    result: Row = {}
    for kind in (RANDOM, STEPS):
        rows = [row for row in table.rows if row["kind"] == kind]
        for name in RATIOS:
            values = [row[name] for row in rows if row[name] is not None]
            result[f"{kind}_{name}"] = (
                {"least": min(values), "mean": geometric_mean(values), "greatest": max(values)}
                if values
                else None
            )
    return result
