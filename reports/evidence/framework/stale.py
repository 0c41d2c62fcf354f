"""Which rows of the summary are stale: rests_on.json says of each file what parts rest on it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path

from minkref.reports.evidence.framework import places, store, table
from minkref.reports.evidence.framework.part import Size

NAME = "rests_on.json"


def read(path: Path) -> dict[str, set[str]]:
    """Files by part; a folder ends with a slash."""
    if not path.is_file():
        return {}
    value = json.loads(path.read_text(encoding="utf-8"))
    found: dict[str, set[str]] = {part: set() for part in value["parts"]}
    for file, numbers in value["files"].items():
        for number in numbers:
            found[value["parts"][number]].add(file)
    return found


def write(path: Path, rests_on: Mapping[str, Iterable[str]]) -> None:
    """A line for each file, with the numbers of the parts that rest on it."""
    parts = sorted(rests_on)
    of_file: dict[str, list[int]] = {}
    for number, part in enumerate(parts):
        for file in rests_on[part]:
            of_file.setdefault(file, []).append(number)
    rows = ",\n".join(f"{json.dumps(file)}: {of_file[file]}" for file in sorted(of_file))
    path.write_text(f'{{"parts": {json.dumps(parts)},\n"files": {{\n{rows}\n}}}}\n', "utf-8")


def resting_on(files: Iterable[str], rests_on: Mapping[str, Iterable[str]]) -> list[str]:
    """Parts whose rows a change of one of the files makes stale."""
    return [part for part, own in sorted(rests_on.items()) if store.touched(own, files)]


def stale(summary: str, rests_on: Mapping[str, Iterable[str]]) -> dict[str, str]:
    """Parts of the summary that are stale for the work tree, and why. By hashes where the result is
    here, else by what git says has changed since the commit of the row."""
    found: dict[str, str] = {}
    changed_since = cache(store.changed_since)
    for step, entry in table.entries_of(summary).items():
        part = step.partition("/")[0]
        document = store.latest(step, Size.WHOLE)
        if document is not None and is_of(document, entry):
            if not store.is_current(document):
                found[part] = f"{step} rests on what has changed"
            continue
        changed = changed_since(entry.commit.rstrip("+"))
        if changed is None or part not in rests_on:
            found.setdefault(part, f"nobody knows what {step} of {entry.commit} rests on")
        elif store.touched(rests_on[part], changed):
            found[part] = f"something has changed since {entry.commit}"
    return found


def is_of(document: store.Document, entry: table.Entry) -> bool:
    """Whether the row tells this result. Its commit may be a later one, with the same files."""
    return replace(table.entry_of(document), commit=entry.commit) == entry


def path() -> Path:
    return places.ROOM / NAME
