"""The walls around other people's programs: sight, reach, writing and resources are limited, and
nothing remains afterwards, with the sandbox and without, as docs/security.md says."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest
from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.isolation import sandbox
from minkref.fuzz.isolation.control_group import PIDS, find_rooms, remove_stale
from minkref.fuzz.isolation.environment import NAMES, PREFIXES
from minkref.fuzz.isolation.isolation import Isolation, choose
from minkref.fuzz.isolation.leftovers import marked
from minkref.fuzz.run import naming
from minkref.fuzz.targets.adapter import AdapterTarget
from minkref.fuzz.targets.adapter_process import AdapterProcess, Failure
from minkref.fuzz.targets.answer import Limits
from minkref.fuzz.verdicts.verdict import Verdict
from processes import started

PROGRAM = Path(__file__).parent / "isolated_adapter.py"
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
needs_sandbox = pytest.mark.skipif(sandbox.absence() is not None, reason=str(sandbox.absence()))
MIB = 1 << 20


@pytest.fixture(params=[pytest.param("sandbox", marks=needs_sandbox), "none"])
def walls(request: pytest.FixtureRequest) -> Isolation:
    return choose(request.param)


def said(
    walls: Isolation, what: str, argument: object = "", megabytes: int = 512, processes: int = 99
) -> str:
    """The adapter's account of its try; afterwards no part of the adapter runs."""
    limits = Limits(60, megabytes * MIB, processes=processes, isolation=walls)
    process = AdapterProcess("it", [sys.executable, str(PROGRAM), what, str(argument)], limits)
    try:
        return str(process.start().version)
    finally:
        process.close()
        assert marked(walls.mark) == []


