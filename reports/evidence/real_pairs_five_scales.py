"""The paper's pairs at five scales each: our routes against each other and against CGAL."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction

from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict
from minkref.reports.evidence.framework.comparing import Bench, available_cgal
from minkref.reports.evidence.framework.operands import REAL_PAIRS, SCALES, case_of, tell_absent
from minkref.reports.evidence.framework.part import AGAINST_CGAL, Findings

SUBJECT = (
    "disc1 + neuron, disc5 + neuron, monkey + bird at scales 1/3, 1, 7/5, 541/186, 9: routes paper "
    "and winding have one digest; CGAL's reduced convolution has it too, except where a witness "
    "shows that CGAL lost a hole. Called raw (holes that cannot survive left in), CGAL 5.5.1 "
    "dies or loses holes: at least one among 100 seeded scales."
)
MINUTES = (1, 0.3)
DEPENDS = AGAINST_CGAL

PAPER, WINDING, CGAL_REDUCED = "minkref:paper", "minkref:winding", "cgal-reduced"
RAW = "cgal-reduced-raw"
SEED = 2012


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


def five_scales(findings: Findings, cgal: list[str]) -> None:
    rows = []
    raw: Counter[str] = Counter()
    agreed = allowed = compared = total = 0
    with Bench([PAPER, WINDING, *cgal]) as bench:
        for first, second in REAL_PAIRS:
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
    """Scales in [1/10, 10], three decimals, from SEED."""
    dice = random.Random(SEED)
    return [str(Fraction(dice.randint(100, 10_000), 1000)) for _ in range(count)]


def hundred_scales(findings: Findings, cgal: list[str], quick: bool, real: bool) -> None:
    scales = seeded_scales(10 if quick else 100)
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


def run(findings: Findings, quick: bool) -> None:
    real = tell_absent(findings, "neuron")
    tell_absent(findings, "monkey", "bird")
    cgal = available_cgal(findings, CGAL_REDUCED, RAW)
    five_scales(findings, cgal)
    if cgal:
        hundred_scales(findings, cgal, quick, real)
