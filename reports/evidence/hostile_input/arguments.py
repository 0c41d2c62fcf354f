"""Calls every function, class and method of the extension module with nonsense arguments."""

from __future__ import annotations

import os
import random
import re
import resource
import signal
from collections import Counter
from collections.abc import Callable
from typing import Any

from minkref import _core
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

RESTS_ON = ("bindings/", "minkref/", "reference/", "formats/", "certify/")
MINUTES = Minutes(0.05, 1, 20)

SEED = 20120524
CALLS = Counts(150, 2_000, 40_000)
BATCH = 40  # calls in one process
CPU_SECONDS = 20  # per batch; stops a function that faces years of work
BYTES = 6 << 30
SHOWN = 5
LEFT_OUT = {"set_memory_limit", "filter_trial", "open", "save"}  # settings, years of work, files

FRAME = (
    '{"polygons":[{"outer":[[0,0],[4,0],[4,4],[0,4]],"holes":[[[1,1],[1,2],[2,2],[2,1]]]}]}',
    '{"polygons":[{"outer":[[0,0],[1,0],[0,1]]}]}',
    '{"polygons":[{"outer":[[0,0],[1,1],[1,0],[0,1]]}]}',
    '{"polygons":[]}',
    '{"polygons":[{"outer":[["1e300",0],["1e-300","1/3"],[0,"-1e300"]]}]}',
)
CORNERS = [("0", "0", "0"), ("1", "0", "0"), ("0", "1", "0"), ("0", "0", "1")]
FACES = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
TEXTS = [
    *("", "1", "0", "-1", "7/5", "1/0", "1e9999", "1e-9999", "x", "\0", "\ud800", "P", "Q", "S"),
    *("paper", "winding", "pair", "parallel", "triple", "hole", "component", "corrected", "double"),
    *("rational", "homogeneous", "track", "json", "wkt", "traversal", "mpfr:53", "interval"),
]
INTEGERS = [0, 1, 2, 5, 100, 2**31, 2**32 - 1, 2**40, -1, 2**63, 2**64 - 1, 10**30]
LISTS: list[Any] = [
    *([], [0], [5], [2**32 - 1], [-1], [0, 0], ["1"], ["x", "1/2"], ["0"], CORNERS, FACES),
    *([[0, 1, 99]], [[]], ("1", "1", "1"), ("0", "0", "0"), ("-1", "1", "x"), ("1", "2"), [()]),
]
OTHERS: list[Any] = [None, True, 1.5, float("nan"), float("inf"), b"1", {}, {"a": 1}, object()]


def hands_back(*_: Any) -> None:
    """A function to be called back."""


def objects() -> list[Any]:
    frame, triangle, bow, empty, wide = (_core.PolygonSet.from_json(text) for text in FRAME)
    solid = _core.Polyhedron(CORNERS, FACES)
    convex = _core.ConvexPolyhedron(solid)
    index = _core.ScaleIndex(frame, triangle, "1/2", "2")
    return [
        *(frame, triangle, bow, empty, wide, solid, _core.Polyhedron([], []), convex, index),
        *(index.rings("1", form) for form in ("double", "rational", "homogeneous", "track")),
        _core.ScaleIndex(empty, triangle, "1/2", "2"),
        _core.DynamicSum(frame, triangle, "1/2", "2"),
        _core.DynamicSum(empty, empty, None, None),
        _core.ArrangementEvents(frame, triangle, "1/2", "2"),
        _core.pair_events(frame, triangle, "1/2", "2", "pair", "corrected"),
        _core.minkowski_sum(frame, triangle, "1"),
        _core.convex_sum(convex, convex, ("1", "1", "1")),
        _core.DynamicConvexSum(convex, convex, ("1", "1", "1")),
        *(_core.Prover(frame, triangle), _core.ContactSearch(bow, triangle)),
    ]


