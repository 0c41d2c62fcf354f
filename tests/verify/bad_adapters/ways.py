"""Ways to misbehave, each a class that changes one step of a right adapter."""

from __future__ import annotations

import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

from adapter import CAPABILITIES, Adapter, Set

WAYS: dict[str, Callable[[], Adapter]] = {"right": Adapter}
FOREVER = 3600


def way(name: str) -> Callable[[type[Adapter]], type[Adapter]]:
    def enter(kind: type[Adapter]) -> type[Adapter]:
        WAYS[name] = kind
        return kind

    return enter


def instead(verb: str, act: Callable[[Adapter, Set], Any]) -> Callable[[], Adapter]:
    """Does something else at this verb, and answers nothing more."""
    return _acting(verb, act, answers=False)


def also(verb: str, act: Callable[[Adapter, Set], Any]) -> Callable[[], Adapter]:
    """Before the right answer to this verb, something else is done."""
    return _acting(verb, act, answers=True)


def _acting(verb: str, act: Callable[[Adapter, Set], Any], answers: bool) -> Callable[[], Adapter]:
    class Acting(Adapter):
        def handle(self, request: Set) -> None:
            acts = request["verb"] == verb
            if acts:
                act(self, request)
            if answers or not acts:
                super().handle(request)

    return Acting


def says(verb: str, line: Callable[[Adapter, Set], str | bytes]) -> Callable[[], Adapter]:
    """Another line is the answer to this verb."""

    def act(adapter: Adapter, request: Set) -> None:
        text = line(adapter, request)
        adapter.write((text if isinstance(text, bytes) else text.encode()) + b"\n")

    return instead(verb, act)


def declares(**members: Any) -> Callable[[], Adapter]:
    class Declares(Adapter):
        def hello(self) -> Set:
            value = {**super().hello(), **members}
            return {name: member for name, member in value.items() if member is not None}

    return Declares


def results(change: Callable[[Set, Adapter], Any], **members: Any) -> Callable[[], Adapter]:
    """The members of a right result, changed."""

    class Results(declares(**members)):  # type: ignore[misc]
        def sum_of(self, sP: Set, Q: Set) -> Any:
            return change(super().sum_of(sP, Q), self)

    return Results


def die(*number: int) -> None:
    os.kill(os.getpid(), *number)
    time.sleep(FOREVER)


def hang(*_: Any) -> None:
    time.sleep(FOREVER)


# --- the adapter ends, or never answers
for verb in ("hello", "load", "at"):
    WAYS[f"hangs-at-{verb}"] = instead(verb, hang)
    WAYS[f"segv-at-{verb}"] = instead(verb, lambda a, r: die(signal.SIGSEGV))
    WAYS[f"abort-at-{verb}"] = instead(verb, lambda a, r: die(signal.SIGABRT))
    WAYS[f"exit-0-at-{verb}"] = instead(verb, lambda a, r: os._exit(0))
    WAYS[f"exit-3-at-{verb}"] = instead(verb, lambda a, r: os._exit(3))


@way("ends-at-once")
class EndsAtOnce(Adapter):
    def serve(self) -> None:
        return


@way("dies-with-a-log")
class DiesWithALog(Adapter):
    def at(self, request: Set) -> Set:
        sys.stderr.write("noise\n" * 1000 + "the last words \x1b[31m<b>\n")
        sys.stderr.flush()
        os._exit(7)


