"""Runs a page's code blocks in an empty folder, one after another, and compares the output with the
page."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from minkref.reports.documentation.blocks import Block, blocks, json_values

ROOT = Path(__file__).resolve().parents[2]
SECONDS = 900.0  # for one command
NUMBERS = re.compile(r"\d+\.\d+(e[-+]\d+)?")  # seconds and roundings, which vary
# Shorter versions of long runs on the pages.
SHORTER = (
    (re.compile(r"--seconds \d+"), "--pairs 12 --no-models --jobs 2"),
    (re.compile(r"--count \d+"), "--count 2"),
)


@dataclass(frozen=True)
class Failure:
    block: Block
    what: str

    def __str__(self) -> str:
        return f"{self.block.place}: {self.what}"


def environment() -> dict[str, str]:
    """The commands' environment: MINKREF is the checkout, whose command comes first."""
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    return {**os.environ, "PATH": path, "COLUMNS": "100", "MINKREF": str(ROOT), "NO_COLOR": "1"}


def run_page(page: Path, folder: Path) -> list[Failure]:
    """The page's failures; later blocks run after a failure too."""
    failures: list[Failure] = []
    printed = ""
    for block in blocks(ROOT, page):
        try:
            if block.told("not run") is None:
                printed = _run(block, folder, printed)
        except AssertionError as error:
            failures.append(Failure(block, str(error)))
    return failures


def _run(block: Block, folder: Path, printed: str) -> str:
    """The block's output. Raises AssertionError."""
    for command in block.all_of("first"):
        _shell(command, folder)
    codes = (0,) if block.told("finds") is None else (0, 1)
    name, function = block.told("file"), block.told("replaces")
    if name is not None:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(block.text, encoding="utf-8")
    elif function is not None:
        _replace(function, block.text, folder)
    elif block.told("prints") is not None:
        _compare(block.text.splitlines(), printed.splitlines(), "the block before")
    elif block.kind == "json":
        _json(block.text)
    elif block.kind == "console":
        _transcript(block, folder)
    elif block.kind == "shell":
        for command in block.text.replace("\\\n", " ").splitlines():
            _shell(command, folder, codes)
    elif block.kind == "python":
        (folder / "block.py").write_text(block.text, encoding="utf-8")
        return _output([sys.executable, "block.py"], folder, "the block", codes)
    elif block.kind == "cpp":
        return _compiled(block, folder)
    return ""


def _json(text: str) -> None:
    try:
        json_values(text)
    except ValueError as error:
        raise AssertionError(f"the block is no JSON: {error}") from None


def _transcript(block: Block, folder: Path) -> None:
    """Runs a transcript: lines that begin with `$` are commands, the lines below show their output;
    `...` stands for any lines."""
    shown: list[tuple[str, list[str]]] = []
    for line in block.text.replace("\\\n", " ").splitlines():
        if line.startswith("$ "):
            shown.append((line.removeprefix("$ "), []))
        elif line.strip() or shown[-1][1]:
            shown[-1][1].append(line)
    for command, lines in shown:
        output = _shell(command, folder, (1,) if " wrong" in "\n".join(lines) else (0,))
        if lines:
            _compare(lines, output.splitlines(), command)


def _shell(command: str, folder: Path, codes: tuple[int, ...] = (0,)) -> str:
    for long, short in SHORTER if command.lstrip().startswith(("minkref", "PYTHONPATH")) else ():
        command = long.sub(short, command)
    return _output(["bash", "-c", command], folder, command, codes)


def _output(words: list[str], folder: Path, name: str, codes: tuple[int, ...] = (0,)) -> str:
    done = subprocess.run(
        words,
        cwd=folder,
        env=environment(),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )
    said = (done.stdout + done.stderr)[-3000:]
    assert done.returncode in codes, f"{name}: exit code {done.returncode}, not {codes[0]}\n{said}"
    return done.stdout


def _compare(shown: list[str], printed: list[str], name: str) -> None:
    text = "\n".join(printed)
    assert follows(shown, printed), f"{name} prints something else:\n{text}"


def follows(shown: list[str], said: list[str]) -> bool:
    """Whether the output equals the shown lines, where `...` stands for any number of lines."""
    if not shown:
        return not any(line.strip() for line in said)
    if shown[0].strip() == "...":
        return any(follows(shown[1:], said[k:]) for k in range(len(said) + 1))
    return bool(said) and _plain(shown[0]) == _plain(said[0]) and follows(shown[1:], said[1:])


def _plain(line: str) -> str:
    return " ".join(NUMBERS.sub("0.0", line).split())


def _replace(where: str, text: str, folder: Path) -> None:
    """Replaces a function, which ends before the next line at the margin that is no brace."""
    function, _, name = where.partition(" in ")
    lines = (folder / name).read_text(encoding="utf-8").splitlines()
    begins = [k for k, line in enumerate(lines) if re.match(rf"\S.*\b{function}\(", line)]
    assert len(begins) == 1, f"{name} has {len(begins)} definitions of {function}"
    end = begins[0] + 1
    while end < len(lines) and (not lines[end] or lines[end][0] in " )"):
        end += 1
    end += end < len(lines) and lines[end].startswith("}")
    after = lines[end:]
    (folder / name).write_text("\n".join([*lines[: begins[0]], text, *after, ""]), encoding="utf-8")


def _compiled(block: Block, folder: Path) -> str:
    """Compiles and runs the block with the library from build/release."""
    (folder / "block.cpp").write_text(block.text, encoding="utf-8")
    library = ROOT / "build" / "release" / "reference" / "libminkref_reference.a"
    words = ["c++", "-std=c++20", f"-I{ROOT}", "-isystem", "/usr/include/eigen3", "block.cpp"]
    words += ["-o", "block", str(library), "-lmpfr", "-lgmp", "-pthread"]
    _output(words, folder, "the compiler")
    return _output(["./block"], folder, "the program")
