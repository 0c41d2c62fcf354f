"""Boundary events of random lattice pairs, by both routes, against sums around every scale."""

from __future__ import annotations

import random
import resource
import threading
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from multiprocessing import get_context
from multiprocessing.connection import Connection
from typing import Any

from minkref.certify.plane.certificate import Certificate, NoProof
from minkref.errors import message_of
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.judges.plane.sampled_events import Events, SampledEvents, judge
from minkref.fuzz.plane.case import Case
from minkref.fuzz.run import child
from minkref.fuzz.run.naming import load_in_plane
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 1.2, 15)

SEED = 2207
PAIRS = Counts(40, 1_500, 20_000)
PROCESSES = 2
SECONDS = 20.0  # for two index builds and the walk of a lattice pair
BYTES = 4 << 30  # a worker's memory limit
CERTIFIED = 40  # one of so many pairs, and each with an event that only shows at its scale
MOST_INTERVALS = 6  # of a pair
Told = dict[str, Any]


def run(findings: Findings, size: Size) -> None:
    pairs = size.of(PAIRS)
    table = Table()
    numbers = iter(range(pairs))
    threads = [threading.Thread(target=table.fill, args=(numbers,)) for _ in range(PROCESSES)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    table.tell(findings, pairs)


@dataclass
class Table:
    """All workers' findings."""

    counts: Counter[str] = field(default_factory=Counter)
    wrong: list[str] = field(default_factory=list)
    endless: list[str] = field(default_factory=list)
    false: list[str] = field(default_factory=list)
    worst: float = 0.0
    lock: threading.Lock = field(default_factory=threading.Lock)

    def fill(self, numbers: Iterator[int]) -> None:
        """Takes pair numbers until none remain."""
        with Worker() as worker:
            while True:
                with self.lock:
                    number = next(numbers, None)
                if number is None:
                    return
                name = f"lattice:{SEED}:{number}"
                told = worker.ask(name)
                with self.lock:
                    self.add(name, told)

    def add(self, name: str, told: Told | None) -> None:
        if told is None:
            self.endless.append(name)
            return
        self.counts.update(told["counts"])
        self.worst = max(self.worst, told["seconds"])
        self.wrong += [f"{name}: {message}" for message in told["messages"]]
        self.false += [f"{name}: {message}" for message in told["false"]]

    def tell(self, findings: Findings, pairs: int) -> None:
        findings.law(
            f"pairs that were not judged within {SECONDS:.0f} s", not self.endless, 0,
            _some(self.endless),
        )  # fmt: skip
        findings.law("disagreements with the judge", not self.wrong, 0, _some(self.wrong))
        findings.law("certificates of what is false", not self.false, 0, _some(self.false))
        judged = self.counts["judged"] + len(self.endless)
        findings.equal("pairs put before the judge", pairs, judged)
        for what in ("a thin operand", "holes", "several parts", "certified"):
            findings.target(f"pairs with {what}", self.counts[what] > 0, "some", self.counts[what])
        findings.figures |= dict(sorted(self.counts.items()))
        findings.figures["most seconds for a pair"] = round(self.worst, 2)


def _some(names: list[str]) -> str:
    return "; ".join([str(len(names)), *names[:3]])


class Worker:
    """A process that judges pairs, killed and restarted after a slow pair."""

    def __init__(self) -> None:
        self._start()

    def _start(self) -> None:
        context = get_context("spawn")
        self._pipe, other = context.Pipe()
        self._process = context.Process(target=work, args=(other,), daemon=True)
        self._process.start()
        other.close()
        self._pipe.recv()

    def ask(self, name: str) -> Told | None:
        """The judgement; None without an answer within SECONDS."""
        self._pipe.send(name)
        try:
            if self._pipe.poll(SECONDS):
                told: Told = self._pipe.recv()
                return told
        except EOFError:
            pass
        child.end(self._process)
        self._start()
        return None

    def __enter__(self) -> Worker:
        return self

    def __exit__(self, *_: object) -> None:
        child.end(self._process)


def work(pipe: Connection) -> None:
    """A worker's loop."""
    child.begin()
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    with SampledEvents() as sampled:
        pipe.send("ready")
        while True:
            try:
                name = pipe.recv()
            except EOFError:
                return
            pipe.send(judged(name, sampled))


def judged(name: str, sampled: SampledEvents) -> Told:
    """Judges one pair: counts, disagreements with the judge, intervals certified although they have
    an event."""
    began = time.perf_counter()
    case = load_in_plane(CaseName(name, "lattice"))
    counts = Counter({"judged": 1}) + _shape(case)
    try:
        truth = sampled.events(case)
        assert isinstance(truth, Events)
        messages = judge(case, sampled).messages
    except Exception as error:  # noqa: BLE001 a fault of either side, whatever it is
        messages, truth = [f"{type(error).__name__}: {message_of(error)}"], None
    seconds = time.perf_counter() - began
    false: list[str] = []
    if truth is not None:
        hidden = sum(event.same for event in truth.events)
        counts["boundary events"] += len(truth.events)
        counts["events that only show at their scale"] += hidden
        if hidden or int(name.rpartition(":")[2]) % CERTIFIED == 0:
            counts["certified"] += 1
            false = false_certificates(case, truth, counts)
    return {"counts": counts, "messages": messages, "false": false, "seconds": seconds}


def _shape(case: Case) -> Counter[str]:
    texts = (case.P_json, case.Q_json)
    regions = case.P.is_region and case.Q.is_region
    return Counter({
        "a thin operand": int(not regions),
        "holes": int(any('"holes":[[' in text for text in texts)),
        "several parts": int(any(text.count('"outer"') > 1 for text in texts)),
    })  # fmt: skip


def false_certificates(case: Case, truth: Events, counts: Counter[str]) -> list[str]:
    """Tries to certify the absence of events in intervals: true between two events, false across
    some."""
    dice = random.Random(f"intervals {case.name.text}")
    scales = [event.s for event in truth.events]
    ends = [Fraction(0), *scales, 2 * max(scales, default=Fraction(1))]
    middles = [(a + b) / 2 for a, b in pairwise(ends)]
    across = list(pairwise(middles))
    hidden = [across[k] for k, event in enumerate(truth.events) if event.same]
    between = list(pairwise(scales))
    half = MOST_INTERVALS // 2
    chosen = list(dict.fromkeys([*hidden, *dice.sample(across, len(across))]))[:half]
    chosen += dice.sample(between, len(between))[:half]
    false = []
    for a, b in chosen:
        has_event = any(a < s < b for s in scales)
        try:
            Certificate(case.P, case.Q).interval(a, b)
        except NoProof:
            counts["intervals refused"] += 1
            if not has_event:
                false.append(f"no proof that there is no event in ({a}, {b})")
            continue
        counts["intervals certified"] += 1
        if has_event:
            false.append(f"there is an event in ({a}, {b})")
    return false
