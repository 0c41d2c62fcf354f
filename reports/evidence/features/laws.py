"""Features before judges that share nothing with the reference, on random sets, half with ties."""

from __future__ import annotations

from minkref.fuzz.features.feature_draws import KINDS
from minkref.fuzz.features.outer_diagram import BOOST, CGAL, absence
from minkref.fuzz.judges.disc.feature_shape_laws import Table
from minkref.fuzz.judges.disc.features_before_judges import compare, compare_bars
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.operands import operand
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.15, 0.6, 40)

SEED = 2052
MODELS = "glyph275", "glyph1204"
SETS, BATCH = Counts(20, 60, 2000), 10
TIES = ("sets with several places at one radius", "sets with ridges",
        "sets with nodes of degree 3 or more", "sets with ties of birth and depth")  # fmt: skip


def batch(first: int) -> Table:
    return compare(SEED, range(first, first + BATCH))


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
    for name in MODELS[: 1 if size is Size.QUICK else None]:
        own = compare_bars(name, operand(name).set)
        findings.none(f"{name}: bars that differ from those of CGAL or Boost", own.faults)
        answers = sum(own.counts[f"sets before {library}"] for library in (CGAL, BOOST))
        findings.equal(f"{name}: libraries with an answer", 2, answers)
    cgal, boost = (counts[f"sets before {library}"] for library in (CGAL, BOOST))
    findings.law("sets before CGAL", cgal == wanted, wanted, cgal)
    findings.law("sets before Boost", boost * 3 >= wanted, f"a third of {wanted}", boost)
    findings.note(
        f"seed {SEED}: {wanted:,} sets, {counts['places']:,} places, {counts['bars']:,} bars, "
        f"{counts['alphas']:,} diameters with {counts['features alive']:,} features and "
        f"{counts['bridges']:,} bridges, {counts['notches']:,} notches, "
        f"{counts['cuts']:,} cuts and {counts['pieces']:,} pieces; the judge takes "
        f"{table.seconds / wanted:.2f} s for a set"
    )
    findings.figures = {"counts": dict(counts), "seconds of the judge": table.seconds}
