"""Features before judges that share nothing with the reference, on random sets, half with ties."""

from __future__ import annotations

import random
import time

from minkref import _core
from minkref.fuzz.judges.disc.feature_comparison import feature_faults
from minkref.fuzz.judges.disc.feature_draws import KINDS, drawn_set, set_of
from minkref.fuzz.judges.disc.feature_shape_laws import Table, count, diagram_faults, sum_faults
from minkref.fuzz.judges.disc.outer_diagram import BOOST, CGAL, DiagramJudge, absence
from minkref.oracle.features import Judge
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.5, 4, 40)

SEED = 2052
SETS, BATCH = Counts(40, 200, 2000), 10
SECONDS = 60.0  # for a diagram
TIES = ("sets with several places at one radius", "sets with ridges",
        "sets with nodes of degree 3 or more", "sets with ties of birth and depth")  # fmt: skip


def batch(first: int) -> Table:
    """Compares sets by number."""
    table = Table()
    with DiagramJudge(CGAL, SECONDS) as cgal, DiagramJudge(BOOST, SECONDS) as boost:
        for number in range(first, first + BATCH):
            name, shape = drawn_set(SEED, number)
            begun = time.process_time()
            judge = Judge(shape)
            table.seconds += time.process_time() - begun
            count(name, judge, table.counts)
            dice = random.Random(f"minkref feature laws {SEED}:{number}")
            faults = feature_faults(judge, _core.features(set_of(shape)), dice, table.counts)
            faults += sum_faults(shape, judge, dice, table.counts)
            table.faults += [f"{name}: {fault}" for fault in faults]
            for library in (cgal, boost):
                diagram_faults(name, shape, judge, library, table)
    return table


def run(findings: Findings, size: Size) -> None:
    missing = [told for told in (absence(CGAL), absence(BOOST)) if told]
    if missing:
        findings.law("the judges are there", False, "they are", "; ".join(missing))
        return
    wanted = size.of(SETS)
    table = Table()
    for one in in_processes(batch, range(0, wanted, BATCH), each=5):
        table.add(one)
    counts = table.counts
    findings.none("features that differ from the judges'", table.faults)
    for kind in KINDS:
        drawn = min(counts[f"sets: {kind}"], counts[f"sets: {kind} shifted"])
        least = wanted // (2 * len(KINDS))
        findings.law(f"sets of kind {kind}, with and without shifts", drawn >= least, least, drawn)
    for tie in TIES:
        findings.law(tie, counts[tie] * 5 >= wanted, f"a fifth of {wanted}", counts[tie])
    cgal, boost = (counts[f"sets before {library}"] for library in (CGAL, BOOST))
    findings.law("sets before CGAL", cgal == wanted, wanted, cgal)
    findings.law("sets before Boost", boost * 3 >= wanted, f"a third of {wanted}", boost)
    findings.note(
        f"seed {SEED}: {wanted:,} sets, {counts['places']:,} places, {counts['bars']:,} bars, "
        f"{counts['alphas']:,} diameters with {counts['features alive']:,} features and "
        f"{counts['bridges']:,} bridges, {counts['notches']:,} notches; the judge takes "
        f"{table.seconds / wanted:.2f} s for a set"
    )
    findings.figures = {"counts": dict(counts), "seconds of the judge": table.seconds}
