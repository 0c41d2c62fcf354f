"""Repository files that a step's processes read and started."""

from __future__ import annotations

import os
import subprocess
from functools import cache
from pathlib import Path

from minkref.reports.evidence.framework.includes import reached

RECORDER = Path(__file__).with_name("recording")
VARIABLE = "MINKREF_EVIDENCE_RECORD"
MODELS = "MINKREF_MODELS"  # prefixes names of the paper's own models, which lie elsewhere
PAPER_FILES = ("nazca_monkey.poly", "bird.poly", "neuron.poly")
LISTED = "minkref/models/index.json"


def environment(folder: Path) -> dict[str, str]:
    """An environment for a process that makes it and its Python children record to this folder."""
    before = os.environ.get("PYTHONPATH", "")
    path = os.pathsep.join(filter(None, (str(RECORDER), before)))
    return {**os.environ, VARIABLE: str(folder), "PYTHONPATH": path}


def files_of(folder: Path, root: Path) -> set[str]:
    """Names from the root: what was read, and of extension module and programs the sources."""
    found = {name for line in lines(folder) if (name := named(line, root))}
    if LISTED in found:  # C++ reads the listed files unnoticed
        found |= {name for name in known(root) if Path(name).parent == Path(LISTED).parent}
        found |= {f"{MODELS}/{name}" for name in PAPER_FILES}
    return reached(found, root)


def lines(folder: Path) -> set[str]:
    return {
        line for path in folder.iterdir() for line in os.fsdecode(path.read_bytes()).splitlines()
    }


def named(line: str, root: Path) -> str | None:
    """A read file's name in the repository: the source for a compiled module, and for a program
    built with CMake the folder of its sources: `oracle/cgal/` for
    `build/release/oracle/cgal/minkref-cgal-full`."""
    path = Path(line)
    if path.parent.name == "__pycache__":
        path = path.parent.parent / f"{path.name.partition('.')[0]}.py"
    path = path.resolve()
    if not path.is_relative_to(root):
        return None
    name = path.relative_to(root)
    if name.parts[:1] == ("build",):
        source = Path(*name.parts[2:-1])
        is_built = len(name.parts) > 3 and os.access(path, os.X_OK)
        return f"{source}/" if is_built and (root / source / "CMakeLists.txt").is_file() else None
    return str(name) if str(name) in known(root) else None


@cache
def known(root: Path) -> frozenset[str]:
    """All repository files: everything that git does not ignore, or without git everything
    present."""
    command = ["git", "-C", str(root), "ls-files", "-z", "-co", "--exclude-standard"]
    listed = subprocess.run(command, capture_output=True, text=True, check=False)
    if listed.returncode == 0:
        return frozenset(filter(None, listed.stdout.split("\0")))
    return frozenset(
        str(path.relative_to(root))
        for path in root.rglob("*")
        if path.is_file() and not {"build", ".venv", "__pycache__"} & set(path.parts)
    )
