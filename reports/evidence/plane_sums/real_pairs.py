"""The paper's pairs at five scales each: our routes against each other and against CGAL."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction

from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict
from minkref.reports.evidence.framework.comparing import Bench, available_cgal
from minkref.reports.evidence.framework.operands import REAL_PAIRS, SCALES, case_of, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.2, 1.5, 4)

PAPER, WINDING, CGAL_REDUCED = "minkref:paper", "minkref:winding", "cgal-reduced"
RAW = "cgal-reduced-raw"
TRIANGULATION = "cgal-triangulation"  # shares nothing with convolutions
SEED = 2012
PAIRS, TRIANGULATED = Counts(1, 3, 3), Counts(0, 2, 3)  # of the real ones
SEEDED = Counts(2, 50, 100)  # scales


def describe(outcome: Outcome) -> str:
    if outcome.verdict is not Verdict.WRONG or outcome.witness is None:
        return f"{outcome.verdict} {outcome.message}".strip()
    x, y = outcome.witness.point
    inside = "inside" if outcome.witness.in_truth else "outside"
    return f"wrong ({', '.join(outcome.reasons)}): ({x}, {y}) is {inside}"


def lost_hole(outcome: Outcome) -> bool:
    """A wrong result whose witness lies outside the sum, in a hole that the result has filled."""
    return (
        outcome.verdict is Verdict.WRONG
        and Reason.HOLE_LOST in outcome.reasons
        and outcome.witness is not None
        and not outcome.witness.in_truth
    )


def five_scales(findings: Findings, cgal: list[str], pairs: tuple[tuple[str, str], ...]) -> None:
    rows = []
    raw: Counter[str] = Counter()
    agreed = allowed = compared = total = 0
    with Bench([PAPER, WINDING, *cgal]) as bench:
        for first, second in pairs:
            for scale in SCALES:
                case = case_of(first, second, scale)
                verdicts = bench.verdicts(case)
                paper, winding = verdicts[PAPER], verdicts[WINDING]
                total += 1
                agreed += paper.verdict is Verdict.PASS and winding.verdict is Verdict.PASS
                row = {"case": case.name.text, "digest": paper.digest}
                row |= {name: describe(outcome) for name, outcome in verdicts.items()}
                rows.append(row)
                if CGAL_REDUCED in verdicts:
                    compared += 1
                    answer = verdicts[CGAL_REDUCED]
                    allowed += answer.verdict is Verdict.PASS or lost_hole(answer)
                if RAW in verdicts:
                    raw[describe(verdicts[RAW]).split(":")[0]] += 1
                print(row, flush=True)
    findings.figures |= {"five scales": rows, "five scales, raw": raw}
    findings.equal("cases in which paper and winding agree", total, agreed)
    findings.equal("cases in which CGAL agrees, or lost a hole by a witness", compared, allowed)


def seeded_scales(count: int) -> list[str]:
    """Scales from [1/10, 10] with three decimals, drawn with SEED."""
    dice = random.Random(SEED)
    return [str(Fraction(dice.randint(100, 10_000), 1000)) for _ in range(count)]


def seeded(findings: Findings, cgal: list[str], count: int, real: bool) -> None:
    scales = seeded_scales(count)
    tally: dict[str, Counter[str]] = {name: Counter() for name in cgal}
    examples = []
    with Bench([PAPER, *cgal]) as bench:
        for disc in ("disc1", "disc5"):
            for scale in scales:
                case = case_of(disc, "neuron", scale)
                verdicts = bench.verdicts(case)
                for name in cgal:
                    answer = verdicts[name]
                    kind = "hole lost" if lost_hole(answer) else str(answer.verdict)
                    tally[name][kind] += 1
                    if kind != "pass":
                        row = {"case": case.name.text, "target": name, "verdict": describe(answer)}
                        examples.append(row)
                        print(row, flush=True)
    sums = 2 * len(scales)
    findings.figures["seeded scales"] = {"seed": SEED, "sums": sums, "tally": tally}
    findings.figures["seeded scales, not passed"] = examples
    version = "CGAL " + str(findings.figures["cgal_version"]).removeprefix("CGAL ")
    for name in cgal:
        proven = tally[name]["pass"] + tally[name]["hole lost"]
        died = tally[name]["crashed"] + tally[name]["timed-out"] + tally[name]["out-of-memory"]
        findings.law(
            f"{name} at {len(scales)} seeded scales of disc1, disc5: agrees, lost a hole, or died",
            proven + died == sums,
            sums,
            f"{tally[name]['pass']}, {tally[name]['hole lost']}, {died}",
        )
    lost = sum(counter["hole lost"] for counter in tally.values())
    if "5.5" not in version:
        findings.target(f"sums of which {version} lost a hole", lost == 0, "0, as mended", lost)
    elif real:
        findings.target(f"sums of which {version} lost a hole", lost >= 1, "at least 1", lost)


def triangulation(findings: Findings, pairs: tuple[tuple[str, str], ...]) -> None:
    """Compares sums at scale 1 with CGAL's slowest method."""
    if not pairs or not available_cgal(findings, TRIANGULATION):
        return
    with Bench([PAPER, TRIANGULATION], seconds=1200, gigabytes=12) as bench:
        for first, second in pairs:
            case = case_of(first, second, "1")
            outcome = bench.verdicts(case)[TRIANGULATION]
            same = outcome.verdict is Verdict.PASS
            what = f"{case.name.text} by triangulation"
            findings.figures[what] = {"seconds": outcome.seconds, "digest": outcome.digest}
            if same or outcome.verdict is Verdict.WRONG:
                findings.law(what, same, "one digest", outcome.verdict)
            else:
                findings.target(what, False, "one digest", outcome.message)


def run(findings: Findings, size: Size) -> None:
    real = tell_absent(findings, "neuron")
    tell_absent(findings, "monkey", "bird")
    cgal = available_cgal(findings, CGAL_REDUCED, RAW)
    five_scales(findings, cgal, REAL_PAIRS[: size.of(PAIRS)])
    if cgal:
        seeded(findings, cgal, size.of(SEEDED), real)
    triangulation(findings, REAL_PAIRS[: size.of(TRIANGULATED)])
