"""Small convex pairs on a grid, where parallel facets abound: all ways of summing agree."""

from __future__ import annotations

import random
import tempfile
from collections import Counter
from fractions import Fraction
from pathlib import Path

from minkref import _core
from minkref.certify.space.convex_certificate import ConvexCertificate
from minkref.exact import digest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.space.convex_facets import convex_facets
from minkref.fuzz.space.generators.convex import random_hull
from minkref.reports.bench.cgal_space_service import NEF, CgalSpaceService
from minkref.reports.bench.table2 import is_sum_of_cgal
from minkref.reports.evidence.certificates.checkers import in_cpp, timed
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling

MINUTES = Minutes(None, 0.8, 7)
PAIRS, SCALINGS = Counts(0, 300, 2000), 20
WITH_NEF, WITH_ALGEBRA = 100, 10  # pairs, at their last scaling
MOST_FOR_ALGEBRA = 6  # vertices of each operand
SEED = 20121


def run(findings: Findings, size: Size) -> None:
    count, dice = size.of(PAIRS), random.Random(SEED)
    counts: Counter[str] = Counter()
    kinds: Counter[str] = Counter()
    with (
        CgalSpaceService() as service,
        CgalSpaceService(NEF) as nef,
        tempfile.TemporaryDirectory() as name,
    ):
        for number in range(count):
            P, Q = (_operand(dice) for _ in "PQ")
            scalings = _scalings(dice)
            found = _examine(P, Q, scalings, service, Path(name), counts, kinds)
            if number < WITH_NEF:
                counts["nef"] += is_sum_of_cgal(nef, P, Q, scalings[-1], found.surface)
            if counts["algebra tried"] < WITH_ALGEBRA and _is_tiny(P, Q):
                counts["algebra tried"] += 1
                counts["algebra"] += _by_algebra(P, Q, scalings[-1]) == _facets(found)
            if number % 100 == 99:
                print(f"{number + 1} pairs", flush=True)
    every = count * SCALINGS
    for what, key in (
        ("updates that have the pairs of the traversal", "traversal"),
        ("updates that have the pairs of all pairs compared", "brute-force"),
        ("sums equal to CGAL's hull", "hull"),
        ("certified digests equal to those of the sums", "digest"),
    ):
        findings.equal(what, every, counts[key])
    findings.equal("certificates verified, one for each pair", count, counts["verified"])
    findings.equal("sums equal to CGAL's of Nef polyhedra", WITH_NEF, counts["nef"])
    findings.equal(
        "facets with their parents equal to those by computer algebra",
        WITH_ALGEBRA,
        counts["algebra"],
    )
    findings.none("ee-errors without an error of a facet", counts["without error"])
    findings.note(f"seed {SEED}; errors mended: {counts['errors']:,}")
    told = ", ".join(f"{kind} {count:,}" for kind, count in kinds.most_common())
    findings.note(f"facets by the faces whose sum they are: {told}")


def _operand(dice: random.Random) -> SpaceOperand:
    hull: Polyhedron = random_hull(dice, dice.randint(4, 20), dice.choice((1, 2, 3, 6)))
    points = [(str(x), str(y), str(z)) for x, y, z in hull.vertices]
    surface = _core.Polyhedron(points, [list(face) for face in hull.faces])
    return SpaceOperand("hull", Path("hull"), surface, _core.ConvexPolyhedron(surface))


def _scalings(dice: random.Random) -> list[Scaling]:
    """Small fractions, which often make facets parallel, and now and then a tiny step."""
    found: list[Scaling] = []
    for _ in range(SCALINGS):
        if found and dice.random() < 0.3:
            x, y, z = found[-1]
            nudge = 1 + Fraction(1, 2 ** dice.randint(10, 60))
            found.append((str(Fraction(x) * nudge), y, z))
        else:
            x, y, z = (str(Fraction(dice.randint(1, 7), dice.randint(1, 3))) for _ in range(3))
            found.append((x, y, z))
    return found


def _examine(
    P: SpaceOperand,
    Q: SpaceOperand,
    scalings: list[Scaling],
    service: CgalSpaceService,
    folder: Path,
    counts: Counter[str],
    kinds: Counter[str],
) -> _core.ConvexSum:
    """All scalings in turn. Returns the last sum."""
    if P.body is None or Q.body is None:
        raise ValueError("a hull has volume")
    certificate = ConvexCertificate(P.surface, Q.surface)
    moving = _core.DynamicConvexSum(P.body, Q.body, scalings[0])
    for scaling in scalings:
        did = dict(moving.update(scaling))
        counts["errors"] += did["fv_errors"] + did["vf_errors"] + did["ee_errors"]
        counts["without error"] += did["chains_without_error"]
        for route in ("traversal", "brute-force"):
            counts[route] += moving.equals_route(route)
        found = moving.sum()
        kinds.update(_kind(p) + " + " + _kind(q) for p, q in found.facet_parents)
        counts["hull"] += is_sum_of_cgal(service, P, Q, scaling, found.surface)
        claim = certificate.claims[certificate.sum(scaling)]
        counts["digest"] += claim["digest"] == digest(found.surface.canonical_json())
    case, path = folder / "pair.case.json", folder / "pair.cert.json"
    case.write_text(certificate.case(), encoding="utf-8")
    path.write_text(certificate.text(case.name), encoding="utf-8")
    verdict, _ = timed(in_cpp(), path)
    counts["verified"] += not verdict.code
    return found


Parents = set[tuple[frozenset[int], frozenset[int]]]


def _is_tiny(P: SpaceOperand, Q: SpaceOperand) -> bool:
    return max(P.surface.vertices, Q.surface.vertices) <= MOST_FOR_ALGEBRA


def _by_algebra(P: SpaceOperand, Q: SpaceOperand, scaling: Scaling) -> Parents:
    if P.body is None or Q.body is None:
        raise ValueError("a hull has volume")
    return convex_facets(
        P.body.surface().written_points(), Q.body.surface().written_points(), scaling
    )


def _facets(found: _core.ConvexSum) -> Parents:
    return {(frozenset(p), frozenset(q)) for p, q in found.facet_parents}


def _kind(face: list[int]) -> str:
    return {1: "vertex", 2: "edge"}.get(len(face), "facet")
