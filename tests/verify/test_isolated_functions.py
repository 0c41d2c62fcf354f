"""`py:` and `so:` functions have the walls of an adapter, and see and say what they did without."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from itertools import product
from pathlib import Path

import pytest
from minkref.errors import Refusal
from minkref.fuzz.adapters.template import HEADER
from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.isolation import sandbox
from minkref.fuzz.isolation.isolation import Isolation, choose
from minkref.fuzz.isolation.leftovers import marked
from minkref.fuzz.run import naming, pool
from minkref.fuzz.run.declared import declarations_of
from minkref.fuzz.run.runner import Run
from minkref.fuzz.targets.answer import Answer, Limits
from minkref.fuzz.verdicts.verdict import Verdict
from thoroughness import some

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
needs_sandbox = pytest.mark.skipif(sandbox.absence() is not None, reason=str(sandbox.absence()))
MIB = 1 << 20
CASE = "random:1:0"


@pytest.fixture(params=[pytest.param("sandbox", marks=needs_sandbox), "none"])
def walls(request: pytest.FixtureRequest, faulty_sums: None) -> Isolation:
    return choose(request.param)


def answer(walls: Isolation, name: str, *cases: str, megabytes: int = 512) -> Answer:
    """To the last case; nothing of the function runs afterwards."""
    if ":" not in name:
        name = f"py:isolated_functions:{name}"
    target = ALL_TARGETS.target(name, Limits(60, megabytes * MIB, isolation=walls))
    try:
        for case in cases or (CASE,):
            said = target.sum(naming.load(CaseName(case, "test")))
        return said
    finally:
        target.close()
        assert marked(walls.mark) == []


def told(walls: Isolation, name: str, *cases: str) -> str:
    said = answer(walls, name, *cases)
    assert said.verdict is Verdict.ERRORED, said.message
    return said.message.removeprefix("Told: ")


def tried(walls: Isolation, monkeypatch: pytest.MonkeyPatch, what: str) -> str:
    monkeypatch.setenv("MINKREF_TRY", what)
    return told(walls, "tries")


def test_of_the_environment_it_is_given_a_list(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SECRET_TOKEN", "x")
    given = tried(walls, monkeypatch, "environment").split()
    assert "PYTHONPATH" in given and "SECRET_TOKEN" not in given


def test_only_without_the_sandbox_it_reaches_the_network(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch
) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        said = tried(walls, monkeypatch, f"network {server.getsockname()[1]}")
    assert (said == "reached") == (walls.kind == "none")


def test_it_writes_nowhere_but_in_its_own_folder(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    if walls.kind == "none" and not walls.own_user:
        pytest.skip("without a sandbox, and not root: documented")
    monkeypatch.chdir(tmp_path)
    for place in (Path(__file__).parent, tmp_path, Path.home()):
        file = place / f"written-{walls.mark}"
        assert tried(walls, monkeypatch, f"write {file}").startswith("not: ")
        assert not file.exists()
    assert tried(walls, monkeypatch, "own-folders").startswith("/")


def test_it_cannot_forge_the_ledger(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    if walls.kind == "none" and not walls.own_user:
        pytest.skip("without a sandbox, and not root: documented")
    ledger = tmp_path / "run.jsonl"
    ledger.write_text("what was judged")
    hiding = choose(walls.kind, hidden=(ledger,))
    if walls.kind == "sandbox":
        assert tried(hiding, monkeypatch, f"read at:{ledger}").startswith("not: ")
    tried(hiding, monkeypatch, f"write {ledger}")
    assert ledger.read_text() == "what was judged"


def test_forty_processes_that_it_left_are_ended(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They killed their supervisor."""
    monkeypatch.setenv("MINKREF_TRY", "forty")
    assert answer(walls, "tries").verdict in (Verdict.CRASHED, Verdict.ERRORED)


