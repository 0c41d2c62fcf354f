"""A ledger is believed only as written: changed, added, moved or forged lines are refused with
their number, and the file is kept."""

from __future__ import annotations

import hashlib
import json
import os
import stat
from collections.abc import Callable
from pathlib import Path

import pytest
from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.isolation.own_folders import state_folder
from minkref.fuzz.run.ledger import Ledger
from minkref.fuzz.run.ledger_chain import Chain, ledger_key
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Outcome, Verdict

HEAD = {"targets": ["a"], "cases": {"seed": 1}}
RESULTS = 5
LINES = RESULTS + 1


def result(number: int, verdict: Verdict = Verdict.PASS) -> CaseResult:
    name = CaseName(f"random:1:{number}", "random")
    outcomes = [Outcome("a", verdict, message='"chain":"}')]
    return CaseResult(number, name, "1", outcomes, "P", "Q", (7, 1, ""))


@pytest.fixture
def path(tmp_path: Path) -> Path:
    with Ledger(tmp_path / "run.jsonl", HEAD) as ledger:
        for number in range(RESULTS):
            ledger.write(result(number, Verdict.WRONG if number == 3 else Verdict.PASS))
    return tmp_path / "run.jsonl"


def count(path: Path) -> int:
    with Ledger(path, HEAD) as ledger:
        return ledger.count


def refused(path: Path, lines: list[bytes]) -> Refusal:
    path.write_bytes(b"".join(lines))
    with pytest.raises(Refusal) as refusal:
        count(path)
    assert path.read_bytes() == b"".join(lines)
    return refusal.value


def changed(lines: list[bytes], k: int) -> list[bytes]:
    return [*lines[:k], lines[k].replace(b"random", b"Random", 1), *lines[k + 1 :]]


def verdict_changed(lines: list[bytes], k: int) -> list[bytes]:
    return [*lines[:k], lines[k].replace(b'"wrong"', b'"pass"', 1), *lines[k + 1 :]]


def space_added(lines: list[bytes], k: int) -> list[bytes]:
    return [*lines[:k], b" " + lines[k], *lines[k + 1 :]]


def code_changed(lines: list[bytes], k: int) -> list[bytes]:
    other = b"1" if lines[k][-4:-3] == b"0" else b"0"
    return [*lines[:k], lines[k][:-4] + other + lines[k][-3:], *lines[k + 1 :]]


def code_removed(lines: list[bytes], k: int) -> list[bytes]:
    return [*lines[:k], lines[k].rpartition(b',"chain"')[0] + b"}\n", *lines[k + 1 :]]


def removed(lines: list[bytes], k: int) -> list[bytes]:
    return [*lines[:k], *lines[k + 1 :]]


def swapped(lines: list[bytes], k: int) -> list[bytes]:
    return [*lines[:k], lines[k + 1], lines[k], *lines[k + 2 :]]


def inserted(lines: list[bytes], k: int) -> list[bytes]:
    return [*lines[:k], b'{"number":9}\n', *lines[k:]]


def duplicated(lines: list[bytes], k: int) -> list[bytes]:
    return [*lines[: k + 1], *lines[k:]]


WAYS: list[tuple[Callable[[list[bytes], int], list[bytes]], range, int]] = [
    (changed, range(1, LINES), 0),
    (verdict_changed, range(4, 5), 0),
    (space_added, range(LINES), 0),
    (code_changed, range(LINES), 0),
    (code_removed, range(LINES), 0),
    (removed, range(1, LINES - 1), 0),
    (swapped, range(1, LINES - 1), 0),
    (inserted, range(1, LINES + 1), 0),
    (duplicated, range(LINES), 1),
]


@pytest.mark.parametrize(("way", "places", "off"), WAYS, ids=[w.__name__ for w, *_ in WAYS])
def test_a_line_that_is_not_as_it_was_written_is_refused_by_its_number(
    path: Path, way: Callable[[list[bytes], int], list[bytes]], places: range, off: int
) -> None:
    lines = path.read_bytes().splitlines(keepends=True)
    assert len(lines) == LINES
    for k in places:
        error = refused(path, way(lines, k))
        assert error.what.startswith(f"line {k + off + 1} "), (way.__name__, k, error)
        assert error.code == "bad-ledger" and error.where == str(path)


