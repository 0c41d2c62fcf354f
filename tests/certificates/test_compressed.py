"""Checkers take plain JSON, from files and from standard input; `minkref check` unpacks."""

from __future__ import annotations

import gzip
import json
import random
import subprocess
from pathlib import Path
from typing import Any

import cubes
import pytest
import squares
import walls
from file_alone import laid
from minkref.cli.cli import run
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python

FORMS = pytest.mark.parametrize("given", [squares, cubes, walls], ids=["plane", "space", "paths"])
CHECKERS = pytest.mark.parametrize("checker", [in_python, in_cpp])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return laid(tmp_path, squares.CASE, squares.certificate())


def verdict(capsys: Any, *words: str) -> tuple[int, str]:
    code = run(["check", *words])
    return code, capsys.readouterr().out


@FORMS
def test_checkers_refuse_what_is_compressed(check: Any, tmp_path: Path, given: Any) -> None:
    laid(tmp_path, given.CASE, given.certificate())
    file = tmp_path / "it.cert.json"
    file.write_bytes(gzip.compress(file.read_bytes()))
    code, said = check(file)
    assert code == 2 and "gzip -dc FILE | python3 check.py -, or minkref check FILE" in said
    assert check(file, "--bytes", "20")[0] == 4


def test_checkers_refuse_a_case_that_is_compressed(check: Any, folder: Path) -> None:
    (folder / "case.json").write_bytes(gzip.compress((folder / "case.json").read_bytes()))
    code, said = check(folder / "it.cert.json")
    assert code == 2 and "case.json is compressed by gzip" in said


def piped(command: list[str], folder: Path, text: bytes, *options: str) -> tuple[int, str]:
    ran = subprocess.run([*command, *options, "-"], cwd=folder, input=text, capture_output=True)
    assert ran.stderr == b"", ran.stderr
    return ran.returncode, ran.stdout.decode()


@CHECKERS
@FORMS
def test_standard_input(tmp_path: Path, given: Any, checker: Any) -> None:
    text = (laid(tmp_path, given.CASE, given.certificate()) / "it.cert.json").read_bytes()
    code, said = piped(checker(), tmp_path, text)
    assert code == 0 and said.startswith("-: verified\n")
    assert piped(checker(), tmp_path, text, "--bytes", str(len(text) - 1))[0] == 4
    for other in (gzip.compress(text), b"", text[:-1]):
        assert piped(checker(), tmp_path, other)[0] == 2


@CHECKERS
def test_a_case_that_is_called_as_standard_input_is_a_file(folder: Path, checker: Any) -> None:
    """A certificate has no say about what else is read."""
    value = squares.certificate()
    value["case"]["path"] = "-"
    text = json.dumps(value).encode()
    assert piped(checker(), folder, text)[0] == 2
    (folder / "case.json").rename(folder / "-")
    assert piped(checker(), folder, text)[0] == 0


@pytest.mark.parametrize("level", [0, 1, 9])
@FORMS
def test_the_command_unpacks(capsys: Any, tmp_path: Path, given: Any, level: int) -> None:
    """One whole member of gzip, and nothing after it."""
    text = (laid(tmp_path, given.CASE, given.certificate()) / "it.cert.json").read_bytes()
    packed = gzip.compress(text, level)
    file = tmp_path / "it.cert.json.gz"
    file.write_bytes(packed)
    assert verdict(capsys, str(file))[0] == 0
    assert verdict(capsys, str(file), "--bytes", str(len(text) - 1))[0] == 4
    for spoilt in (packed[:-20], packed[:-1], packed + b"\0", packed + packed, packed[:9]):
        file.write_bytes(spoilt)
        code, said = verdict(capsys, str(file))
        assert code == 2 and ("one whole compressed file" in said or "is not JSON" in said)
    file.write_bytes(gzip.compress(packed))
    assert verdict(capsys, str(file))[0] == 2


def test_the_command_unpacks_the_case(capsys: Any, folder: Path) -> None:
    case, file = folder / "case.json", folder / "it.cert.json"
    case.write_bytes(gzip.compress(case.read_bytes()))
    assert verdict(capsys, str(file))[0] == 0
    case.rename(folder / "other")
    assert verdict(capsys, str(file), "--case", str(folder / "other"))[0] == 0
    assert verdict(capsys, str(file))[0] == 2


def test_a_bomb_is_not_unpacked(capsys: Any, folder: Path) -> None:
    file = folder / "it.cert.json"
    file.write_bytes(gzip.compress(file.read_bytes()[:-1] + b" " * 2**26 + b"}"))
    code, said = verdict(capsys, str(file), "--bytes", "1e6")
    assert code == 4 and "over 1,000,000 bytes" in said


def test_damaged_compressed_files(capsys: Any, folder: Path) -> None:
    """Any byte after the header may be another: what has changed is not verified. (Of the header
    only the time, the system and what was the best may be others.)"""
    packed = gzip.compress((folder / "it.cert.json").read_bytes())
    file = folder / "it.cert.json.gz"
    dice = random.Random(7)
    for at in [0, 1, 2, 3, *dice.sample(range(10, len(packed)), 60)]:
        other = bytes([packed[at] ^ dice.randrange(1, 256)])
        file.write_bytes(packed[:at] + other + packed[at + 1 :])
        assert verdict(capsys, str(file))[0] in (1, 2), at
