"""Features of sets that are scaled, turned, mirrored or moved, or whose rings start elsewhere and
come in another order."""

from __future__ import annotations

from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.of_tests import module
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT

MINUTES = Minutes(None, 0.3, 4)

SEED = 5_000
SETS = Counts(0, 60, 1_000)
BATCH = 10
LAWS = {
    "similar sets without similar trees, bars and radii": "test_similar_sets_have_similar_features",
    "sets whose features change with the start and order of rings":
        "test_rings_may_start_anywhere_in_any_order",
}  # fmt: skip


def batch(first: int) -> dict[str, list[str]]:
    laws = module("test_feature_laws", ROOT / "tests" / "api", ROOT / "tests" / "disc")
    wrong: dict[str, list[str]] = {what: [] for what in LAWS}
    for what, name in LAWS.items():
        for seed in range(first, first + BATCH):
            try:
                getattr(laws, name)(seed)
            except AssertionError as error:
                wrong[what].append(f"{seed}: {str(error)[:200]}")
    return wrong


def run(findings: Findings, size: Size) -> None:
    count = size.of(SETS)
    wrong: dict[str, list[str]] = {what: [] for what in LAWS}
    for found in in_processes(batch, range(SEED, SEED + count, BATCH), what="batches of sets"):
        for what, faults in found.items():
            wrong[what] += faults
    for what in LAWS:
        findings.none(f"{what} (of {count:,})", wrong[what])
    findings.note(f"seeds {SEED} to {SEED + count - 1}; scaled by 7/3, turned by 3-4-5, mirrored, "
                  "moved by (1/3, -1000)")  # fmt: skip
