"""Step results, kept in build/evidence until a file changes that they rest on."""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework import places
from minkref.reports.evidence.framework.part import Size
from minkref.reports.evidence.framework.recorded import MODELS, known

Document = dict[str, Any]
SUMMARY, RESTS_ON = "SUMMARY.md", "rests_on.json"  # in the room
BOOKKEEPERS = (
    "child",
    "on_workers",
    "includes",
    "places",
    "recorded",
    "stale",
    "steps",
    "store",
    "table",
)
PROSE = (".md", ".svg", RESTS_ON)  # a folder's hash leaves these files out


def result_path(step: str, size: Size) -> Path:
    return places.FOLDER / f"{step}.{size}.json"


def log_path(step: str) -> Path:
    return places.FOLDER / f"{step}.log"


def hashes(names: Iterable[str]) -> dict[str, str]:
    """Hashes by name. A folder replaces its files if all of them appear."""
    return {name: hash_of(name) for name in in_folders(names)}


def bookkeeping() -> frozenset[str]:
    """Files that start steps or keep and report results, and the summary, which the site shows:
    every step reads some such files, but no result rests on them."""
    if not places.ROOM.is_relative_to(places.ROOT):
        return frozenset()
    room = places.ROOM.relative_to(places.ROOT)
    modules = (room / "framework" / f"{name}.py" for name in BOOKKEEPERS)
    return frozenset(map(str, (room / SUMMARY, room / RESTS_ON, *modules)))


@cache
def hash_of(name: str) -> str:
    """The hash of a file, or of all files of a folder (`oracle/cgal/`) but prose; empty without the
    file."""
    if name.endswith("/"):
        rows = "".join(f"{one} {hash_of(one)}\n" for one in sorted(files_below(name)))
        return hashlib.sha256(rows.encode()).hexdigest()[:16]
    path = places.ROOT / name
    if name.startswith(f"{MODELS}/"):
        path = Path(os.environ.get(MODELS, ""), Path(name).name)
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16] if path.is_file() else ""


@cache
def files_below(folder: str) -> frozenset[str]:
    prefix = folder.removeprefix("./")
    every = known(places.ROOT)
    return frozenset(n for n in every if n.startswith(prefix) and not n.endswith(PROSE))


def in_folders(names: Iterable[str]) -> set[str]:
    """Replaces files by their folder if the folder is complete."""
    found = set(names)
    parents = {name: {f"{parent}/" for parent in Path(name).parents} for name in found}
    full = {f for f in set().union(*parents.values()) if len(files_below(f)) > 1 and
            files_below(f) <= found} | {name for name in found if name.endswith("/")}  # fmt: skip
    return {
        name for name in found | full
        if name.endswith(PROSE) or not full & {f"{parent}/" for parent in Path(name).parents}
    }  # fmt: skip


def commit_of(names: Iterable[str]) -> str:
    """HEAD, with a `+` if one of the files differs from HEAD; empty without git."""
    head = git("rev-parse", "HEAD").strip()
    return head + ("+" if touched(names, changed_since("HEAD") or ()) else "")


def changed_since(commit: str) -> list[str] | None:
    """Names of changed files; None if the commit does not exist."""
    command = ["git", "-C", str(places.ROOT), "diff", "--name-only", commit, "--"]
    told = subprocess.run(command, capture_output=True, text=True, check=False)
    if told.returncode:
        return None
    return [*told.stdout.splitlines(), *git("ls-files", "-o", "--exclude-standard").splitlines()]


def touched(names: Iterable[str], changed: Iterable[str]) -> bool:
    """Whether a changed file appears among the names, or below a named folder."""
    held = set(names)
    folders = tuple(name.removeprefix("./") for name in held if name.endswith("/"))
    return any(
        one in held or (one.startswith(folders) and not one.endswith(PROSE)) for one in changed
    )


def git(*words: str) -> str:
    command = ["git", "-C", str(places.ROOT), *words]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def read(step: str, size: Size) -> Document | None:
    """The result; None without a readable result."""
    try:
        value = json.loads(result_path(step, size).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return value if isinstance(value, dict) and value.get("step") == step else None


def write(document: Document) -> None:
    path = result_path(document["step"], Size[document["size"].upper()])
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_suffix(".part")
    beside.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    beside.replace(path)


def is_current(document: Document, with_models: bool = True) -> bool:
    """Whether every file that the result rests on is unchanged. The paper's models are not always
    at hand."""
    files = document["files"]  # empty: the run ended before the files were known
    unasked = bookkeeping()
    return bool(files) and all(
        hash_of(name) == digest
        for name, digest in files.items()
        if name not in unasked and (with_models or not name.startswith(f"{MODELS}/"))
    )


def kept(step: str, size: Size) -> Document | None:
    """A finished result that fits this code, with this size or a larger size. Never returns a
    failed result."""
    for each in sorted(Size, reverse=True):
        document = read(step, each) if each >= size else None
        if document and document["status"] != "failed" and is_current(document):
            return document
    return None


def latest(step: str, size: Size) -> Document | None:
    """The result to report for a step: the kept result, or the last result with this size or a
    larger size."""
    found = [document for each in Size if each >= size and (document := read(step, each))]
    return kept(step, size) or max(found, key=lambda one: str(one["date"]), default=None)
