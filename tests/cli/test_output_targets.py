"""`-o -`, devices and descriptors: the same rule for every command that writes one text."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from forked import forked

MINKREF = f"{sys.executable} -m minkref"
NOTCH = "POLYGON ((0 0, 3 0, 3 3, 2 3, 2 1, 1 1, 1 3, 0 3, 0 0))"
TEXTS = {
    "sum": "sum g1 g2",
    "sum in space": "sum rod rod",
    "convolution": "convolution g1 g2",
    "convolution in space": "convolution rod rod --format ply",
    "events": f"events '{NOTCH}' '{NOTCH}' --limit 5",
    "view": f"view '{NOTCH}' '{NOTCH}' --from 1 --to 9/8",
}
NO_STREAMS = {
    "index": ("index g1 g2 --from 1 --to 9/8", "name a file"),
    "sweep": ("sweep g1 g2 --from 1 --to 2 --steps 2", "--json"),
    "certify": ("certify g1 g2", "FILE.cert.json"),
    "generate": ("generate combs --count 1", "name a folder"),
    "report": ("report degeneracies", "name a folder"),
}


def shell(line: str, where: Path) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(["bash", "-c", line], capture_output=True, cwd=where, env={**os.environ})


def opened(path: str | Path, descriptor: int, mode: int = os.O_WRONLY) -> Callable[[], None]:
    """As a shell does before it starts a program."""

    def become() -> None:
        there = os.open(path, mode)
        os.dup2(there, descriptor)
        if there != descriptor:
            os.close(there)

    return become


@pytest.mark.parametrize("name", TEXTS)
def test_standard_output_has_several_names_and_takes_nothing_else(
    name: str, tmp_path: Path
) -> None:
    texts = []
    for output in ("-", "/dev/stdout", "/dev/fd/1"):
        ran = forked(tmp_path, *shlex.split(TEXTS[name]), "-o", output)
        assert ran.returncode == 0
        texts.append(_without_times(ran.stdout))
    assert texts[0] == texts[1] == texts[2] != ""
    assert not list(tmp_path.iterdir())


def _without_times(text: str) -> str:
    try:
        document = json.loads(text)
    except ValueError:
        return text
    for name in ("seconds", "compute_seconds", "peak_bytes", "output"):
        document.pop(name, None)
    return json.dumps(document)


@pytest.mark.parametrize("name", TEXTS)
def test_devices_and_descriptors_are_written_to_themselves(name: str, tmp_path: Path) -> None:
    kept = tmp_path / "kept"
    kept.write_bytes(b"before\n")
    words = [*shlex.split(TEXTS[name]), "-o"]
    open_it = opened(kept, 3, os.O_WRONLY | os.O_APPEND)
    ran = forked(tmp_path, *words, "/dev/fd/3", before=open_it)
    assert (ran.returncode, "written" in ran.stdout) == (0, True)
    assert kept.read_bytes().startswith(b"before\n")
    assert len(kept.read_bytes()) > 100
    assert forked(tmp_path, *words, "/dev/null").returncode == 0


def test_a_pipe_of_the_shell_is_written_to(tmp_path: Path) -> None:
    assert shell(f"{MINKREF} {TEXTS['sum']} -o >(cat >copied)", tmp_path).returncode == 0


def test_standard_output_that_is_a_file_is_gone_on_with(tmp_path: Path) -> None:
    ran = shell(f"echo before >f; {MINKREF} sum g1 g2 -o /dev/stdout --format json >>f", tmp_path)
    assert ran.returncode == 0
    before, text = (tmp_path / "f").read_text().splitlines()
    assert before == "before"
    assert json.loads(text)["polygons"]


@pytest.mark.parametrize("name", TEXTS)
def test_full_devices_say_so(name: str, tmp_path: Path) -> None:
    for output, descriptor in (("/dev/full", 9), ("-", 1), ("/dev/fd/3", 3)):
        open_it = opened("/dev/full", descriptor)
        ran = forked(tmp_path, *shlex.split(TEXTS[name]), "-o", output, before=open_it)
        assert (ran.returncode, "No space left" in ran.stderr) == (2, True)


@pytest.mark.parametrize("output", ["-", "/dev/fd/3 3>&1 >/dev/null"])
def test_a_reader_that_goes_ends_it_quietly(output: str, tmp_path: Path) -> None:
    line = f"{MINKREF} events g3 cells1815 --format jsonl -o {output}"
    ran = shell(f"({line}) | head -1 | wc -l; exit ${{PIPESTATUS[0]}}", tmp_path)
    assert (ran.returncode, ran.stdout.split(), ran.stderr) == (141, [b"1"], b"")


@pytest.mark.parametrize("output", ["-", "/dev/stdout", "/dev/null"])
@pytest.mark.parametrize("name", NO_STREAMS)
def test_what_is_no_single_text_is_refused_before_the_work(
    name: str, output: str, tmp_path: Path
) -> None:
    command, mend = NO_STREAMS[name]
    ran = forked(tmp_path, *command.split(), "-o", output)
    assert ran.returncode == 2
    assert mend in ran.stderr
    assert not list(tmp_path.iterdir())


def test_a_descriptor_that_is_not_open_is_refused(tmp_path: Path) -> None:
    ran = shell(f"{MINKREF} sum g1 g2 -o /dev/fd/77", tmp_path)
    assert (ran.returncode, b"descriptor 77 is not open" in ran.stderr) == (2, True)
    ran = shell(f"{MINKREF} sum g1 g2 -o /dev/fd/1 --json", tmp_path)
    assert (ran.returncode, b"not both" in ran.stdout) == (2, True)