def test_lines_that_a_program_forges_without_the_key_are_refused(path: Path) -> None:
    """Forges lines with the plain hash chain, with another key, and with codes copied from other
    lines."""
    lines = path.read_bytes().splitlines(keepends=True)
    plain = json.dumps({"number": 9, "spent": 0.0}, separators=(",", ":")).encode()
    seen = lines[-1][-35:-3]
    by_hash = hashlib.sha256(seen + plain).hexdigest()[:32].encode()
    for code in (by_hash, seen, b"0" * 32, Chain(b"guess").close(plain)[-34:-2]):
        forged = plain[:-1] + b',"chain":"' + code + b'"}\n'
        assert refused(path, [*lines, forged]).what.startswith(f"line {LINES + 1} ")
    own, whole = Chain(b"guess"), []
    for line in lines:
        value = json.loads(line)
        del value["chain"]
        whole.append(own.close(json.dumps(value, separators=(",", ":")).encode()) + b"\n")
    assert refused(path, whole).what.startswith("line 1 ")


def test_lines_of_another_ledger_are_refused(path: Path, tmp_path: Path) -> None:
    """Mixes two ledgers of the same run, begun twice."""
    with Ledger(tmp_path / "other.jsonl", HEAD) as ledger:
        for number in range(RESULTS):
            ledger.write(result(number, Verdict.UNDECIDED))
    lines, others = (
        p.read_bytes().splitlines(keepends=True) for p in (path, tmp_path / "other.jsonl")
    )
    for k in range(2, LINES):
        error = refused(path, [*lines[:k], others[k], *lines[k + 1 :]])
        assert error.what.startswith(f"line {k + 1} ")


def test_a_ledger_that_is_cut_off_anywhere_goes_on_from_its_whole_lines(path: Path) -> None:
    """Cuts the ledger as a kill at any moment would; the lost cases are asked again."""
    data = path.read_bytes()
    ends = [k for k, byte in enumerate(data) if byte == ord("\n")]
    near = {end + step for end in ends for step in (-1, 0, 1)}
    for length in sorted({*range(0, len(data), 11), *near}):
        path.write_bytes(data[:length])
        whole = max(0, data[:length].count(b"\n") - 1)
        assert count(path) == whole
        if length not in near:
            continue
        with Ledger(path, HEAD) as ledger:
            for number in range(whole, RESULTS):
                ledger.write(result(number))
        assert count(path) == RESULTS


def test_a_ledger_of_another_key_is_refused_and_says_so(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "elsewhere"))
    error = refused(path, [path.read_bytes()])
    assert error.code == "other-key" and "XDG_STATE_HOME" in error.mend


@pytest.mark.parametrize("version", ["ledger-v1", "ledger-v2", "ledger-v99"])
def test_a_ledger_of_another_version_is_refused_and_says_so(path: Path, version: str) -> None:
    head = json.dumps({"ledger": version, **HEAD}).encode() + b"\n"
    error = refused(path, [head, b'{"number":0}\n'])
    assert error.code == "other-ledger" and version in error.what


def test_the_key_is_made_once_and_only_its_user_may_read_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    key = ledger_key()
    assert len(key) == 32 and key == ledger_key()
    file = tmp_path / "state" / "minkref" / "ledger.key"
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(file.parent.stat().st_mode) == 0o700
    assert key.hex() not in Chain(key).name
    file.write_bytes(b"")  # killed before it was written
    assert len(ledger_key()) == 32
    for damaged in (b"short", b"x" * 33):
        file.write_bytes(damaged)
        with pytest.raises(Refusal, match="no key"):
            ledger_key()


@pytest.mark.parametrize("folder", ["file", "/proc/nowhere"])
def test_without_a_place_for_the_key_no_ledger_is_begun(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, folder: str
) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / folder))
    with pytest.raises(Refusal, match="no place for the key"):
        Ledger(tmp_path / "run.jsonl", HEAD)
    assert os.listdir(tmp_path) == ["file"]


@pytest.mark.parametrize("given", [None, "", "relative/folder"])
def test_the_state_is_in_the_folder_of_the_user_by_default(
    monkeypatch: pytest.MonkeyPatch, given: str | None
) -> None:
    if given is None:
        monkeypatch.delenv("XDG_STATE_HOME")
    else:
        monkeypatch.setenv("XDG_STATE_HOME", given)
    assert state_folder() == Path.home() / ".local" / "state" / "minkref"


@pytest.mark.parametrize(
    "change", [{"number": [1]}, {"number": "1"}, {"name": {"text": 1, "group": ""}}]
)
def test_values_of_other_kinds_are_no_result_even_under_the_key(
    path: Path, change: dict[str, object]
) -> None:
    chain = Chain(ledger_key())
    lines = []
    for number, line in enumerate(path.read_bytes().splitlines()):
        value = json.loads(line)
        del value["chain"]
        if number == 2:
            value = {**value, **change}
        lines.append(chain.close(json.dumps(value, separators=(",", ":")).encode()) + b"\n")
    assert refused(path, lines).what.startswith("line 3 is no result")
