"""The server survives every failure of its children, and names the failure."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

UNIT = {"polygons": [{"outer": [["0", "0"], ["1", "0"], ["0", "1"]], "holes": []}]}
DOUBLE = [["0", "0"], ["2", "0"], ["0", "2"]]


def assert_it_still_adds(server):
    answer = server.ask(id="after", method="reduced", P=UNIT, Q=UNIT)
    assert answer["status"] == "result" and answer["id"] == "after"
    ring = answer["result"]["polygons"][0]["outer"]
    assert {tuple(corner) for corner in DOUBLE} <= {tuple(vertex) for vertex in ring}


@pytest.mark.parametrize(
    ("fault", "status", "signal"),
    [
        ("crash", "crashed", 11),
        ("abort", "crashed", 6),
        ("hang", "timed-out", None),
        ("sleep", "timed-out", None),
        ("garbage", "errored", None),
        ("silence", "errored", None),
        ("exit", "errored", None),
    ],
)
def test_a_fault_of_the_child_has_its_name_and_the_server_goes_on(server, fault, status, signal):
    answer = server.ask(id=7, method=f"self-test:{fault}", seconds=0.5)
    assert (answer["id"], answer["status"], answer.get("signal")) == (7, status, signal)
    assert answer["reason"]
    assert_it_still_adds(server)


def test_the_time_limit_is_kept(server):
    answer = server.ask(id=1, method="self-test:hang", seconds=0.3)
    assert answer["status"] == "timed-out"
    assert 0.3 <= answer["total_seconds"] < 5


def test_the_memory_limit_is_kept(server):
    limit = 256 << 20
    answer = server.ask(id=1, method="self-test:memory", seconds=60, bytes=limit)
    assert answer["status"] == "out-of-memory"
    assert limit / 8 < answer["peak_bytes"] <= limit
    assert_it_still_adds(server)


def test_an_answer_without_end_is_cut_off(server):
    answer = server.ask(id=1, method="self-test:flood", seconds=60)
    assert answer["status"] == "errored" and "larger than" in answer["reason"]
    assert_it_still_adds(server)


@pytest.mark.parametrize(
    "line",
    [
        "no JSON",
        "[]",
        '"text"',
        "{",
        "{}",
        '{"id":1,"method":"no such method"}',
        '{"id":1,"method":"reduced","seconds":0}',
        '{"id":1,"method":"reduced","seconds":-1}',
        '{"id":1,"method":"reduced","seconds":"long"}',
        '{"id":1,"method":"reduced","bytes":"many"}',
        '{"id":1,"method":"reduced"}',
        '{"id":1,"method":"reduced","P":[],"Q":{}}',
        "[" * 200_000,
        '{"id":1,"method":"reduced","P":' + "[" * 200_000 + "]" * 200_000 + "}",
        "\x00\x7f\u00ff",
    ],
    ids=lambda line: line[:40],
)
def test_a_request_that_is_none_is_refused_and_the_server_goes_on(server, line):
    answer = server.say(line)
    assert answer["status"] == "errored" and answer["reason"]
    assert_it_still_adds(server)


@pytest.mark.parametrize("number", ["", "-", "1/0", "1/00", "0.5", "1e3", "+1", " 1", "1/-2", "a"])
def test_a_coordinate_that_is_no_exact_number_is_refused(server, number):
    P = {"polygons": [{"outer": [["0", "0"], [number, "0"], ["0", "1"]]}]}
    answer = server.ask(id=1, method="reduced", P=P, Q=UNIT)
    assert answer["status"] == "errored" and answer["reason"].startswith("P: ")


def test_a_json_number_is_refused_for_it_may_have_been_rounded(server):
    P = {"polygons": [{"outer": [["0", "0"], [1, "0"], ["0", "1"]]}]}
    assert server.ask(id=1, method="reduced", P=P, Q=UNIT)["status"] == "errored"


def test_the_server_ends_with_its_input(server):
    output, _ = server.process.communicate('{"id":1,"method":"self-test:exit"}\n', timeout=30)
    assert server.process.returncode == 0
    assert output.count("\n") == 1


def test_a_child_does_not_outlive_its_server(server):
    pid = server.process.pid
    children = Path(f"/proc/{pid}/task/{pid}/children")
    if not children.exists():
        pytest.skip("this kernel does not list children in /proc")
    server.send('{"id":1,"method":"self-test:sleep","seconds":600}')
    deadline = time.monotonic() + 10
    while not (found := children.read_text().split()) and time.monotonic() < deadline:
        time.sleep(0.01)
    assert found, "the server started no child"
    server.close()
    while os.path.exists(f"/proc/{found[0]}") and time.monotonic() < deadline:
        time.sleep(0.01)
    assert not os.path.exists(f"/proc/{found[0]}")


def test_a_call_costs_little_beyond_cgal(server):
    answers = [server.ask(id=i, method="reduced", P=UNIT, Q=UNIT) for i in range(51)]
    overheads = sorted(answer["total_seconds"] - answer["seconds"] for answer in answers)
    # 0.5 ms on an idle machine; on a busy one the few that nothing comes between.
    assert overheads[len(overheads) // 10] < 0.02
