"""stage.py FOLDER: all that the generator makes the site of, in FOLDER/pages, and its settings in
FOLDER/mkdocs.yml.

The pages keep the places that they have in the repository; made here are the reference (api/), the
gallery and the pages of source files. Run by tools/scripts/docs.sh in the
environment of docs/site/requirements.txt.
"""

from __future__ import annotations

import json
import shutil
import sys
from pathlib import Path
from typing import Any

import cpp_api
import gallery
import python_api
import repository_pages
import tool_pages
from repository_pages import write

ROOT = Path(__file__).resolve().parents[2]
TUTORIALS = ("README", "first-sum", "python", "cpp", "adapter", "reading-a-finding")
GUIDE = (
    "README",
    "definitions",
    "formats",
    "command-line",
    "scale-index",
    "paths",
    "scenes",
    "disc",
    "decomposition",
    "space-sums",
    "convex-polyhedra",
    "first-finding",
    "verify",
    "campaigns",
    "campaigns-ledger",
    "findings",
    "matrix",
    "adapter-protocol",
    "ci",
    "security",
    "strategies",
    "certificates",
    "proved",
    "certificates-convex",
    "certificates-solids",
    "certificates-paths",
    "certificates-features",
    "certificates-disc",
    "certificates-unions",
    "degeneracies",
    "roadmap",
)
Navigation = list[Any]


def main(folder: Path) -> None:
    pages = folder / "pages"
    shutil.rmtree(pages, ignore_errors=True)
    pages.mkdir(parents=True)
    sources: set[Path] = set()
    repository_pages.place(ROOT, pages, sources)
    for name in ("site.css", "iframe-worker.js"):
        shutil.copyfile(ROOT / "docs/site" / name, pages / name)

    headers = cpp_api.headers(ROOT)
    for header in headers:
        write(pages / header.page, header.text())
        sources.add(Path(header.path))
    write(pages / cpp_api.FOLDER / "README.md", cpp_api.index(headers))
    write(pages / python_api.PAGE, python_api.page(ROOT))
    write(pages / tool_pages.COMMAND_LINE, tool_pages.command_line(ROOT))
    schemas = list(tool_pages.schema_pages(ROOT))
    for page, text in schemas:
        write(pages / page, text)
    write(pages / gallery.PLACE / "README.md", gallery.make(ROOT, pages))
    shown = list(repository_pages.place_sources(ROOT, pages, sources))
    repository_pages.rank_all(pages)

    navigation = _navigation(pages, headers, [page for page, _ in schemas if page.suffix == ".md"])
    settings = {
        "INHERIT": str(ROOT / "docs/site/mkdocs.yml"),
        "docs_dir": str(pages),
        "site_dir": str(ROOT / "build/site"),
        "hooks": [str(ROOT / "docs/site/hooks.py")],
        "nav": navigation,
        "not_in_nav": "\n".join(f"/{page}" for page in shown),
        "plugins": {"mkdocstrings": {"handlers": {"python": {"paths": [str(ROOT)]}}}},
    }
    write(folder / "mkdocs.yml", json.dumps(settings, indent=1))  # JSON is YAML


def _navigation(pages: Path, headers: list[cpp_api.Header], schemas: list[Path]) -> Navigation:
    rooms: dict[str, Navigation] = {}
    for header in headers:
        rooms.setdefault(str(Path(header.path).parent), []).append(
            {Path(header.path).name: str(header.page)}
        )
    listed = [
        {"Home": "README.md"},
        {"Tutorials": [f"docs/tutorials/{name}.md" for name in TUTORIALS]},
        {"Guide": [f"docs/{name}.md" for name in GUIDE]},
        {
            "Reference": [
                {"Python": str(python_api.PAGE)},
                {"Command line": str(tool_pages.COMMAND_LINE)},
                {
                    "JSON schemas": sorted(
                        map(str, schemas), key=lambda page: ("README" not in page, page)
                    )
                },
                {
                    "C++": [
                        str(cpp_api.FOLDER / "README.md"),
                        *({room: members} for room, members in rooms.items()),
                    ]
                },
            ]
        },
        {"The paper": ["docs/paper.md", *_of(pages, "docs/audit")]},
        {"Degenerate cases": ["degeneracies/README.md", *_of(pages, "degeneracies/pages")]},
        {"Gallery": [str(gallery.PLACE / "README.md")]},
    ]
    held = json.dumps(listed)
    others = [str(path) for path in repository_pages.documents(ROOT) if f'"{path}"' not in held]
    return [*listed, {"The project": [{_title(path): path} for path in others]}]


def _of(pages: Path, folder: str) -> list[str]:
    """The pages of a folder, its index first."""
    found = [str(path.relative_to(pages)) for path in (pages / folder).glob("*.md")]
    return sorted(found, key=lambda page: (not page.endswith("README.md"), page))


def _title(path: str) -> str:
    return path.removesuffix("/README.md").removesuffix(".md")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve())
