"""The pages of the repository, where they are, so that their links to one another stay; and pages
for the source files that they point to."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from posixpath import normpath

from commonmark import for_python_markdown

LINK = re.compile(r"(?<=\]\()(?!#|[a-z+]+:)([^)\s#]+)(#[^)\s]*)?(?=\))")
PICTURES = {".svg", ".png"}
LANGUAGES = {
    ".hpp": "cpp",
    ".cpp": "cpp",
    ".h": "c",
    ".c": "c",
    ".py": "python",
    ".js": "javascript",
    ".json": "json",
    ".rs": "rust",
    ".sh": "bash",
    ".yml": "yaml",
    ".toml": "toml",
}


def documents(root: Path) -> list[Path]:
    """All Markdown of the repository, but for fixtures of the tests."""
    listed = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"],
        cwd=root,
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    )
    return sorted(Path(line) for line in listed.stdout.splitlines() if (root / line).is_file())


def place(root: Path, pages: Path, sources: set[Path]) -> None:
    """Writes them below `pages`. `sources` gets the files that they point to."""
    for document in documents(root):
        text = (root / document).read_text(encoding="utf-8")

        def target(found: re.Match[str], document: Path = document) -> str:
            path = Path(normpath(str(document.parent / found[1])))
            if path.suffix == ".md" or not (root / path).exists():
                return found[0]  # what is missing is told by the generator
            if (root / path).is_dir():
                return f"{found[1].rstrip('/')}/README.md{found[2] or ''}"
            sources.add(path)
            return found[0] if path.suffix in PICTURES else f"{found[1]}.md"

        write(pages / document, for_python_markdown(_outside_code(text, target)))


def _outside_code(text: str, target: object) -> str:
    parts = re.split(r"(^ *```.*?^ *```$|`[^`\n]+`(?!\]))", text, flags=re.MULTILINE | re.DOTALL)
    return "".join(
        part if number % 2 else LINK.sub(target, part)  # type: ignore[call-overload]
        for number, part in enumerate(parts)
    )


def place_sources(root: Path, pages: Path, sources: set[Path]) -> Iterator[Path]:
    """The pages of source files; pictures are copied."""
    for source in sorted(sources):
        if source.suffix in PICTURES:
            (pages / source).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(root / source, pages / source)
            continue
        code = (root / source).read_text(encoding="utf-8")
        fence = "~" * (1 + max([3, *map(len, re.findall(r"^~+", code, re.MULTILINE))]))
        head = "---\nsearch:\n  exclude: true\nhide: [toc]\n---\n"
        language = LANGUAGES.get(source.suffix, "text")
        page = source.with_name(f"{source.name}.md")
        block = f'{fence}{{.{language} linenums="1"}}\n{code.rstrip()}\n{fence}\n'
        write(pages / page, f"{head}# {source}\n\n{block}")
        yield page


def rank(page: str) -> float:
    """What the search multiplies the weight of a page's words by: the guide comes first, then what
    is said of commands and classes, last what lists everything."""
    if page == "README.md" or page.startswith(("docs/", "api/command-line", "api/python")):
        return 1.0 if page.startswith(("docs/audit/", "api/")) else 4.0
    return 0.25 if page.startswith("api/") else 0.5


def rank_all(pages: Path) -> None:
    """Pages with a head of their own, which are those of source files, are not searched."""
    for path in pages.rglob("*.md"):
        text = path.read_text(encoding="utf-8")
        if not text.startswith("---\n"):
            boost = rank(str(path.relative_to(pages)))
            write(path, f"---\nsearch:\n  boost: {boost}\n---\n{text}")


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
