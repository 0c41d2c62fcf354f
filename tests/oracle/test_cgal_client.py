"""The client finds the servers, starts them anew, and turns every failure into an answer."""

from __future__ import annotations

import json
import os
import signal
import stat
import sys

import pytest
from minkref.fuzz.cgal import oracle as cgal
from minkref.fuzz.cgal import server as cgal_server

UNIT = {"polygons": [{"outer": [["0", "0"], ["1", "0"], ["0", "1"]], "holes": []}]}


@pytest.fixture
def impostor(tmp_path):
    """An executable that runs given Python code instead of a server."""

    def write(code):
        path = tmp_path / "minkref-cgal-reduced"
        path.write_text(f"#!{sys.executable}\nimport sys, time\n{code}\n")
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return path

    return write


def test_a_sum_comes_back_from_texts_and_from_dictionaries(oracle):
    with oracle("reduced") as adder:
        first = adder.sum(UNIT, UNIT)
        second = adder.sum(json.dumps(UNIT, indent=1), json.dumps(UNIT))
    assert first.status == second.status == "result"
    assert first.rings_json == second.rings_json
    assert 0 < first.seconds < first.total_seconds


def test_a_server_that_died_between_calls_is_started_anew(oracle):
    adder = oracle("reduced")
    assert adder.sum(UNIT, UNIT).status == "result"
    os.kill(adder._server.pid, signal.SIGKILL)
    adder._server.wait()
    assert adder.sum(UNIT, UNIT).status == "result"


def test_a_crash_names_its_signal(oracle, executable):
    with cgal.CgalOracle("self-test:crash", executable("reduced")) as crasher:
        answer = crasher.sum(UNIT, UNIT)
    assert (answer.status, answer.signal, answer.rings_json) == ("crashed", "SIGSEGV", None)


@pytest.mark.parametrize(
    "code",
    [
        "",
        "sys.stdin.readline(); print('rubbish')",
        "sys.stdin.readline(); print('[]')",
        'sys.stdin.readline(); print(\'{"id":99,"status":"result"}\')',
        'sys.stdin.readline(); print(\'{"id":1,"status":"splendid"}\')',
        "sys.stdin.readline(); sys.stdout.write('{\"id\":1,')",
        "time.sleep(60)",
    ],
    ids=["ends", "rubbish", "list", "wrong id", "wrong status", "half a line", "silent"],
)
def test_a_server_that_breaks_the_protocol_is_an_answer_and_no_exception(
    impostor, monkeypatch, code
):
    monkeypatch.setattr(cgal_server, "GRACE_SECONDS", 1.0)
    with cgal.CgalOracle("reduced", impostor(code), seconds=0.5) as adder:
        answer = adder.sum(UNIT, UNIT)
    assert answer.status == "errored" and "minkref-cgal-reduced" in answer.reason


def test_the_folder_in_minkref_cgal_comes_first(impostor, monkeypatch):
    path = impostor('print(\'{"cgal":"9.9","methods":["reduced"]}\')')
    monkeypatch.setenv("MINKREF_CGAL", str(path.parent))
    assert cgal.find_executable("reduced") == path
    assert cgal.cgal_version("reduced") == "9.9"


def test_an_executable_that_is_absent_is_named_with_the_command_that_builds_it(
    tmp_path, monkeypatch
):
    from minkref.fuzz.cgal import executables as cgal_executables

    monkeypatch.setattr(cgal_executables, "search_folders", lambda: [tmp_path])
    with pytest.raises(cgal.OracleNotFoundError, match="cmake --preset release && cmake --build"):
        cgal.CgalOracle("reduced")
    assert cgal.available_targets() == []


def test_the_server_has_the_methods_that_the_client_names(executable):
    for method, group in cgal.METHOD_GROUPS.items():
        path = executable(method)
        from minkref.fuzz.cgal.executables import _description

        said = _description(path, path.stat().st_mtime)
        expected = [name for name, its_group in cgal.METHOD_GROUPS.items() if its_group == group]
        assert said["methods"] == expected
        assert (method in cgal.METHODS_WITH_HOLES) == (method in said["methods_with_holes"])


def test_every_target_name_leads_back_to_its_method():
    for target in cgal.target_names():
        method, raw = cgal.method_of_target(target)
        assert target == f"cgal-{method}{'-raw' if raw else ''}"
        assert method in cgal.METHOD_GROUPS


def test_an_unknown_method_is_refused_at_once():
    with pytest.raises(ValueError, match="no method"):
        cgal.CgalOracle("magic")
