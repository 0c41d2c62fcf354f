"""Finds stale rows of the summary: rests_on.json maps each file to the rows that rest on it."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path

from minkref.reports.evidence.framework import places, store, table
from minkref.reports.evidence.framework.part import Size
from minkref.reports.evidence.framework.recorded import MODELS


def read(path: Path) -> dict[str, set[str]]:
    """Files by row; a folder ends with a slash."""
    if not path.is_file():
        return {}
    value = json.loads(path.read_text(encoding="utf-8"))
    found: dict[str, set[str]] = {row: set() for row in value["rows"]}
    for file, numbers in value["files"].items():
        for number in numbers:
            found[value["rows"][number]].add(file)
    return found


def write(path: Path, rests_on: Mapping[str, Iterable[str]]) -> None:
    """Writes a line for each file, with the numbers of the rows that rest on the file."""
    rows = sorted(rests_on)
    of_file: dict[str, list[int]] = {}
    for number, row in enumerate(rows):
        for file in rests_on[row]:
            of_file.setdefault(file, []).append(number)
    lines = ",\n".join(f"{json.dumps(file)}: {of_file[file]}" for file in sorted(of_file))
    path.write_text(f'{{"rows": {json.dumps(rows)},\n"files": {{\n{lines}\n}}}}\n', "utf-8")


def resting_on(files: Iterable[str], rests_on: Mapping[str, Iterable[str]]) -> list[str]:
    """Rows that a change to one of the files makes stale."""
    return [row for row, own in sorted(rests_on.items()) if store.touched(own, files)]


def stale(
    summary: str, rests_on: Mapping[str, Iterable[str]], row_of: Mapping[str, str]
) -> dict[str, str]:
    """Stale rows of the summary for the work tree, with reasons. Compares hashes if the result
    exists here, else asks git for changes since the row's commit."""
    found: dict[str, str] = {}
    changed_since = cache(store.changed_since)
    for step, entry in table.entries_of(summary).items():
        row = row_of.get(step, step)
        document = store.latest(step, Size.WHOLE)
        if document is not None and is_of(document, entry):
            if not store.is_current(document, bool(os.environ.get(MODELS))):
                found[row] = f"{step} rests on what has changed"
            continue
        changed = changed_since(entry.commit.rstrip("+"))
        if changed is None or row not in rests_on:
            found.setdefault(row, f"nobody knows what {step} of {entry.commit} rests on")
        elif store.touched(rests_on[row], changed):
            found[row] = f"something has changed since {entry.commit}"
    return found


def is_of(document: store.Document, entry: table.Entry) -> bool:
    """Whether the row describes this result. The row's commit may be later, with the same files."""
    return replace(table.entry_of(document), commit=entry.commit) == entry


def path() -> Path:
    return places.ROOM / store.RESTS_ON