def callables(made: list[Any]) -> list[tuple[str, Callable[..., Any], list[str]]]:
    """Name, function, and the argument types in its signature."""
    found = []
    for name in sorted(vars(_core)):
        each = getattr(_core, name)
        is_error = isinstance(each, type) and issubclass(each, BaseException)
        if not name.startswith("_") and callable(each) and not is_error:
            found.append((name, each, types(each) or types(each.__init__)))
    for k, one in enumerate(made):
        for name in sorted(dir(type(one))):
            if name.startswith("__") and name not in ("__len__", "__setstate__"):
                continue
            what = getattr(type(one), name)

            def call(*given: Any, one: Any = one, name: str = name) -> Any:
                value = getattr(one, name)
                return value(*given) if callable(value) else value

            found.append((f"{type(one).__name__}[{k}].{name}", call, types(what)))
    return [each for each in found if not LEFT_OUT & {each[0], each[0].rpartition(".")[2]}]


def types(function: Any) -> list[str]:
    signature = getattr(function, "__nb_signature__", None)
    if not signature:
        return []
    inside = signature[0][0].partition("(")[2].rpartition(") ->")[0]
    return [part for part in re.split(r", (?=\w+:)", inside) if part and part != "self"]


def drawn(dice: random.Random, kind: str, made: list[Any]) -> Any:
    """A value, most often of the kind."""
    if dice.random() < 0.15:
        return dice.choice([*TEXTS, *INTEGERS, *LISTS, *OTHERS, *made])
    if "Sequence" in kind or "list" in kind or "tuple" in kind:
        return dice.choice(LISTS)
    if "Callable" in kind:
        return hands_back
    if "str" in kind:
        return dice.choice(TEXTS)
    if "int" in kind:
        return dice.choice(INTEGERS)
    return dice.choice(made)


def outcomes(batch: list[tuple[str, Callable[..., Any], list[Any]]]) -> list[str]:
    """The calls' outcomes from a child process: ok, or an exception's name; at the end a signal."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
            resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 5))
            signal.signal(signal.SIGXCPU, signal.SIG_DFL)
            for _, function, given in batch:
                gave = "ok"
                try:
                    function(*given)
                except BaseException as error:  # noqa: BLE001
                    gave = type(error).__name__
                os.write(writer, gave.encode() + b"\n")
        finally:
            os._exit(0)
    os.close(writer)
    with os.fdopen(reader) as told:
        said = told.read().splitlines()
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        said.append("long" if number == signal.SIGXCPU else signal.Signals(number).name)
    return said


def run(findings: Findings, size: Size) -> None:
    dice = random.Random(SEED)
    made = objects()
    every = callables(made)
    told: Counter[str] = Counter()
    ended: list[str] = []
    calls = 0
    while calls < (size.of(CALLS)):
        batch = []
        for _ in range(BATCH):
            name, function, kinds = dice.choice(every)
            count = len(kinds) if dice.random() < 0.9 else dice.randrange(len(kinds) + 2)
            given = [drawn(dice, [*kinds, "", ""][k], made) for k in range(count)]
            batch.append((name, function, given))
        said = outcomes(batch)
        calls += len(said)
        told.update(said)
        if len(said) <= len(batch) and said[-1].startswith("SIG"):
            name, _, given = batch[len(said) - 1]
            ended.append(f"{said[-1]} by {name}({', '.join(str(each)[:60] for each in given)})")
        internal = [k for k, each in enumerate(said) if each in ("SystemError", "SystemExit")]
        ended += [f"{said[k]} by {batch[k][0]}" for k in internal]
    findings.figures = {
        "seed": SEED,
        "callables": len(every),
        "calls": calls,
        "outcomes": dict(sorted(told.items())),
    }
    shown = "; ".join(ended[:SHOWN]) or f"none in {calls:,}"
    findings.law("calls that end the process", not ended, "none", shown)
    findings.law("calls that give a value", told["ok"] > calls // 10, calls // 10, told["ok"])
