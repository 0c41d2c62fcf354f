"""Events between facets of sums: the lists agree with computer algebra, with all facet pairs, and
with arrangements at single scales."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from minkref.fuzz.judges.space import (
    facet_arrangement,
    facet_tuple_comparison,
    space_event_comparison,
)
from minkref.fuzz.judges.space.space_event_comparison import KINDS, solids_of
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 1.5, 30)

SEED = 1912
PAIRS = Counts(2, 300, 5000)
QUADRUPLES = Counts(16, 1_200, 20_000)
LISTS = Counts(1, 30, 500)
BATCHES = 20
FROM, TO = "1/5", "2"
MOST_FACETS = 160
EVENTS_OF_A_PAIR = 3  # events with arrangements around them

Task = tuple[str, int, int]  # kind, number, count


@dataclass
class Answer:
    counts: Counter[str] = field(default_factory=Counter)
    degenerate: Counter[str] = field(default_factory=Counter)
    differences: list[str] = field(default_factory=list)


def judge(task: Task) -> tuple[str, Answer]:
    what, number, count = task
    if what == "pairs":
        found = space_event_comparison.compare(SEED + 1000 * number, count)
        return what, Answer(
            found.pairs + Counter({f"{kind} events": n for kind, n in found.events.items()}),
            found.degenerate,
            list(map(str, found.differences)),
        )
    if what == "quadruples":
        tuples = facet_tuple_comparison.compare(SEED, count, number, BATCHES)
        counts = Counter({"quadruples": tuples.quadruples, "triples": tuples.triples})
        return what, Answer(
            counts + tuples.events,
            Counter({"quadruples": tuples.degenerate}),
            list(map(str, tuples.differences)),
        )
    return what, of_lists(number)


def of_lists(number: int) -> Answer:
    """Judges the list for a pair of small polyhedra."""
    pair = solids_of(SEED, number)
    answer = Answer()
    if pair is None:
        return answer
    found = facet_arrangement.judge_list(pair, (FROM, TO), MOST_FACETS, EVENTS_OF_A_PAIR)
    if found is not None:
        answer.counts.update(lists=1, **found.counts)
        answer.differences = [f"{pair.name}: {fault}" for fault in found.faults]
    return answer


def run(findings: Findings, size: Size) -> None:
    pairs, quadruples, lists = map(size.of, (PAIRS, QUADRUPLES, LISTS))
    batches = 2 if size is Size.QUICK else BATCHES
    tasks: list[Task] = [("quadruples", k, -(-quadruples // batches)) for k in range(batches)]
    tasks += [("pairs", k, -(-pairs // batches)) for k in range(batches)]
    tasks += [("lists", k, 1) for k in range(2 * lists)]
    of: dict[str, Answer] = {what: Answer() for what in ("pairs", "quadruples", "lists")}
    for what, answer in in_processes(judge, tasks, each=max(1, len(tasks) // 20)):
        of[what].counts.update(answer.counts)
        of[what].degenerate.update(answer.degenerate)
        of[what].differences += answer.differences
        for difference in answer.differences:
            print(difference[:2000], flush=True)
    counts, degenerate = of["pairs"].counts, of["pairs"].degenerate
    findings.none("events of two facets: differences", of["pairs"].differences)
    reached = ", ".join(f"{kind} {counts[kind]:,}" for kind in KINDS)
    enough = all(counts[kind] >= pairs for kind in KINDS)
    findings.law("pairs of facets of each kind", enough, f"{pairs:,}", reached)
    shares = {kind: degenerate[kind] / counts[kind] for kind in KINDS}
    findings.target(
        "degenerate pairs", min(shares.values()) >= 0.6, "60 % of each kind",
        ", ".join(f"{kind} {share:.0%}" for kind, share in shares.items()),
    )  # fmt: skip
    counts, degenerate = of["quadruples"].counts, of["quadruples"].degenerate
    findings.none("events of three and four facets: differences", of["quadruples"].differences)
    findings.law("quadruples of facets", counts["quadruples"] >= quadruples, f"{quadruples:,}",
                 f"{counts['quadruples']:,}, {counts['triples']:,} triples in them")  # fmt: skip
    findings.law("events of four among them", counts["four touch"] > 0, "some",
                 f"{counts['four touch']:,}")  # fmt: skip
    share = degenerate["quadruples"] / counts["quadruples"]
    findings.target("degenerate quadruples", share >= 0.6, "60 %", f"{share:.0%}")
    counts = of["lists"].counts
    findings.none("lists: differences", of["lists"].differences)
    findings.law("lists of pairs of polyhedra", counts["lists"] >= lists, lists, counts["lists"])
    findings.law("events that arrangements are looked at around", counts["events looked at"] > 0,
                 "some", f"{counts['events looked at']:,}")  # fmt: skip
    findings.note(
        f"seed {SEED}; the lists have {counts['rows compared']:,} events of two facets and "
        f"{counts['concurrent compared']:,} of three and four"
    )
    findings.figures = {what: dict(answer.counts) for what, answer in of.items()}
