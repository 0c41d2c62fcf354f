"""Programs on the pages pass a type checker's look at what they give to our functions: `py.typed`
promises it, and what runs may still be a fault to the editor of a reader."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from minkref.reports.documentation.blocks import blocks

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("**/*.md"))]
WRONG = ("[arg-type]", "[call-overload]", "[operator]")


def test_numbers_that_the_pages_give_have_the_types_of_the_signatures(tmp_path: Path) -> None:
    files = []
    for page in (page.relative_to(ROOT) for page in PAGES):
        for k, block in enumerate(blocks(ROOT, page)):
            if block.kind == "python" and "import minkref" in block.text:
                name = "_".join((*page.parent.parts, page.stem, str(k))).replace("-", "_")
                files.append(tmp_path / f"{name}.py")
                files[-1].write_text(block.text, encoding="utf-8")
    assert len(files) > 20
    words = [sys.executable, "-m", "mypy", "--config-file=", "--cache-dir", str(tmp_path)]
    ran = subprocess.run([*words, *map(str, files)], cwd=ROOT, capture_output=True, text=True)
    assert ran.returncode in (0, 1), ran.stdout + ran.stderr
    wrong = [line for line in ran.stdout.splitlines() if line.endswith(WRONG)]
    assert not wrong, "\n".join(wrong)