def test_memory_is_counted_of_the_whole_tree(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MINKREF_TRY", "tree 400")
    said = answer(walls, "tries", megabytes=256)
    assert said.verdict is Verdict.OUT_OF_MEMORY and "--call-memory" in said.message


WRITES = """
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include "minkref_adapter.h"
int writes(const minkref_set* p, const minkref_set* q, minkref_set* sum) {
  (void)p, (void)q, (void)sum;
  return open(getenv("MINKREF_TRY"), O_CREAT | O_WRONLY, 0666) < 0 ? -errno : 1000;
}
"""


@pytest.mark.skipif(not shutil.which("gcc"), reason="gcc is not installed")
def test_a_c_function_writes_nowhere(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    if walls.kind == "none" and not walls.own_user:
        pytest.skip("without a sandbox, and not root: documented")
    (tmp_path / "writes.c").write_text(WRITES)
    words = ["gcc", "-shared", "-fPIC", f"-I{HEADER.parent}", "writes.c", "-o", "libwrites.so"]
    subprocess.run(words, check=True, cwd=tmp_path, timeout=60)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MINKREF_TRY", str(tmp_path / "written"))
    assert told(walls, "so:./libwrites.so:writes", "convex:1:0").startswith("returned -")
    assert not (tmp_path / "written").exists()


def test_a_function_that_breaks_costs_no_worker(
    verify: Callable[..., Run], monkeypatch: pytest.MonkeyPatch
) -> None:
    def replaced(*_: object) -> None:
        raise AssertionError("a worker was lost")

    monkeypatch.setattr(pool, "_replaced", replaced)
    faults = ("dies", "leaves", "hangs", "exits", "exhausts_memory")
    run = verify(*(f"py:faulty_sums:{fault}" for fault in faults), pairs=2, call_seconds=1.0)
    assert run.failed is None and len(run.findings) == 2 * len(faults)


def test_operands_are_those_of_the_case_and_new_at_each_call(walls: Isolation) -> None:
    """The function empties them. The same Q is sent once for two scales."""
    frame = '{"P":{"polygons":[{"outer":[[0,0],[9,0],[0,9]]}]},"Q":{"polygons":[{"outer":[[0,0],'
    frame += '[1,0],[0,"1/3"]]}]},"scale":"%s"}'
    seen = json.loads(told(walls, "operands", frame % "1", frame % "2"))
    outer = [["0", "0"], ["18", "0"], ["0", "18"]]
    assert seen[0] == {"polygons": [{"outer": outer, "holes": []}]}
    assert seen[1]["polygons"][0]["outer"] == [["0", "0"], ["1", "0"], ["0", "1/3"]]


def test_doubles_arrive_to_the_last_bit(walls: Isolation) -> None:
    numbers = [0.1, 5e-324, 1.7976931348623157e308, -1 / 3, 2.0**-1074 * 3, 1e22]
    texts = [str(Fraction(number)) for number in numbers]
    corner = [["0", "0"], [texts[0], texts[1]], [texts[3], texts[4]]]
    large = [["0", "0"], [texts[2], "0"], ["0", texts[5]]]
    sets = [{"polygons": [{"outer": ring}]} for ring in (corner, large)]
    case = json.dumps({"P": sets[0], "Q": sets[1], "scale": "1"})
    assert {number.hex() for number in numbers} <= set(told(walls, "doubles", case).split())


def test_integers_of_any_size_come_back(walls: Isolation) -> None:
    before = sys.get_int_max_str_digits()
    sys.set_int_max_str_digits(0)  # as in a worker
    try:
        said = answer(walls, "long_integer")
    finally:
        sys.set_int_max_str_digits(before)
    assert said.region is not None and len(said.region.json) > 9_000


def test_the_program_around_it_has_nothing_of_minkref_and_leaves_it_nothing_to_read(
    walls: Isolation,
) -> None:
    assert told(walls, "modules") == "none"
    assert told(walls, "input_there") == "''"
    assert told(walls, "two_answers") == "printed"


def test_a_value_error_rejects_invalid_operands_and_is_a_fault_on_others(walls: Isolation) -> None:
    assert told(walls, "raises_value_error") == "ValueError: never valid"
    said = answer(walls, "raises_value_error", "invalid:1:0")
    assert (said.verdict, said.region) == (Verdict.WRONG, None)


@pytest.mark.parametrize(
    ("name", "place", "safe"),
    some(
        product(
            ["adapter_protocol", "surfaces", "c_function", "package.sub"],
            [".", "mine", "../beside"],
            ["", "1"],
        ),
        few=6,
    ),
)
def test_modules_of_the_current_folder_and_of_the_path_are_found_whatever_their_names(
    walls: Isolation,
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    name: str,
    place: str,
    safe: str,
) -> None:
    here = tmp_path / "here"
    file = here / place / (name.replace(".", "/") + ".py")
    here.mkdir()
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("def f(P, Q):\n    raise LookupError(__name__)\n")
    monkeypatch.chdir(here)
    monkeypatch.setenv("PYTHONPATH", "" if place == "." else place)
    monkeypatch.setenv("PYTHONSAFEPATH", safe)
    assert told(walls, f"py:{name}:f") == f"LookupError: {name}"


def test_processes_that_a_function_starts_find_its_modules(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Our tests also have a module `surfaces`."""
    (tmp_path / "surfaces.py").write_text(
        "import multiprocessing\n"
        "def g(n): return n + 1\n"
        "def f(P, Q):\n"
        "    with multiprocessing.get_context('spawn').Pool(1) as pool:\n"
        "        raise LookupError(pool.map(g, [1, 2]))\n"
    )
    monkeypatch.chdir(tmp_path)
    assert told(walls, "py:surfaces:f") == "LookupError: [2, 3]"


@needs_sandbox
def test_a_package_right_in_the_folder_for_temporary_files_is_found(
    faulty_sums: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    walls = choose("sandbox")
    folder = Path(sandbox.EMPTIED[0], f"minkref_test_{walls.mark}")
    folder.mkdir()
    try:
        (folder / "sub.py").write_text("def f(P, Q):\n    raise LookupError(__name__)\n")
        monkeypatch.chdir(sandbox.EMPTIED[0])
        assert told(walls, f"py:{folder.name}.sub:f") == f"LookupError: {folder.name}.sub"
    finally:
        shutil.rmtree(folder)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("import os\nos._exit(3)", "exit code 3"),
        ("import os, signal\nos.kill(os.getpid(), signal.SIGSEGV)", "SIGSEGV"),
        ("import time\ntime.sleep(3600)", "no answer in 1 s"),
        ("raise KeyboardInterrupt", "KeyboardInterrupt"),
        ("def f(P, Q): pass\nf.minkref = 3", "the attribute minkref is not a dictionary"),
        ("def f(P, Q): pass\nf.minkref = {'capabilities': {1}}", "its declaration: TypeError"),
        ("print('{}')\nimport sys\nsys.exit('said at the end')", "SystemExit: said at the end"),
    ],
)
def test_whatever_a_module_does_on_import_it_is_refused(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, text: str, said: str
) -> None:
    (tmp_path / "spoilt.py").write_text(text)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("minkref.fuzz.targets.answer.LOAD_SECONDS", 1.0)
    limits = Limits(1.0, isolation=walls)
    with pytest.raises(Refusal, match="the function cannot be loaded: ") as caught:
        declarations_of([ALL_TARGETS.select_one("py:spoilt:f")], ALL_TARGETS, limits)
    assert said in caught.value.what
    assert marked(walls.mark) == [] and os.listdir(tmp_path) == ["spoilt.py"]
