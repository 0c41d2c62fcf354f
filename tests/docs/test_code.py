"""Code in the pages does what they say."""

from __future__ import annotations

from pathlib import Path

import pytest
from minkref.reports.documentation.running import run_page

ROOT = Path(__file__).resolve().parents[2]
TUTORIALS = sorted(page.relative_to(ROOT) for page in (ROOT / "docs/tutorials").glob("*.md"))


@pytest.mark.parametrize("page", TUTORIALS, ids=lambda page: page.stem)
def test_tutorials(page: Path, tmp_path: Path) -> None:
    failures = run_page(page, tmp_path)
    assert not failures, "\n".join(map(str, failures))


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
