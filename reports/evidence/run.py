#!/usr/bin/env python3
"""Runs the evidence: `make evidence [ONLY="NAME ..."] [QUICK=1]`.

Finished parts are kept in build/evidence and left alone until the files that they depend on change.
Exit code 0: all that ran is met or missed (a missed target is recorded); 1: a law does not hold, or
a script broke down; 2: wrong usage; 130: ended by a signal, and what it started too.
"""

from __future__ import annotations

import argparse
import os
import re
import signal
import sys
import threading
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

if sys.path and Path(sys.path[0]) == Path(__file__).resolve().parent:
    del sys.path[0]  # the scripts here are named by their subjects, not to be imported by name

from minkref.reports.evidence.framework import child, store, table
from minkref.reports.evidence.framework.part import Part, load, names
from rich.console import Console
from rich.status import Status as Spinner

EARLIER = ", of an earlier run"
interrupted = threading.Event()


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="make evidence", description=__doc__)
    parser.add_argument("only", nargs="*", metavar="NAME", help="parts to run (default: all)")
    parser.add_argument("--quick", action="store_true", help="smaller counts, marked as such")
    parser.add_argument("--again", action="store_true", help="run also what is kept")
    parser.add_argument(
        "--jobs",
        type=int,
        metavar="N",
        help="parts at a time (default: as many as there are cores if quick, else 1, since most "
        "full parts use all cores); those that measure time run alone",
    )
    parser.add_argument("--list", action="store_true", help="name the parts and stop")
    parser.add_argument("--child", metavar="NAME", help=argparse.SUPPRESS)
    options = parser.parse_args()
    options.quick = options.quick or os.environ.get("QUICK", "") not in ("", "0")
    options.jobs = options.jobs or (os.cpu_count() or 1 if options.quick else 1)
    return options


def minutes_of(part: Part, quick: bool) -> float:
    return part.quick_minutes if quick and part.quick_minutes is not None else part.minutes


def run_part(console: Console, part: Part, quick: bool, jobs: int) -> table.Document:
    line = f"{part.name}, some {minutes_of(part, quick):g} minutes"
    began = time.monotonic()
    if jobs > 1 or not console.is_terminal:
        console.print(line)
        return child.run_in_child(part, quick, end_if_interrupted)
    with Spinner(line, console=console) as spinner:
        return child.run_in_child(
            part, quick, lambda: spinner.update(f"{line}: {(time.monotonic() - began) / 60:.1f}")
        )


def at_once(
    parts: list[Part], document_of: Callable[[Part], table.Document], jobs: int
) -> dict[str, table.Document]:
    """Documents by name, of `jobs` parts at a time."""
    if jobs == 1:
        return {part.name: document_of(part) for part in parts}
    with ThreadPoolExecutor(jobs) as pool:
        try:
            found = pool.map(document_of, parts)
            return {part.name: document for part, document in zip(parts, found, strict=True)}
        except KeyboardInterrupt:
            interrupted.set()
            pool.shutdown(cancel_futures=True)
            raise


def end_if_interrupted() -> None:
    """In the thread of a part: its child is ended too."""
    if interrupted.is_set():
        raise KeyboardInterrupt


def write_summary(parts: list[Part], quick: bool) -> None:
    """Of all parts: results, those of older code marked as such, and why others have none."""
    documents, absent = [], {}
    for part in parts:
        document = store.kept(part, quick) or store.read(part.name, quick)
        if document is None:
            full_only = quick and part.quick_minutes is None
            absent[part.name] = "full run only" if full_only else "not run"
        elif document["dependencies"] != store.dependency_hash(part):
            documents.append(document | {"status": f"{document['status']}, of older code"})
        else:
            documents.append(document)
    text = table.markdown(documents, absent, quick)
    if quick:
        (store.FOLDER / "summary-quick.md").write_text(text, encoding="utf-8")
        return
    path = store.SCRIPTS_FOLDER / "SUMMARY.md"
    before = path.read_text(encoding="utf-8") if path.exists() else ""
    path.write_text(with_earlier(text, before, list(absent)), encoding="utf-8")


def with_earlier(text: str, before: str, absent: list[str]) -> str:
    """The summary with rows and sections of parts that have no result here, as in a fresh clone,
    from the summary that is there: they are marked, for nobody knows whether the code changed."""
    for name in absent:
        row = re.search(rf"^\| \[{name}\]\(#{name}\) \| ([^|]*) (\|.*)$", before, re.M)
        section = re.search(rf"^## {name}\n.*?(?=^## |\Z)", before, re.M | re.S)
        if row is None or section is None:
            continue
        status = row[1] if ", of " in row[1] else f"{row[1]}{EARLIER}"
        line = f"| [{name}](#{name}) | {status} {row[2]}"
        text = text.replace(f"| {name} | not run | | | |", line)
        text += f"\n{section[0].rstrip()}\n"
    return text


def main() -> int:
    options = arguments()
    if os.environ.get("MINKREF_MODELS"):  # parts run commands in other folders
        os.environ["MINKREF_MODELS"] = os.path.abspath(os.environ["MINKREF_MODELS"])
    if options.child:
        return child.run_here(options.child, options.quick)
    console = Console(stderr=False)
    unknown = [name for name in options.only if name not in names()]
    if unknown:
        console.print(f"no such part: {', '.join(unknown)}; there are: {', '.join(names())}")
        return 2
    every = [load(name) for name in names()]
    if options.list:
        for part in every:
            console.print(f"{part.name}: {part.subject}", highlight=False)
        return 0
    chosen = [part for part in every if not options.only or part.name in options.only]
    absent = [part.name for part in chosen if options.quick and part.quick_minutes is None]
    chosen = [part for part in chosen if part.name not in absent]

    for ends in (signal.SIGINT, signal.SIGTERM):  # in the background too, where a shell ignores it
        signal.signal(ends, signal.default_int_handler)

    def document_of(part: Part) -> table.Document:
        document = None if options.again else store.kept(part, options.quick)
        if document is not None:
            console.print(f"{part.name}: kept, {document['status']}, {document['date']}")
            return document
        document = run_part(console, part, options.quick, options.jobs)
        console.print(f"{part.name}: {document['status']}, {document['seconds']:.1f} s")
        return document

    beside = [part for part in chosen if not part.alone]
    if options.jobs > 1:  # the longest first, so that no core waits for another at the end
        beside.sort(key=lambda part: minutes_of(part, options.quick), reverse=True)
    of_part = at_once(beside, document_of, options.jobs)
    of_part |= at_once([part for part in chosen if part.alone], document_of, 1)
    documents = [of_part[part.name] for part in chosen]
    table.show(console, documents, absent)
    write_summary(every, options.quick)
    failed = [document for document in documents if document["status"] == "failed"]
    for document in failed:  # last, and a line each, for those who see the end only
        line = f"failed: {document['name']}: {table.short(document)}"
        console.print(line, markup=False, highlight=False, soft_wrap=True)
    return 1 if failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)  # what is finished is kept