def half_line(adapter: Adapter, request: Set) -> None:
    text = adapter.line(request)
    adapter.write(text[: len(text) // 2])


WAYS["half-a-line-then-hangs"] = instead("at", lambda a, r: (half_line(a, r), hang()))
WAYS["half-a-line-then-segv"] = instead("at", lambda a, r: (half_line(a, r), die(signal.SIGSEGV)))
WAYS["half-a-line-then-exit-0"] = instead("at", lambda a, r: (half_line(a, r), os._exit(0)))
WAYS["answers-and-dies"] = instead("at", lambda a, r: (a.write(a.line(r) + "\n"), os._exit(0)))
WAYS["no-newline-and-dies"] = instead("at", lambda a, r: (a.write(a.line(r)), os._exit(0)))


# --- lines that are no answers
def with_numbers(text: str) -> Callable[[Adapter, Set], str]:
    ring = f"[[0, 0], [{text}, 0], [0, 1]]"
    return lambda a, r: (
        f'{{"seq": {r["seq"]}, "status": "result", "polygons": [{{"outer": {ring}}}]}}'
    )


def result_of(members: Set) -> Callable[[Adapter, Set], str]:
    return lambda a, r: json.dumps({"seq": r["seq"], "status": "result", **members})


NO_ANSWERS: dict[str, Callable[[Adapter, Set], str | bytes]] = {
    "garbage": lambda a, r: bytes(range(1, 10)) + b"\xff\xfe\x00" * 7,
    "not-utf8": lambda a, r: a.line(r).encode()[:-1] + b', "note": "\xff\xe9"}',
    "empty-line": lambda a, r: "",
    "array": lambda a, r: "[1, 2, 3]",
    "null": lambda a, r: "null",
    "text": lambda a, r: '"result"',
    "deep": lambda a, r: "[" * 200_000,
    "deep-and-closed": lambda a, r: "[" * 200_000 + "]" * 200_000,
    "deep-in-an-answer": lambda a, r: (
        f'{{"seq": {r["seq"]}, "status": "result", "polygons": {"[" * 9000 + "]" * 9000}}}'
    ),
    "nan": with_numbers("NaN"),
    "infinity": with_numbers("-Infinity"),
    "1e400": with_numbers("1e400"),
    "seq-wrong": lambda a, r: json.dumps({**a.answer(r), "seq": r["seq"] + 1}),
    "seq-before": lambda a, r: json.dumps({**a.answer(r), "seq": r["seq"] - 1}),
    "seq-text": lambda a, r: json.dumps({**a.answer(r), "seq": str(r["seq"])}),
    "seq-float": lambda a, r: json.dumps({**a.answer(r), "seq": r["seq"] + 0.5}),
    "seq-true": lambda a, r: json.dumps({**a.answer(r), "seq": True}),
    "seq-missing": lambda a, r: json.dumps(a.answer(r)),
    "seq-long": lambda a, r: f'{{"seq": {"9" * 10_000}, "status": "result"}}',
    "status-missing": lambda a, r: json.dumps({"seq": r["seq"], "polygons": []}),
    "status-unknown": lambda a, r: json.dumps({"seq": r["seq"], "status": "fine"}),
    "status-list": lambda a, r: json.dumps({"seq": r["seq"], "status": ["result"]}),
    "no-set": result_of({}),
    "polygons-text": result_of({"polygons": "square"}),
    "polygons-null": result_of({"polygons": None}),
    "ring-text": result_of({"rings": ["square"]}),
    "outer-missing": result_of({"polygons": [{"holes": []}]}),
    "space-in-the-plane": result_of({"vertices": [], "faces": []}),
    "indices-out-of-range": result_of(
        {"vertices": [["0", "0", "0"], ["1", "0", "0"], ["0", "1", "0"]], "faces": [[0, 1, 99]]}
    ),
    "points-of-three": result_of({"rings": [[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]}),
    "zero-denominator": result_of({"rings": [[["1/0", 0], [1, 0], [0, 1]]]}),
    "number-words": result_of({"rings": [[["one", 0], [1, 0], [0, 1]]]}),
    "number-true": result_of({"rings": [[[True, 0], [1, 0], [0, 1]]]}),
}
for name, line in NO_ANSWERS.items():
    WAYS[f"says-{name}"] = says("at", line)
for name in ("garbage", "not-utf8", "array", "deep", "seq-wrong", "status-unknown", "seq-long"):
    WAYS[f"greets-{name}"] = says("hello", NO_ANSWERS[name])
    WAYS[f"loads-{name}"] = says("load", NO_ANSWERS[name])
WAYS["says-million-digits"] = says("at", with_numbers("1" + "0" * 1_000_000))
WAYS["says-million-digits-in-text"] = says("at", with_numbers('"' + "7" * 1_000_000 + '"'))
WAYS["says-10-to-400"] = says("at", with_numbers("1" + "0" * 400))
WAYS["says-exponent"] = says("at", with_numbers('"1e999999999"'))
WAYS["says-exponent-number"] = says("at", with_numbers("1e999999999"))

# --- unrequested lines
WAYS["answers-twice"] = also("at", lambda a, r: a.write(a.line(r) + "\n"))


@way("answers-before-any-request")
class AnswersBefore(Adapter):
    def serve(self) -> None:
        self.write('{"seq": 1, "status": "result", "polygons": []}\n')
        super().serve()


@way("prints-before-hello")
class PrintsBefore(Adapter):
    def serve(self) -> None:
        self.write("Welcome to the library!\n")
        super().serve()


@way("unsolicited-line-later")
class UnsolicitedLater(Adapter):
    def handle(self, request: Set) -> None:
        super().handle(request)
        if request["verb"] == "at":
            time.sleep(0.1)
            self.write('{"seq": 0, "status": "result", "polygons": []}\n')


# --- floods, and pipes that nobody reads
def flood(number: int, size: int = 1 << 30) -> None:
    part = b"x" * (1 << 20)
    for _ in range(size // len(part)):
        os.write(number, part)


WAYS["gigabyte-without-a-newline"] = instead("at", lambda a, r: flood(1))
WAYS["gigabyte-of-log"] = also("at", lambda a, r: flood(2))
WAYS["log-without-end"] = instead("at", lambda a, r: flood(2, 1 << 50))


@way("fills-log-and-reads-nothing")
class FillsLog(Adapter):
    def serve(self) -> None:
        flood(2, 16 << 20)
        hang()


@way("reads-nothing")
class ReadsNothing(Adapter):
    def serve(self) -> None:
        hang()


def close(number: int) -> Callable[[Adapter, Set], None]:
    return lambda a, r: (os.close(number), hang())  # type: ignore[return-value]


WAYS["closes-stdout-and-lives"] = instead("at", close(1))
WAYS["closes-stdin-and-lives"] = also("at", lambda a, r: os.close(0))
WAYS["closes-everything-and-lives"] = instead("at", lambda a, r: (os.closerange(0, 100), hang()))


def fill_memory(*_: Any) -> None:
    parts = []
    while True:
        parts.append(b"x" * (1 << 24))


WAYS["memory-without-end"] = instead("at", fill_memory)
WAYS["memory-at-hello"] = instead("hello", fill_memory)


# --- processes
def fork_and_sleep(deaf: bool = False, apart: bool = False) -> None:
    if os.fork() == 0:
        if apart:
            os.setsid()
            if os.fork():
                os._exit(0)
        if deaf:
            signal.signal(signal.SIGTERM, signal.SIG_IGN)
        time.sleep(FOREVER)
        os._exit(0)


WAYS["child-holds-the-pipes"] = instead("at", lambda a, r: (fork_and_sleep(), os._exit(3)))
WAYS["child-apart-holds-the-pipes"] = instead(
    "at", lambda a, r: (fork_and_sleep(deaf=True, apart=True), os._exit(3))
)
WAYS["children-and-right"] = also("at", lambda a, r: fork_and_sleep(deaf=True))
WAYS["children-apart-and-right"] = also("at", lambda a, r: fork_and_sleep(True, True))
WAYS["kills-parent"] = also("at", lambda a, r: os.kill(os.getppid(), signal.SIGKILL))
WAYS["kills-parent-at-hello"] = also("hello", lambda a, r: os.kill(os.getppid(), signal.SIGKILL))
WAYS["stops-parent"] = also("at", lambda a, r: os.kill(os.getppid(), signal.SIGSTOP))
WAYS["kills-group"] = instead("at", lambda a, r: os.killpg(0, signal.SIGKILL))
WAYS["stops-itself"] = instead("at", lambda a, r: die(signal.SIGSTOP))


@way("deaf-to-sigterm")
class Deaf(Adapter):
    def serve(self) -> None:
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        super().serve()
        hang()

    def handle(self, request: Set) -> None:
        if request["verb"] == "stop":
            hang()
        super().handle(request)


# --- declarations
WAYS["skips-what-it-declares"] = says(
    "at", lambda a, r: json.dumps({"seq": r["seq"], "status": "skipped", "reason": "not today"})
)
WAYS["rejects-valid-input"] = says(
    "at", lambda a, r: json.dumps({"seq": r["seq"], "status": "rejected", "reason": "no"})
)
WAYS["rejects-at-load"] = says(
    "load", lambda a, r: json.dumps({"seq": r["seq"], "status": "rejected", "reason": "no"})
)
WAYS["errs"] = says(
    "at", lambda a, r: json.dumps({"seq": r["seq"], "status": "errored", "reason": "\x1b[2J"})
)
WAYS["errs-without-a-reason"] = says(
    "at", lambda a, r: json.dumps({"seq": r["seq"], "status": "errored"})
)
WAYS["accepts-invalid-input"] = declares(capabilities=[*CAPABILITIES.split(), "rejects-invalid"])
WAYS["space-only"] = declares(capabilities=["space", "non-convex", "holes"])
WAYS["capability-unknown"] = declares(capabilities=[*CAPABILITIES.split(), "teleport"])
WAYS["capabilities-text"] = declares(capabilities="plane")
WAYS["capabilities-numbers"] = declares(capabilities=[1, None])
WAYS["capabilities-missing"] = declares(capabilities=None)
WAYS["capabilities-empty"] = declares(capabilities=[])
WAYS["protocol-v9"] = declares(protocol="adapter-v9")
WAYS["protocol-missing"] = declares(protocol=None)
WAYS["protocol-list"] = declares(protocol=["adapter-v1"])
WAYS["name-missing"] = declares(name=None)
WAYS["name-long"] = declares(name="n" * 1_000_000)
WAYS["name-hostile"] = declares(name='<script>alert(1)</script>\x1b[2J\x00\u202e"&\n')
WAYS["version-hostile"] = declares(version="<img src=x onerror=alert(1)>\x07\ud800")
WAYS["numbers-words"] = declares(numbers="words")
WAYS["sum-other"] = declares(sum="difference")
WAYS["arithmetic-number"] = declares(arithmetic=3)
for name, tolerance in {
    "negative": {"absolute": "-1", "relative": "0"},
    "no-number": {"absolute": "small", "relative": "0"},
    "list": ["0", "0"],
    "nan": {"absolute": "NaN", "relative": "0"},
    "long": {"absolute": "1e999999999", "relative": "0"},
    "zero-denominator": {"absolute": "1/0", "relative": "0"},
}.items():
    WAYS[f"tolerance-{name}"] = declares(arithmetic="float64", tolerance=tolerance)
WAYS["hello-slow"] = also("hello", lambda a, r: time.sleep(3))
WAYS["slow"] = also("at", lambda a, r: time.sleep(0.7))


# --- results
def moved(value: Set, distance: Callable[[Fraction], Fraction]) -> Set:
    for polygon in value["polygons"]:
        for ring in (polygon["outer"], *polygon["holes"]):
            for point in ring:
                point[0] = str(distance(Fraction(point[0])))
    return value


def tripled_then_rounded(value: Set, adapter: Adapter) -> Set:
    return moved(value, lambda x: Fraction(float(x / 3)) * 3)


WAYS["exact-but-rounds"] = results(tripled_then_rounded)
WAYS["float-within"] = results(
    lambda v, a: moved(v, lambda x: x + Fraction(1, 10**9)),
    arithmetic="float64",
    tolerance={"absolute": "1e-8", "relative": "0"},
)
WAYS["float-beyond"] = results(
    lambda v, a: moved(v, lambda x: x + Fraction(1, 10**7)),
    arithmetic="float64",
    tolerance={"absolute": "1e-8", "relative": "0"},
)
WAYS["another-each-time"] = results(
    lambda v, a: moved(v, lambda x: x + random.SystemRandom().randint(1, 10**6))
)
WAYS["wrong-the-second-time"] = results(
    lambda v, a: moved(v, lambda x: x + (1 if a.calls % 2 == 0 else 0))
)


@way("drifts")
class Drifts(Adapter):
    """Every update adds a little, and the next one adds to that."""

    drift = 0

    def hello(self) -> Set:
        return {**super().hello(), "capabilities": [*CAPABILITIES.split(), "update"]}

    def at(self, request: Set) -> Set:
        self.drift = 0
        return super().at(request)

    def update(self, request: Set) -> Set:
        self.drift += 1
        value = self.sum_of(request["sP"], self.Q)
        return {"status": "result", **moved(value, lambda x: x + Fraction(self.drift, 1000))}


@way("updates")
class Updates(Adapter):
    def hello(self) -> Set:
        return {**super().hello(), "capabilities": [*CAPABILITIES.split(), "update"]}


@way("refuses-to-update")
class RefusesToUpdate(Updates):
    def update(self, request: Set) -> Set:
        return {"status": "skipped", "reason": "no"}


def plus_ring(*points: tuple[int, int]) -> Callable[[Set, Adapter], Set]:
    ring = [[str(x), str(y)] for x, y in points]
    return lambda v, a: {"polygons": [*v["polygons"], {"outer": ring, "holes": []}]}


WAYS["ring-of-no-point"] = results(plus_ring())
WAYS["ring-of-one-point"] = results(plus_ring((0, 0)))
WAYS["ring-of-two-points"] = results(plus_ring((0, 0), (5000, 5000)))
WAYS["ring-far-away"] = results(plus_ring((5000, 5000), (5001, 5000), (5000, 5001)))
WAYS["rings-none"] = results(lambda v, a: {"rings": []})
WAYS["polygons-twice"] = results(lambda v, a: {"polygons": v["polygons"] * 2})
WAYS["both-forms"] = results(lambda v, a: {**v, "rings": []})
WAYS["vertices-just-within"] = results(
    lambda v, a: {"polygons": [{"outer": parabola(390_000), "holes": []}]}
)
for name, count in {"many-vertices": 410_000, "million-vertices": 1_000_000}.items():
    WAYS[name] = results(
        lambda v, a, count=count: {"polygons": [{"outer": parabola(count), "holes": []}]}
    )


def parabola(count: int) -> list[list[int]]:
    """A convex ring of so many vertices."""
    return [[x, x * x] for x in range(count)]


# Coordinates within the digit limit, whose crossings exceed the limit.
LONG = "9" * 9000
WAYS["long-numbers-that-cross"] = results(
    lambda v, a: {
        "rings": [[["0", "0"], [LONG, "1"], ["1", LONG]], [["2", "0"], [LONG, LONG], ["0", "3"]]]
    }
)
WAYS["rings-that-cross-everywhere"] = results(lambda v, a: {"rings": [star(701)]})


def star(count: int) -> list[list[int]]:
    """Edges between opposite points of a parabola and its mirror image: all cross."""
    points = [[x, 0] for x in range(count)] + [[x * x, 1000] for x in range(count)]
    return [points[k // 2 + (count if k % 2 else 0)] for k in range(2 * count)]


# --- in space
CUBE = {
    "vertices": [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)],
    "faces": [
        [0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3],
    ],
}  # fmt: skip


def in_space(members: Set) -> Callable[[], Adapter]:
    words = ["space", "non-convex", "holes", "components", "touching", "rational"]

    class InSpace(declares(capabilities=words)):  # type: ignore[misc]
        def sum_of(self, sP: Set, Q: Set) -> Any:
            return members

    return InSpace


SPACE: dict[str, Set] = {
    "space-cube": CUBE,
    "space-nothing": {"vertices": [], "faces": []},
    "space-index-out-of-range": {**CUBE, "faces": [[0, 1, 8]]},
    "space-index-negative": {**CUBE, "faces": [[0, 1, -1]]},
    "space-index-float": {**CUBE, "faces": [[0, 1, 2.0]]},
    "space-face-of-two": {**CUBE, "faces": [[0, 1]]},
    "space-face-of-one-vertex": {**CUBE, "faces": [[0, 0, 0]]},
    "space-open": {**CUBE, "faces": CUBE["faces"][:5]},
    "space-twice": {**CUBE, "faces": CUBE["faces"] * 2},
    "space-inside-out": {**CUBE, "faces": [face[::-1] for face in CUBE["faces"]]},
    "space-not-planar": {**CUBE, "vertices": [*CUBE["vertices"][:7], [2, 3, 5]]},
    "space-long-exponent": {**CUBE, "vertices": [*CUBE["vertices"][:7], ["1e999999999", 1, 1]]},
    "space-long-numbers": {**CUBE, "vertices": [*CUBE["vertices"][:7], [LONG, LONG, LONG]]},
    "space-zero-denominator": {**CUBE, "vertices": [*CUBE["vertices"][:7], ["1/0", 1, 1]]},
    "space-plane": {"polygons": []},
    "space-faces-missing": {"vertices": CUBE["vertices"]},
}
for name, members in SPACE.items():
    WAYS[name] = in_space(members)


# --- files
@way("leaves-temporary-files")
class LeavesFiles(Adapter):
    def at(self, request: Set) -> Set:
        for folder in (Path(), Path(os.environ["TMPDIR"])):
            with contextlib.suppress(OSError):
                (folder / f"left-by-a-bad-adapter-{os.getpid()}").write_text("x", encoding="utf-8")
        return super().at(request)


@way("writes-to-the-ledger")
class WritesLedger(Adapter):
    def at(self, request: Set) -> Set:
        with Path(self.argument).open("ab") as ledger:
            ledger.write(b'{"finding": "mine"}\n\xff half a line')
        return super().at(request)


@way("truncates-the-ledger")
class TruncatesLedger(Adapter):
    def at(self, request: Set) -> Set:
        Path(self.argument).write_bytes(b"")
        return super().at(request)


@way("starts-a-daemon")
class StartsADaemon(Adapter):
    def at(self, request: Set) -> Set:
        subprocess.Popen(["sleep", str(FOREVER)], start_new_session=True)
        return super().at(request)
