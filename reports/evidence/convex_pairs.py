"""25 pairs of convex models at random factors: update, static routes and CGAL's hull agree."""

from __future__ import annotations

from itertools import product

from minkref import _core
from minkref.reports.bench.cgal_space_service import CgalSpaceService
from minkref.reports.bench.table2 import MODELS, is_sum_of_cgal, random_scalings
from minkref.reports.evidence.framework import part
from minkref.reports.evidence.framework.part import Findings
from minkref.space.operand import read_space_operand

SUBJECT = (
    "25 ordered pairs of convex models, each axis scaled log-uniformly in [0.1, 10]: the sum "
    "that was updated from factor to factor is the one from scratch, and CGAL's hull."
)
MINUTES = (2, None)
DEPENDS = (*part.REFERENCE, *part.COMPARISON, *part.CGAL, *part.CONVEX)
FACTORS, WITH_CGAL = 100, 5


def run(findings: Findings, quick: bool) -> None:
    operands = [read_space_operand(name) for name in MODELS]
    updates = static = surfaces = hulls = without_error = 0
    with CgalSpaceService() as service:
        for number, (P, Q) in enumerate(product(operands, operands)):
            if P.body is None or Q.body is None:
                raise ValueError("a model of Table 2 has volume")
            scalings = random_scalings(number + 1, FACTORS + 1)
            moving = _core.DynamicConvexSum(P.body, Q.body, scalings[0])
            for k, scaling in enumerate(scalings[1:]):
                without_error += dict(moving.update(scaling))["chains_without_error"]
                updates += 1
                static += moving.equals_route("traversal")
                if k % (FACTORS // WITH_CGAL):
                    continue
                mine = moving.sum().surface
                fresh = _core.convex_sum(P.body, Q.body, scaling, "brute-force").surface
                surfaces += mine.canonical_json() == fresh.canonical_json()
                hulls += is_sum_of_cgal(service, P, Q, scaling, mine)
            print(f"{P.name}, {Q.name}", flush=True)
    compared = len(operands) ** 2 * WITH_CGAL
    findings.law("updates that have the pairs of the static route", static == updates,
                 len(operands) ** 2 * FACTORS, static)  # fmt: skip
    findings.equal("surfaces equal to those of all pairs compared", compared, surfaces)
    findings.equal("surfaces equal to CGAL's hull", compared, hulls)
    findings.none("ee-errors without an error of a facet", without_error)
