"""Ctrl-C, and the limit of memory, end long work in C++ soon."""

from __future__ import annotations

import math
import os
import signal
import threading
import time
from collections.abc import Callable

import pytest
from long_works import comb, prepare, star, works
from minkref import _core
from thoroughness import draws

SOON = 0.2  # seconds of this thread's processor: others may have the machine
UNTIL = draws(50, 200) / 1000  # seconds, some fifth of the shortest work
GROWING = (
    "sum, paper",
    "sum, winding",
    "erosion",
    "dynamic sum",
    "arrangement events",
    "index",
    "pair events",
    "scene, sums",
    "validation, slivers",
    "reading off",
    "the paper, update in space",
    "the exact sum beside that of the paper",
    "the paper, update with a disc",
    "features",
)


def seconds_to_end(work: Callable[[], object], until: float = UNTIL) -> float:
    """From an interrupt to the end of the work; infinite where the work was over before it came, as
    may be on a busy machine. No interrupt is left to end the tests."""
    clock = time.pthread_getcpuclockid(threading.get_ident())
    sent = []

    def send() -> None:
        sent.append(time.clock_gettime(clock))
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(until, send)
    over = False
    timer.start()
    try:
        work()
        over = True
        timer.cancel()
        timer.join()
        time.sleep(0.01)
    except KeyboardInterrupt:
        ended = time.clock_gettime(clock)
        timer.join()
        return math.inf if over else ended - sent[0]
    return math.inf


@pytest.mark.parametrize("name", works())
def test_an_interrupt_ends_work_within_a_fifth_of_a_second(name: str) -> None:
    """The shortest of three: what others do to the caches makes a thread's own time longer too."""
    prepare(name)
    assert any(seconds_to_end(works()[name]) < SOON for _ in range(3))


def test_operands_are_whole_after_an_interrupt() -> None:
    P, Q = star(200), comb(150)
    before = P.to_json(), Q.to_json()
    assert any(
        seconds_to_end(lambda: _core.minkowski_sum(P, Q, "1", "winding"), 0.2) < math.inf
        for _ in range(3)
    )
    assert (P.to_json(), Q.to_json()) == before
    small = _core.minkowski_sum(star(5), comb(3), "1")
    assert small.region.canonical_json() == (
        _core.minkowski_sum(star(5), comb(3), "1", "definition").region.canonical_json()
    )


@pytest.mark.parametrize("name", GROWING)
def test_a_limit_of_memory_ends_work_with_a_refusal(name: str) -> None:
    prepare(name)
    _core.set_memory_limit(1 << 20)  # less than the interpreter has
    try:
        with pytest.raises(
            _core.LimitExceeded, match=r"memory than it may have|at the least"
        ) as refused:
            works()[name]()
    finally:
        _core.set_memory_limit(0)
    assert refused.value.code == "memory-limit"


def test_without_a_limit_there_is_what_the_system_has() -> None:
    with open("/proc/meminfo") as file:
        total = next(int(line.split()[1]) << 10 for line in file if line.startswith("MemTotal"))
    assert 1 << 26 < _core.memory_limit() < total


def resident() -> int:
    with open("/proc/self/status") as file:
        return next(int(line.split()[1]) << 10 for line in file if line.startswith("VmRSS"))


@pytest.mark.parametrize("route", ["paper", "winding", "definition"])
def test_what_cannot_fit_is_refused_before_the_work(route: str) -> None:
    began = time.thread_time()
    with pytest.raises(_core.LimitExceeded, match=r"edges of the convolution|pairs of triangles"):
        _core.set_memory_limit(resident() + (300 << 20))
        try:
            _core.minkowski_sum(star(1500), star(1499), "1", route)
        finally:
            _core.set_memory_limit(0)
    assert time.thread_time() - began < 2
