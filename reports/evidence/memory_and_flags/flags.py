"""Signs that the float filter hands on and plain doubles get wrong; and all double computations,
compiled with the flags that people use."""

from __future__ import annotations

from collections import Counter

from minkref import _core
from minkref.reports.evidence.framework.flags import REFUSED, TAKEN, compilers, trial
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("reference/paper/trials/", "reference/number/")
MINUTES = Minutes(0.05, 1.5, 8)

WANTED = 1000
BATCH = 100_000
MOST_BATCHES = 50
SEED, ROUNDS = 1, 40_000
EVERY = Counts(1, 4, 1)  # one set of flags from so many


def run(findings: Findings, size: Size) -> None:
    total: Counter[str] = Counter()
    batches = 0
    while batches < MOST_BATCHES and (
        total["doubles_wrong"] < WANTED or not (size is Size.QUICK or batches > 9)
    ):
        batches += 1
        total.update(_core.filter_trial(batches, BATCH))
    findings.figures = {"seeds": f"1 to {batches}", "signs a seed": BATCH, **total}
    wrong = total["doubles_wrong"]
    findings.target("handed on, and wrong in doubles", wrong >= WANTED, f"at least {WANTED}", wrong)
    handed = total["handed_on"]
    findings.law("those are among the signs handed on", wrong <= handed, f"at most {handed}", wrong)
    if "filter_wrong" in total:
        bad = total["filter_wrong"]
        findings.none("signs that the filter decided wrongly", bad)
    if size is Size.QUICK:
        findings.note("compilers' flags are tried in larger runs, and by tests")
        return
    here = compilers()
    for compiler in TAKEN:
        if compiler in here:
            _taken(findings, compiler, size.of(EVERY))
            _refused(findings, compiler, size.of(EVERY))
        else:
            findings.note(f"{compiler} is not installed: its flags are not tried")


def _taken(findings: Findings, compiler: str, every: int) -> None:
    rows = {}
    for flags in TAKEN[compiler][::every]:
        name = " ".join((compiler, *flags))
        tried = trial(compiler, flags, SEED, ROUNDS)
        bad = [f"{what}: {wrong}" for what, (_, wrong) in (tried.counts or {}).items() if wrong]
        findings.law(
            f"{name}: all is right", tried.code == 0 and not bad, "0 wrong",
            "; ".join(bad) or f"{tried.tried:,} tried, exit code {tried.code} {tried.told[:200]}",
        )  # fmt: skip
        rows[name] = {what: count for what, (count, _) in (tried.counts or {}).items()}
    findings.figures[f"tried, {compiler}"] = rows


def _refused(findings: Findings, compiler: str, every: int) -> None:
    """Checks refusals: by a compiler error, or in words at the first call."""
    taken = [
        " ".join(flags)
        for flags in REFUSED[compiler][::every]
        if not trial(compiler, flags, SEED, 1).is_refused
    ]
    findings.equal(f"{compiler}: flags that change doubles and are refused", [], taken)
