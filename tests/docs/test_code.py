"""Code on the pages does what the pages say.

Long code runs only if the run is thorough: some code of each kind stays, and test_links.py looks at
the options of all commands. `minkref` runs inside copies of this process."""

from __future__ import annotations

import os
import re
import shlex
import shutil
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from forked import forked
from minkref.degeneracies.lint import CORPUS
from minkref.reports.documentation import running
from minkref.reports.documentation.blocks import Block, blocks
from minkref.reports.documentation.running import run_page
from thoroughness import THOROUGH

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted(
    page.relative_to(ROOT) for page in [ROOT / "README.md", *(ROOT / "docs").glob("**/*.md")]
)
SHOWN = [page for page in PAGES if blocks(ROOT, page)]
MARKED = 25
NEEDED = {"docs/tutorials/adapter.md": ("node", "rustc")}  # beside what builds minkref
#: Left out: the page has others of the kind, or tests/adapters and tests/consumer show the same.
LONG = (
    "--pairs 100 --no-models --report",  # of first-finding.md, that goes on with single cases
    "--case path:1:16",  # a finding that is shrunk: reading-a-finding.md has one too
    "reference/motion/fits_and_traps.hpp",  # a program in C++: scale-index.md has one
    "cmake -S . -B fetched",
)
#: From a command with one of these to the next `adapter new` of the page.
LANGUAGES = ("--language javascript", "--language rust", "--language c++")
#: Commands made shorter; their output is not compared, or stays the same.
SHORTER = (
    (r"--seconds \d+", "--pairs 4 --no-models"),
    (r"^minkref (generate|verify)", r"minkref \1 --jobs 1"),
    (r"--count 100|(?<=paths )--count 2", "--count 1"),
    (r"--suite corpus$", f"--suite corpus --corpus {CORPUS / 'needle-and-plate'}"),
    (r"glyph1204", "g1"),
    (r"--steps (20|3)", "--steps 2"),
    (r"(?<=double )-o paper.html", "-o paper.html --from 1 --to 2 --steps 2"),
)


@pytest.fixture
def shorter(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(running, "_output", in_a_copy(running._output))
    if not THOROUGH:
        patterns = [(re.compile(long), short) for long, short in SHORTER]
        monkeypatch.setattr(running, "SHORTER", (*patterns, *running.SHORTER))
        monkeypatch.setattr(running, "blocks", lambda root, page: list(taken(blocks(root, page))))


def taken(all_of_them: list[Block]) -> Iterator[Block]:
    """Quick blocks, each with the block that shows its output."""
    left_out = language = False
    for block in all_of_them:
        if "adapter new" in block.text:
            language = any(word in block.text for word in LANGUAGES)
        if block.told("prints") is None:
            # A transcript command by command, anything else whole.
            parts = (
                re.split(r"(?m)^(?=\$ )", block.text) if block.kind == "console" else [block.text]
            )
            text = "".join(part for part in parts if not any(word in part for word in LONG))
            left_out = not text
            block = replace(block, text=text)
        if not (left_out or language):
            yield block


def in_a_copy(output: Callable[..., str]) -> Callable[..., str]:
    """Replaces `output` for commands of minkref that need no shell."""

    def wrapped(words: list[str], folder: Path, name: str, codes: tuple[int, ...] = (0,)) -> str:
        command = words[-1].split(" #")[0]
        if words[0] != "bash" or not command.startswith("minkref ") or re.search("[$><|]", command):
            return output(words, folder, name, codes)
        ran = forked(
            folder,
            *shlex.split(command)[1:],
            before=lambda: os.environ.update(running.environment()),
        )
        said = (ran.stdout + ran.stderr)[-3000:]
        assert ran.returncode in codes, f"{name}: exit code {ran.returncode}\n{said}"
        return ran.stdout

    return wrapped


@pytest.mark.parametrize("page", SHOWN, ids=str)
def test_blocks_do_what_the_page_says(page: Path, tmp_path: Path, shorter: None) -> None:
    for tool in NEEDED.get(str(page), ()) if THOROUGH else ():
        if not shutil.which(tool):
            pytest.skip(f"{tool} is not installed")
    failures = run_page(page, tmp_path)
    assert not failures, "\n".join(map(str, failures))


def test_most_blocks_are_run_and_what_is_left_out_is_there() -> None:
    every = [block for page in SHOWN for block in blocks(ROOT, page)]
    left_out = len(every) - sum(len(list(taken(blocks(ROOT, page)))) for page in SHOWN)
    assert 0 < left_out < len(every) / 10
    for word in (*LONG, *LANGUAGES):
        assert any(word in block.text for block in every), word


def test_few_blocks_are_not_run_and_each_says_why() -> None:
    reasons = [block.told("not run") for page in SHOWN for block in blocks(ROOT, page)]
    marked = Counter(reason for reason in reasons if reason is not None)
    assert "" not in marked
    assert marked.total() == MARKED, marked


def written(folder: Path, text: str) -> Path:
    (folder / "page.md").write_text(text, encoding="utf-8")
    return folder / "page.md"


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("```console\n$ echo one\ntwo\n```\n", "echo one prints something else"),
        ("```console\n$ false\n```\n", "false: exit code 1, not 0"),
        ("```python\nprint(1)\n```\n<!-- prints: -->\n```\n2\n```\n", "prints something else"),
        ("```python\nraise ValueError\n```\n", "exit code 1, not 0"),
        ("```cpp\nint main() { return 3; }\n```\n", "exit code 3, not 0"),
        ('```json\n{"a": }\n```\n', "is no JSON"),
    ],
)
def test_what_is_wrong_is_told(tmp_path: Path, text: str, what: str) -> None:
    (failure,) = run_page(written(tmp_path, text), tmp_path)
    assert what in str(failure)


def test_marked_blocks_are_not_run(tmp_path: Path) -> None:
    page = written(tmp_path, "<!-- not run: it fails -->\n```console\n$ false\n```\n")
    assert run_page(page, tmp_path) == []