def test_of_the_environment_it_is_given_a_list(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SECRET_TOKEN", "x")
    monkeypatch.setenv("WANTED", "x")
    own = {"HOME", "TMPDIR", "PWD", "SHLVL", "_"}
    given = set(said(walls, "environment").split())
    assert {name for name in given if not name.startswith(PREFIXES)} <= {*NAMES, *own}
    given = set(said(replace(walls, passed=("WANTED",)), "environment").split())
    assert "WANTED" in given and "SECRET_TOKEN" not in given


def test_what_a_user_installed_in_the_home_folder_is_still_found(
    walls: Isolation, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """HOME differs, and Python would look there for the user's packages."""
    packages = tmp_path / ".local" / "lib" / "python3" / "site-packages"
    packages.mkdir(parents=True)
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.delenv("PYTHONUSERBASE", raising=False)
    monkeypatch.chdir(tmp_path)
    assert said(walls, "variable", "PYTHONUSERBASE") == str(tmp_path / ".local")


def test_only_without_the_sandbox_it_reaches_the_network(walls: Isolation) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        said_of_it = said(walls, "network", server.getsockname()[1])
    assert (said_of_it == "reached") == (walls.kind == "none")


@needs_sandbox
def test_sockets_of_the_system_are_out_of_reach_in_the_sandbox(tmp_path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(str(tmp_path / "it"))
        server.listen()
        assert said(choose("sandbox"), "unix-socket", f"at:{tmp_path}/it") != "reached"


@pytest.mark.parametrize("place", ["beside", "current", "home", "user"])
def test_it_writes_in_its_own_folders_only(
    walls: Isolation, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str
) -> None:
    """Without a sandbox this holds if each program has a separate user."""
    if walls.kind == "none" and not walls.own_user:
        pytest.skip("without a sandbox, and not root: documented")
    monkeypatch.chdir(tmp_path)
    folder = {"beside": PROGRAM.parent, "current": tmp_path, "home": Path.home(), "user": "/usr"}
    file = Path(folder[place], f"written-{walls.mark}")
    assert said(walls, "write", file).startswith("not: ")
    assert not file.exists()


def test_home_and_temporary_folder_are_its_own_and_gone_afterwards(walls: Isolation) -> None:
    folder = said(walls, "own-folders")
    assert folder.startswith("/")
    assert folder == sandbox.FOLDER or not Path(folder).exists()
    assert not Path(folder, "mine").exists()


def test_files_of_the_run_cannot_be_changed_nor_read_in_the_sandbox(
    walls: Isolation, tmp_path: Path
) -> None:
    ledger, report = tmp_path / "run.jsonl", tmp_path / "report"
    ledger.write_text("what was judged")
    report.mkdir()
    (report / "index.html").write_text("what was judged")
    hiding = choose(walls.kind, hidden=(ledger, report))
    for file in (ledger, report / "index.html"):
        if walls.kind == "sandbox":
            assert said(hiding, "read", f"at:{file}").startswith("not: ")
        if walls.kind == "sandbox" or walls.own_user:
            said(hiding, "write", file)
            assert file.read_text() == "what was judged"


def test_forty_processes_that_left_and_killed_their_supervisor_are_ended(walls: Isolation) -> None:
    try:
        said(walls, "forty")
    except Failure as failure:
        assert failure.verdict is Verdict.CRASHED


@needs_sandbox
def test_in_the_sandbox_it_sees_no_process_but_its_own() -> None:
    assert len(said(choose("sandbox"), "see-processes").split()) <= 3


@needs_sandbox
def test_in_the_sandbox_it_has_no_rights_of_root() -> None:
    capabilities, no_new, remounted = said(choose("sandbox"), "privileges").split()
    assert int(capabilities, 16) == 0 and no_new == "1" and remounted != "0"


@pytest.mark.parametrize("measured", [False, True])
def test_memory_is_counted_of_the_whole_tree(walls: Isolation, measured: bool) -> None:
    """Four children, each below the limit."""
    if measured:
        walls = replace(walls, rooms=())
    with pytest.raises(Failure) as caught:
        said(walls, "tree", 400, megabytes=256)
    assert caught.value.verdict is Verdict.OUT_OF_MEMORY
    assert "--call-memory" in caught.value.message


@pytest.mark.parametrize("grouped", [True, False])
def test_a_fork_bomb_stops_at_the_limit_of_processes(walls: Isolation, grouped: bool) -> None:
    """Begins as many of 60 processes as the limit leaves beside the bomb, where a limit holds."""
    if not grouped:
        walls = replace(walls, rooms=tuple(r for r in walls.rooms if PIDS not in r.controllers))
    begun, refused = said(walls, "bomb", 60, processes=20).split()
    if walls.processes == "not held":
        assert begun == "60"
    else:
        assert (begun, refused) == ("19", "True"), walls.processes


def test_who_wanted_more_processes_is_told_so_when_it_fails(walls: Isolation) -> None:
    if not any(PIDS in room.controllers for room in walls.rooms):
        pytest.skip("not counted here")
    with pytest.raises(Failure, match=r"it wanted more than 20 processes \(--call-processes\)"):
        said(walls, "bomb-and-fail", 60, processes=20)


@needs_sandbox
@pytest.mark.skipif(
    os.geteuid() != 0 or not shutil.which("setpriv") or not Path("/usr/bin/python3").exists(),
    reason="changes its user",
)
def test_a_fork_bomb_of_another_user_stops_in_its_user_space(tmp_path: Path) -> None:
    """Without a control group: the limit holds in the sandbox alone, whatever that user runs."""
    if not all(folder.stat().st_mode & 0o001 for folder in PROGRAM.parents):
        pytest.skip("the checkout is for its owner alone: another user cannot import minkref")
    script = (
        "from minkref.fuzz.isolation.isolation import choose\n"
        "from minkref.fuzz.targets.adapter_process import AdapterProcess\n"
        "from minkref.fuzz.targets.answer import Limits\n"
        "walls = choose('sandbox')\n"
        f"words = ['/usr/bin/python3', {str(PROGRAM)!r}, 'bomb', '60']\n"  # all may run it
        "process = AdapterProcess('it', words, Limits(processes=20, isolation=walls))\n"
        "print(walls.processes, process.start().version, sep=', ')\n"
        "process.close()\n"
    )
    words = ["setpriv", "--reuid", "61183", "--regid", "61183", "--clear-groups"]
    words += ["--inh-caps", "-all", sys.executable, "-c", script]
    environment = {**os.environ, "HOME": str(tmp_path), "XDG_STATE_HOME": str(tmp_path)}
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=False)
    if "there is no sandbox" in done.stderr or "Permission denied" in done.stderr:
        pytest.skip(f"not for another user: {done.stderr[-200:]}")
    assert done.stdout == "limit of its user space, 19 True\n", done.stderr


def test_nothing_is_left_where_the_one_that_started_it_is_killed(walls: Isolation) -> None:
    script = (
        "import sys, time\n"
        "from minkref.fuzz.isolation.isolation import Isolation, choose\n"
        "from dataclasses import replace\n"
        "from minkref.fuzz.targets.adapter_process import AdapterProcess\n"
        "from minkref.fuzz.targets.answer import Limits\n"
        f"walls = replace(choose({walls.kind!r}), mark={walls.mark!r})\n"
        f"words = [sys.executable, {str(PROGRAM)!r}, 'own-folders']\n"
        "AdapterProcess('it', words, Limits(isolation=walls)).start()\n"
        "print('begun', flush=True)\n"
        "time.sleep(600)\n"
    )
    with started([sys.executable, "-c", script], stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"begun\n"
        assert marked(walls.mark)
        process.kill()
    deadline = time.monotonic() + 10
    while marked(walls.mark) and time.monotonic() < deadline:
        time.sleep(0.02)
    assert marked(walls.mark) == []
    walls.clear()
    for room in walls.rooms:
        assert not list(room.folder.glob(f"minkref-{process.pid}-*"))


@needs_sandbox
@pytest.mark.parametrize("place", ["beside", "below"])
def test_an_adapter_below_the_folder_for_temporary_files_begins(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str
) -> None:
    """Starts the program by a relative path, with a module beside it, through its first line's
    interpreter."""
    folder = tmp_path if place == "beside" else tmp_path / "deep"
    folder.mkdir(exist_ok=True)
    for name in ("adapter.py", "isolated_adapter.py"):
        source = PROGRAM.parent / "bad_adapters" / name
        text = (source if source.is_file() else PROGRAM).read_text()
        (folder / name).write_text(f"#!{sys.executable}\n{text}")
    (folder / "isolated_adapter.py").chmod(0o755)
    monkeypatch.chdir(tmp_path)
    program = os.path.join(".", os.path.relpath(folder / "isolated_adapter.py", tmp_path))
    words = [os.path.abspath(program), "own-folders"]
    process = AdapterProcess("it", words, Limits(isolation=choose("sandbox")))
    try:
        assert process.start().version == sandbox.FOLDER
    finally:
        process.close()


# Verdicts in the sandbox, without it as root, and without it as another user (docs/security.md).
DIFFER = {
    "kills-parent": (None, Verdict.CRASHED, Verdict.CRASHED),
    "stops-parent": (None, Verdict.CRASHED, None),
    "closes-stdout-and-lives": (Verdict.TIMED_OUT, Verdict.ERRORED, Verdict.ERRORED),
    "writes-to-the-ledger": (Verdict.CRASHED, Verdict.CRASHED, None),
    "truncates-the-ledger": (Verdict.CRASHED, Verdict.CRASHED, None),
    "log-without-end": (Verdict.ERRORED, Verdict.ERRORED, Verdict.ERRORED),
}


@needs_sandbox
def test_a_program_is_found_behind_a_link_in_a_folder_that_is_shown_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Imitates the package of a checkout inside the folder for temporary files."""
    real = tmp_path / "room" / "programs"
    real.mkdir(parents=True)
    for source in (PROGRAM, PROGRAM.parent / "bad_adapters" / "adapter.py"):
        (real / source.name).write_text(source.read_text(encoding="utf-8"), encoding="utf-8")
    package = tmp_path / "package"
    package.mkdir()
    (package / "linked").symlink_to(tmp_path / "room")
    monkeypatch.chdir(tmp_path)
    program = package / "linked" / "programs" / PROGRAM.name
    walls = choose("sandbox")
    process = AdapterProcess(
        "it", [sys.executable, str(program), "own-folders"], Limits(60, isolation=walls)
    )
    try:
        assert process.start().version == sandbox.FOLDER
    finally:
        process.close()


@pytest.mark.parametrize("way", DIFFER)
def test_what_walls_change_of_a_verdict_is_as_documented(
    walls: Isolation, tmp_path: Path, way: str
) -> None:
    ledger = tmp_path / "run.jsonl"
    ledger.write_text("what was judged")
    hiding = replace(walls, hidden=(str(ledger),))
    seconds = 2 if way == "closes-stdout-and-lives" else 60
    program = PROGRAM.parent / "bad_adapters" / "bad_adapter.py"
    limits = Limits(seconds, 512 * MIB, output=MIB, isolation=hiding)
    target = AdapterTarget("it", [sys.executable, str(program), way, str(ledger)], limits)
    case = naming.load(CaseName("random:1:0", "random"))
    verdict = target.sum(case).verdict
    target.close()
    column = 0 if walls.kind == "sandbox" else 1 if walls.own_user else 2
    assert verdict == DIFFER[way][column]
    assert column == 2 or ledger.read_text() == "what was judged"
    assert marked(walls.mark) == []


@pytest.mark.parametrize(("wanted", "passed"), [("sandbx", ()), ("none", ("A=b",))])
def test_what_names_no_isolation_or_no_variable_is_refused(
    wanted: str, passed: tuple[str, ...]
) -> None:
    with pytest.raises(Refusal):
        choose(wanted, passed)


@pytest.mark.skipif(not find_rooms(), reason="no control groups")
def test_the_groups_of_an_owner_that_has_ended_are_removed_though_its_parent_has_not_asked() -> (
    None
):
    (room, *_) = find_rooms()
    make = f"import os; os.mkdir(f'{room.folder}/minkref-{{os.getpid()}}-7')"
    owner = subprocess.Popen([sys.executable, "-c", make])
    group = room.folder / f"minkref-{owner.pid}-7"
    os.waitid(os.P_PID, owner.pid, os.WEXITED | os.WNOWAIT)
    assert group.is_dir() and Path("/proc", str(owner.pid)).exists()
    remove_stale(room)
    assert not group.exists()
    assert owner.wait() == 0
