"""Adapters that misbehave in one way each: charged as docs/adapter-protocol.md says, whatever they
do; the run goes on, ends with a documented exit code, and leaves no process behind."""

from __future__ import annotations

import json
import subprocess
import sys
import uuid
from collections.abc import Callable
from multiprocessing import resource_tracker
from pathlib import Path
from typing import Any

import pytest
from minkref.cli.cli import run
from minkref.errors import Refusal
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.isolation.isolation import choose
from minkref.fuzz.isolation.leftovers import marked
from minkref.fuzz.run.declared import declarations_of
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Verdict
from thoroughness import THOROUGH, draws, some

Outcomes = Callable[..., list[Outcome]]
Verify = Callable[..., tuple[int, Any]]
MIB = 1 << 20
FOLDER = Path(__file__).parent / "bad_adapters"
PLANE = ("--family", "random", "--family", "degenerate")
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


@pytest.fixture
def verify(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
    follows_schema: Callable[[Any, str], None],
) -> Callable[..., tuple[int, Any]]:
    """Gives the document of a run in a separate folder; the document follows its schema, and the
    run leaves no process. The time limit is generous unless a test is about time, so that slow
    machines give true results."""

    def call(
        targets: list[str], *options: str | Path, seconds: int = 60, megabytes: int = 1024
    ) -> tuple[int, Any]:
        mark = uuid.uuid4().hex
        resource_tracker.ensure_running()  # it stays
        words = ["verify", "--call-seconds", str(seconds), *targets, "--no-models", "--jobs", "1"]
        words += ["--call-memory", str(megabytes), "--shrink-calls", "0"]
        with monkeypatch.context() as patch:
            patch.chdir(tmp_path)
            patch.setenv("MINKREF_TEST_MARK", mark)
            code = run([*words, *map(str, options), "--json"])
        said = capfd.readouterr()
        assert "Traceback" not in said.err
        value = json.loads(said.out)
        follows_schema(value, "verify")
        assert left_behind(mark) == []
        return code, value

    return call


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
CHARGED = {
    Verdict.CRASHED: CRASHED,
    Verdict.ERRORED: ERRORED,
    Verdict.WRONG: WRONG,
    Verdict.PASS: PASS,
    Verdict.PASS_WITHIN: ["float-within"],
    Verdict.TIMED_OUT: TIMED_OUT,
    Verdict.OUT_OF_MEMORY: ["memory-without-end"],
    Verdict.SKIPPED: ["space-only"],
}


@pytest.mark.parametrize("verdict", CHARGED)
def test_each_is_charged_with_what_it_does(verdict: Verdict, outcomes: Outcomes) -> None:
    seconds = 0.3 if verdict is Verdict.TIMED_OUT else 60
    memory = MIB << (8 if verdict is Verdict.OUT_OF_MEMORY else 10)
    walls = choose()
    limits = Limits(seconds, memory, output=4 * MIB, isolation=walls)
    cases = ("random:1:0", "degenerate:1:0")[: draws(1, 2)]
    said = {
        way: {outcome.verdict for outcome in outcomes(target(way), *cases, limits=limits)}
        for way in CHARGED[verdict]
    }
    assert said == {way: {verdict} for way in CHARGED[verdict]}
    assert marked(walls.mark) == []


@pytest.mark.parametrize(
    ("kinds", "seconds", "code"),
    [
        ((Verdict.CRASHED, Verdict.ERRORED, Verdict.TIMED_OUT, Verdict.OUT_OF_MEMORY), 3, 3),
        ((Verdict.WRONG, Verdict.CRASHED), 60, 1),
        ((Verdict.PASS, Verdict.PASS_WITHIN, Verdict.SKIPPED), 60, 0),
    ],
)
def test_a_run_ends_with_a_documented_code(
    verify: Verify, kinds: tuple[Verdict, ...], seconds: int, code: int
) -> None:
    few = 1 if Verdict.TIMED_OUT in kinds else 2
    ways = {way: str(kind) for kind in kinds for way in some(CHARGED[kind], few)}
    found, value = verify(
        [*map(target, ways), "minkref:paper"], *PLANE, "--pairs", draws(1, 3),
        seconds=seconds, megabytes=256,
    )  # fmt: skip
    assert {way: verdicts(value, target(way)) for way in ways} == {w: {v} for w, v in ways.items()}
    assert verdicts(value, "minkref:paper") == {"pass"}
    assert found == code


