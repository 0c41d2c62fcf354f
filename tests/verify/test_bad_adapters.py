"""Adapters that misbehave in one way each: charged as docs/adapter-protocol.md says, whatever they
do; the run goes on, ends with a documented exit code, and leaves no process behind."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import uuid
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.commands.schemas import schema
from minkref.errors import Refusal
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.targets.catalogue import select
from minkref.fuzz.targets.declared import declarations_of

FOLDER = Path(__file__).parent / "bad_adapters"
PLANE = ("--family", "random", "--family", "degenerate")
SPACE = ("--family", "space-polycube")
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")


def target(way: str, program: str = "bad_adapter.py") -> str:
    return f"cmd:{sys.executable} {FOLDER / program} {way}"


def left_behind(mark: str) -> list[str]:
    found = []
    for folder in Path("/proc").iterdir():
        try:
            if mark.encode() in (folder / "environ").read_bytes():
                found.append((folder / "cmdline").read_text(encoding="utf-8", errors="replace"))
        except OSError:
            continue
    return found


def verify(
    targets: list[str],
    folder: Path,
    *options: str | Path,
    seconds: int = 60,
    megabytes: int = 1024,
    jobs: int | None = None,
) -> tuple[int, Any]:
    """The document of a run in `folder`, which follows its schema, and leaves nothing running.
    The limit of time is far away unless a test is about it, so that a slow machine tells no lie."""
    mark = uuid.uuid4().hex
    words = [sys.executable, "-m", "minkref", "verify", "--call-seconds", str(seconds), *targets]
    words += ["--no-models", "--call-memory", str(megabytes), "--shrink-calls", "0"]
    words += ["--jobs", str(jobs)] if jobs else []
    words += map(str, options)
    ran = subprocess.run(
        [*words, "--json"],
        env={**os.environ, "MINKREF_TEST_MARK": mark},
        capture_output=True,
        text=True,
        timeout=300,
        cwd=folder,
    )
    assert "Traceback" not in ran.stderr
    value = json.loads(ran.stdout)
    jsonschema.validate(value, schema("verify"))
    assert left_behind(mark) == []
    return ran.returncode, value


def verdicts(value: Any, name: str) -> set[str]:
    return {v for c in value["matrix"] if c["target"] == name for v in c["verdicts"]}


CRASHED = [
    f"{how}-at-{verb}" for how in ("segv", "abort", "exit-0", "exit-3") for verb in ("load", "at")
]
CRASHED += ["dies-with-a-log", "half-a-line-then-segv", "half-a-line-then-exit-0"]
CRASHED += ["no-newline-and-dies", "child-holds-the-pipes", "child-apart-holds-the-pipes"]
CRASHED += ["kills-group"]
ERRORED = [
    f"says-{what}"
    for what in (
        *("garbage", "not-utf8", "empty-line", "array", "null", "text", "deep", "deep-and-closed"),
        *("deep-in-an-answer", "nan", "infinity", "1e400", "seq-wrong", "seq-before", "seq-text"),
        *("seq-float", "seq-true", "seq-missing", "seq-long", "status-missing", "status-unknown"),
        *("status-list", "no-set", "polygons-text", "polygons-null", "ring-text", "outer-missing"),
        *("space-in-the-plane", "points-of-three", "zero-denominator", "number-words"),
        *("number-true", "million-digits", "million-digits-in-text", "exponent"),
    )
]
ERRORED += ["loads-garbage", "loads-deep", "log-without-end"]
ERRORED += ["gigabyte-without-a-newline", "skips-what-it-declares"]
ERRORED += [
    "errs",
    "errs-without-a-reason",
    "both-forms",
    "ring-of-no-point",
    "long-numbers-that-cross",
]
WRONG = ["rejects-valid-input", "rejects-at-load", "says-10-to-400", "exact-but-rounds"]
WRONG += ["float-beyond", "another-each-time", "ring-far-away", "rings-none", "polygons-twice"]
PASS = ["right", "hello-slow", "slow", "deaf-to-sigterm", "children-and-right"]
PASS += ["children-apart-and-right", "starts-a-daemon", "leaves-temporary-files", "name-hostile"]
PASS += ["version-hostile", "name-missing", "capabilities-missing", "ring-of-one-point"]
PASS += ["ring-of-two-points"]
TIMED_OUT = ["hangs-at-load", "hangs-at-at", "half-a-line-then-hangs", "stops-itself"]
NO_BEGIN = [f"{how}-at-hello" for how in ("segv", "abort", "exit-0", "exit-3")]
NO_BEGIN += ["ends-at-once", "greets-garbage", "greets-deep", "prints-before-hello"]
NO_BEGIN += ["answers-before-any-request", "memory-at-hello", "capability-unknown"]
NO_BEGIN += [f"capabilities-{what}" for what in ("text", "numbers", "empty")]
NO_BEGIN += ["protocol-v9", "protocol-missing", "protocol-list", "name-long", "numbers-words"]
NO_BEGIN += ["sum-other", "arithmetic-number"]
NO_BEGIN += [f"tolerance-{what}" for what in ("negative", "no-number", "list", "nan", "long")]
# Those that hang take no processor: they are waited for at the same time.
LIMITS = {TIMED_OUT[0]: {"seconds": 3, "jobs": 6}, "memory-without-end": {"megabytes": 256}}


@pytest.mark.parametrize(
    ("ways", "expected", "code"),
    [
        (CRASHED, {"crashed"}, 3),
        (ERRORED, {"errored"}, 3),
        (WRONG, {"wrong"}, 1),
        (PASS, {"pass"}, 0),
        (["float-within"], {"pass-within"}, 0),
        (TIMED_OUT, {"timed-out"}, 3),
        (["memory-without-end"], {"out-of-memory"}, 3),
        (["space-only"], {"skipped"}, 0),
    ],
    ids=lambda value: "-".join(sorted(value)) if isinstance(value, set) else None,
)
def test_each_is_charged_with_what_it_does(
    tmp_path: Path, ways: list[str], expected: set[str], code: int
) -> None:
    targets = [target(way) for way in ways]
    limits = LIMITS.get(ways[0], {})
    found, value = verify([*targets, "minkref:paper"], tmp_path, *PLANE, "--pairs", "3", **limits)
    said = {way: verdicts(value, name) for way, name in zip(ways, targets, strict=True)}
    assert said == {way: expected for way in ways}
    assert verdicts(value, "minkref:paper") == {"pass"}
    assert found == code


@pytest.mark.parametrize("way", NO_BEGIN)
def test_one_that_does_not_begin_is_refused(way: str) -> None:
    chosen, _ = select([target(way)])
    with pytest.raises(Refusal, match="does not begin"):
        declarations_of(chosen, Limits(60, 1 << 30))


@pytest.mark.parametrize(
    ("name", "what"),
    [
        (target("exit-3-at-hello"), "it ended (exit code 3)"),
        (target("capability-unknown"), "did you mean point?"),
        ("./no_program", "there is no such program"),
        ("./text.py", "does not begin"),
    ],
)
def test_a_run_with_one_that_does_not_begin_ends_at_once(
    tmp_path: Path, name: str, what: str
) -> None:
    """Nothing is run, and nothing written."""
    (tmp_path / "text.py").write_text("no program\n")
    (tmp_path / "text.py").chmod(0o755)
    more = ("--report", tmp_path / "report", "--ledger", tmp_path / "ledger", "--pairs", "500")
    code, value = verify(["minkref:paper", name], tmp_path, *more)
    assert code == 2 and what in value["error"]["what"] and value["error"]["where"] == name
    assert sorted(path.name for path in tmp_path.iterdir()) == ["text.py"]


@pytest.mark.parametrize(
    ("ways", "expected"),
    [
        (["open", "not-planar", "cube", "twice", "inside-out", "nothing"], {"wrong"}),
        (["index-out-of-range", "index-negative", "index-float", "face-of-two"], {"errored"}),
        (["long-exponent", "zero-denominator", "plane", "faces-missing"], {"errored"}),
    ],
    ids=["sets", "indices", "numbers"],
)
def test_each_is_charged_in_space(tmp_path: Path, ways: list[str], expected: set[str]) -> None:
    targets = [target(f"space-{way}") for way in ways]
    _, value = verify(targets, tmp_path, *SPACE, "--pairs", "3", "--no-derived")
    said = {way: verdicts(value, name) for way, name in zip(ways, targets, strict=True)}
    assert said == {way: expected for way in ways}


def test_answer_of_many_vertices_ends_no_run(tmp_path: Path) -> None:
    words = ("--case", "random:1:0", "--call-seconds", "60")
    code, value = verify([target("million-vertices")], tmp_path, *words)
    assert code == 3
    assert verdicts(value, target("million-vertices")) <= {"errored", "timed-out"}


def test_line_that_reproduces_a_finding_of_a_command_can_be_given_to_a_shell(
    tmp_path: Path,
) -> None:
    _, value = verify([target("rings-none")], tmp_path, "--case", "random:1:0")
    line = value["findings"][0]["reproduce"]
    shell = line.replace("minkref verify", f"{sys.executable} -m minkref verify", 1) + " --json"
    ran = subprocess.run(shell, shell=True, capture_output=True, text=True, timeout=60)
    assert json.loads(ran.stdout)["findings"][0]["reasons"] == value["findings"][0]["reasons"]


FORMS = """as-it-is other-way rotated with-middles with-duplicates shuffled flat-rings
flat-rings-shuffled triangles triangle-polygons rings-twice double double-rings grid grid-rings
boundary everything""".split()


def test_right_answers_pass_in_every_form(tmp_path: Path) -> None:
    """Order, start, orientation, collinear and repeated vertices, triangles, rings with nesting;
    doubles and a grid within their tolerance; sums of boundaries."""
    targets = [target(form, "right_adapter.py") for form in FORMS]
    code, value = verify(targets, tmp_path, "--pairs", "60")
    assert [f for f in value["findings"]] == []
    assert code == 0
    for form, name in zip(FORMS, targets, strict=True):
        assert "pass" in verdicts(value, name), form
