"""Timed tools for sums of arbitrary polyhedra: each tool runs warm in a child process; only the
call counts, from operands to result, both in the tool's own form."""

from __future__ import annotations

import multiprocessing
import os
import resource
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from multiprocessing.connection import Connection
from pathlib import Path
from statistics import median

from minkref import _core
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.isolation.process_tree import tree_seconds
from minkref.fuzz.judges.space.space_manifold import MANIFOLD, ManifoldJudge
from minkref.fuzz.judges.space.space_nef import NEF, NefJudge
from minkref.fuzz.judges.space.space_routes import core_polyhedron
from minkref.fuzz.space.generators.machined import plate
from minkref.fuzz.targets.answer import Limits

THREADS = 2
LIMITS = Limits(bytes=8 << 30, output=1 << 30)
AGAIN = 1.0  # seconds; shorter calls are made three times, for the median
START_SECONDS = 60.0
VOLUME_BITS = 200  # bits kept


@dataclass(frozen=True)
class Timed:
    """`seconds` is None without an answer; `why` then gives the reason. `processor` is the
    processor time of all threads; another tool's time includes taking operands and giving a result.
    `text` is the canonical JSON; `volume` lies within a relative 2^-200 of the exact volume, or
    comes from doubles; both are None if unknown. `others` is the machine share that other programs
    took meanwhile."""

    seconds: float | None = None
    why: str = ""
    text: str | None = None
    volume: Fraction | float | None = None
    processor: float | None = None
    others: float = 0.0


Call = Callable[[Polyhedron, Polyhedron], Timed]


class Tools:
    """minkref on two threads, CGAL's Nef polyhedra and Manifold, with a time limit for each call.
    Use a `with`."""

    def __init__(self, seconds: float, nef_seconds: float | None = None) -> None:
        self._exact = _Exact(seconds)
        self._nef = NefJudge(nef_seconds or seconds, LIMITS)
        self._manifold = ManifoldJudge(seconds, LIMITS)
        absences = ((NEF, self._nef.absence), (MANIFOLD, self._manifold.absence))
        self.absent = {name: why for name, why in absences if why}
        self._warm: set[str] = set()

    def __enter__(self) -> Tools:
        return self

    def __exit__(self, *_: object) -> None:
        for tool in (self._exact, self._nef, self._manifold):
            tool.close()

    def exact(self, P: Polyhedron, Q: Polyhedron) -> Timed:
        return self._timed("minkref", self._exact.ask, P, Q)

    def nef(self, P: Polyhedron, Q: Polyhedron) -> Timed:
        return self._timed(NEF, self._ask_nef, P, Q)

    def manifold(self, P: Polyhedron, Q: Polyhedron) -> Timed:
        return self._timed(MANIFOLD, self._ask_manifold, P, Q)

    def _timed(self, name: str, call: Call, P: Polyhedron, Q: Polyhedron) -> Timed:
        """The first answer with the median time. Warms up the tool before, and again after a call
        without an answer."""
        if name in self.absent:
            return Timed(why=self.absent[name])
        if name not in self._warm:
            call(plate(2, 3, 4), plate(1, 1, 2))
            self._warm.add(name)
        first = _watched(call, P, Q)
        if first.seconds is None:
            self._warm.discard(name)
        if first.seconds is None or first.seconds >= AGAIN:
            return first
        calls = [first, *(_watched(call, P, Q) for _ in range(2))]
        times = [each.seconds for each in calls if each.seconds is not None]
        return replace(first, seconds=median(times), others=max(each.others for each in calls))

    def _ask_nef(self, P: Polyhedron, Q: Polyhedron) -> Timed:
        start = _processor_seconds()
        answer = self._nef.timed_sum(P, Q)
        processor = _processor_seconds() - start
        return Timed(answer.seconds, answer.why, answer.text, processor=processor)

    def _ask_manifold(self, P: Polyhedron, Q: Polyhedron) -> Timed:
        start = _processor_seconds()
        answer = self._manifold.volume(P, Q)
        processor = _processor_seconds() - start
        return Timed(answer.seconds, answer.why, volume=answer.volume, processor=processor)


def _watched(call: Call, P: Polyhedron, Q: Polyhedron) -> Timed:
    start, before = time.perf_counter(), _seconds_of_others()
    answer = call(P, Q)
    spent = (time.perf_counter() - start) * (os.cpu_count() or 1)
    return replace(answer, others=max(0.0, (_seconds_of_others() - before) / spent))


def _seconds_of_others() -> float:
    """Processor time of all programs on the machine except this process and its children."""
    words = Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:]
    busy = sum(int(word) for word in (*words[:3], *words[5:8])) / os.sysconf("SC_CLK_TCK")
    return busy - _processor_seconds() - time.process_time()


def _processor_seconds() -> float:
    """Processor seconds of all children, including ended children."""
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return tree_seconds(os.getpid()) + ended.ru_utime + ended.ru_stime


def _rounded(volume: Fraction) -> Fraction:
    """The volume with some hundred bits, enough for doubles; exact volumes have thousands of
    digits."""
    shift = max(0, VOLUME_BITS - volume.numerator.bit_length() + volume.denominator.bit_length())
    return Fraction(round(volume * 2**shift), 2**shift)


class _Exact:
    """minkref as a child process, ended when it takes too long."""

    def __init__(self, seconds: float) -> None:
        self._seconds = seconds
        self._child: multiprocessing.process.BaseProcess | None = None
        self._ends: Connection | None = None

    def ask(self, P: Polyhedron, Q: Polyhedron) -> Timed:
        if self._child is None or self._ends is None:
            context = multiprocessing.get_context("spawn")
            self._ends, theirs = context.Pipe()
            self._child = context.Process(target=_serve, args=(theirs,), daemon=True)
            self._child.start()
            theirs.close()
            if not self._ends.poll(START_SECONDS):
                self.close()
                return Timed(why="its process did not start")
            self._ends.recv()
        self._ends.send((P, Q))
        if not self._ends.poll(self._seconds):
            self.close()
            return Timed(why=f"no answer in {self._seconds:g} s")
        try:
            answer: Timed = self._ends.recv()
        except EOFError:
            self.close()
            return Timed(why="it ended")
        return answer

    def close(self) -> None:
        if self._child is not None and self._ends is not None:
            self._ends.close()
            self._child.kill()
            self._child.join()
        self._child = self._ends = None


def _serve(ends: Connection) -> None:
    """Reports readiness, then sums until the pipe closes."""
    sys.set_int_max_str_digits(0)  # exact volumes have as many digits as they need
    ends.send(None)
    while True:
        try:
            P, Q = ends.recv()
        except EOFError:
            return
        first, second = core_polyhedron(P), core_polyhedron(Q)
        start, processor = time.perf_counter(), time.process_time()
        try:
            found = _core.edge_sum_in_space(first, second, ("1", "1", "1"), THREADS)
        except (_core.BadInput, _core.LimitExceeded, RuntimeError, ValueError) as error:
            ends.send(Timed(why=f"{type(error).__name__}: {error}"))
            continue
        seconds, processor = time.perf_counter() - start, time.process_time() - processor
        volume = _rounded(Fraction(found.volume()))
        ends.send(Timed(seconds, "", found.canonical_json(), volume, processor))