@pytest.mark.parametrize("way", NO_BEGIN)
def test_one_that_does_not_begin_is_refused(way: str) -> None:
    chosen, _ = ALL_TARGETS.select([target(way)])
    with pytest.raises(Refusal, match="does not begin"):
        declarations_of(chosen, ALL_TARGETS, Limits(60, 256 * MIB))


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
    verify: Verify, tmp_path: Path, name: str, what: str
) -> None:
    """Nothing is run, and nothing written."""
    (tmp_path / "text.py").write_text("no program\n")
    (tmp_path / "text.py").chmod(0o755)
    more = ("--report", tmp_path / "report", "--ledger", tmp_path / "ledger", "--pairs", "500")
    code, value = verify(["minkref:paper", name], *more)
    assert code == 2 and what in value["error"]["what"] and value["error"]["where"] == name
    assert sorted(path.name for path in tmp_path.iterdir()) == ["text.py"]


@pytest.mark.parametrize(
    ("ways", "expected"),
    [
        (["open", "not-planar", "cube", "twice", "inside-out", "nothing"], Verdict.WRONG),
        (["index-out-of-range", "index-negative", "index-float", "face-of-two"], Verdict.ERRORED),
        (["long-exponent", "zero-denominator", "plane", "faces-missing"], Verdict.ERRORED),
    ],
    ids=["sets", "indices", "numbers"],
)
def test_each_is_charged_in_space(ways: list[str], expected: Verdict, outcomes: Outcomes) -> None:
    cases = [f"space-polycube:1:{k}" for k in range(draws(1, 3))]
    said = {way: {o.verdict for o in outcomes(target(f"space-{way}"), *cases)} for way in ways}
    assert said == {way: {expected} for way in ways}


def test_answer_of_many_vertices_ends_no_run(verify: Verify) -> None:
    name = target("million-vertices" if THOROUGH else "many-vertices")
    code, value = verify([name], "--case", "random:1:0")
    assert code == 3
    assert verdicts(value, name) <= {"errored", "timed-out"}


def test_line_that_reproduces_a_finding_of_a_command_can_be_given_to_a_shell(
    verify: Verify,
) -> None:
    _, value = verify([target("rings-none")], "--case", "random:1:0")
    line = value["findings"][0]["reproduce"]
    shell = line.replace("minkref verify", f"{sys.executable} -m minkref verify", 1) + " --json"
    ran = subprocess.run(shell, shell=True, capture_output=True, text=True, timeout=60)
    assert json.loads(ran.stdout)["findings"][0]["reasons"] == value["findings"][0]["reasons"]


FORMS = """as-it-is other-way rotated with-middles with-duplicates shuffled flat-rings
flat-rings-shuffled triangles triangle-polygons rings-twice double double-rings grid grid-rings
boundary everything""".split()


RIGHT = ("random:1:0", "holes:1:9", "degenerate:1:0", "probe:0(random:1:26)", "invalid:1:0")
RIGHT += ("update(star:1:0)", "events(holes:1:9)")


@pytest.mark.parametrize("form", FORMS)
def test_right_answers_pass_in_every_form(form: str, outcomes: Outcomes) -> None:
    """Order, start, orientation, collinear and repeated vertices, triangles, rings with nesting;
    doubles and a grid within their tolerance; sums of boundaries."""
    said = outcomes(target(form, "right_adapter.py"), *RIGHT)
    assert {o.verdict for o in said} <= {*GOOD, Verdict.SKIPPED}, [o.message for o in said]
    assert Verdict.PASS in {o.verdict for o in said}


@pytest.mark.thorough
def test_right_answers_pass_in_every_form_in_a_run(verify: Verify) -> None:
    """As `test_right_answers_pass_in_every_form`, on many cases."""
    targets = [target(form, "right_adapter.py") for form in FORMS]
    code, value = verify(targets, "--pairs", "60")
    assert [f for f in value["findings"]] == []
    assert code == 0
    for form, name in zip(FORMS, targets, strict=True):
        assert "pass" in verdicts(value, name), form
