"""Results of parts, kept in build/evidence until the code that they depend on changes."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.part import SCRIPTS, Part

SCRIPTS_FOLDER = SCRIPTS
ROOT = SCRIPTS.parents[1]
FOLDER = ROOT / "build" / "evidence"
PAPER_FILES = ("nazca_monkey.poly", "bird.poly", "neuron.poly")


def result_path(name: str, quick: bool) -> Path:
    """A quick result has a file of its own: it never replaces a full one."""
    return FOLDER / f"{name}{'.quick' if quick else ''}.json"


def log_path(name: str) -> Path:
    return FOLDER / f"{name}.log"


def dependency_hash(part: Part) -> str:
    """SHA-256 over names and contents of the files that the part's globs name, of its own script,
    and of the paper's models where MINKREF_MODELS provides them."""
    files = {path for glob in part.depends for path in ROOT.glob(glob) if path.is_file()}
    files |= set((SCRIPTS_FOLDER / "framework").glob("*.py"))
    files.add(SCRIPTS_FOLDER / f"{part.name}.py")
    files = {path for path in files if path.is_file()}
    total = hashlib.sha256()
    for path in sorted(files):
        name = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path.name
        total.update(f"{name} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    for file in PAPER_FILES:
        path = Path(os.environ.get("MINKREF_MODELS", "")) / file
        if os.environ.get("MINKREF_MODELS") and path.is_file():
            total.update(f"{file} {hashlib.sha256(path.read_bytes()).hexdigest()}\n".encode())
    return total.hexdigest()


def read(name: str, quick: bool) -> dict[str, Any] | None:
    """The kept result, or None where there is none that can be read."""
    try:
        value = json.loads(result_path(name, quick).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return value if isinstance(value, dict) and value.get("name") == name else None


def write(document: dict[str, Any]) -> None:
    path = result_path(document["name"], document["quick"])
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(".part")
    beside.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    beside.replace(path)


def kept(part: Part, quick: bool) -> dict[str, Any] | None:
    """A finished result that still stands for this code: a full one also serves a quick run. One
    that failed is never kept."""
    wanted = dependency_hash(part)
    for form in (False, True) if quick else (False,):
        document = read(part.name, form)
        if document and document["dependencies"] == wanted and document["status"] != "failed":
            return document
    return None
