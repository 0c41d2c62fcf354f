"""Code in the pages does what they say."""

from __future__ import annotations

import shutil
from collections import Counter
from pathlib import Path

import pytest
from minkref.reports.documentation.blocks import blocks
from minkref.reports.documentation.running import run_page

ROOT = Path(__file__).resolve().parents[2]
PAGES = sorted(
    page.relative_to(ROOT) for page in [ROOT / "README.md", *(ROOT / "docs").glob("**/*.md")]
)
SHOWN = [page for page in PAGES if blocks(ROOT, page)]
MARKED = 21
NEEDED = {"docs/tutorials/adapter.md": ("node", "rustc")}  # beside what builds minkref


@pytest.mark.parametrize("page", SHOWN, ids=str)
def test_blocks_do_what_the_page_says(page: Path, tmp_path: Path) -> None:
    for tool in NEEDED.get(str(page), ()):
        if not shutil.which(tool):
            pytest.skip(f"{tool} is not installed")
    failures = run_page(page, tmp_path)
    assert not failures, "\n".join(map(str, failures))


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
