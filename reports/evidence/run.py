#!/usr/bin/env python3
"""Runs the evidence: `make evidence [ONLY="PART PART/STEP ..."] [QUICK=1 | FULL=1] [CHANGED=1]`.

Finished steps are kept in build/evidence and left alone until a file changes that they rest on, so
a run that was ended goes on with its next step. Exit code 0: all that ran is met or missed (a
missed target is recorded); 1: a law does not hold, or a step broke down; 2: wrong usage; 130: ended
by a signal, and what it started too.
"""

from __future__ import annotations

import argparse
import os
import signal
import sys
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

if sys.path and Path(sys.path[0]) == Path(__file__).resolve().parent:
    del sys.path[0]  # these folders are named by subject, not for imports

from minkref.reports.evidence.framework import child, places, recorded, stale, store, table
from minkref.reports.evidence.framework.part import Size
from minkref.reports.evidence.framework.steps import Step, claim, steps
from rich.console import Console

interrupted = threading.Event()


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="make evidence", description=__doc__)
    parser.add_argument("only", nargs="*", metavar="NAME", help="parts or steps (default: all)")
    parser.add_argument("--quick", action="store_true", help="the smallest counts")
    parser.add_argument("--full", action="store_true", help="the counts of the claims")
    parser.add_argument(
        "--changed", action="store_true",
        help="leave out what did not fail and rests on nothing that has changed since SUMMARY.md",
    )  # fmt: skip
    parser.add_argument("--again", action="store_true", help="run also what is kept")
    parser.add_argument(
        "--jobs",
        type=int,
        metavar="N",
        help="steps at a time (default: as many as there are cores if quick, else 1, since most "
        "larger steps use all cores); those that measure time run alone",
    )
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS|local:N",
        help="run steps as tasks of a Dask scheduler, or of N workers here; those that measure "
        "time run here, alone, afterwards",
    )
    parser.add_argument("--list", action="store_true", help="name parts and steps, and stop")
    parser.add_argument(
        "--stale", action="store_true",
        help="name the rows of SUMMARY.md that are stale, or would be if these files changed, "
        "and stop",
    )  # fmt: skip
    options = parser.parse_args()
    for name in ("quick", "full"):
        if os.environ.get(name.upper(), "") not in ("", "0"):
            setattr(options, name, True)
    if options.quick and options.full:
        parser.error("--quick and --full are two sizes")
    options.size = Size.QUICK if options.quick else Size.FULL if options.full else Size.WHOLE
    options.jobs = options.jobs or (os.cpu_count() or 1 if options.quick else 1)
    return options


def minutes(chosen: list[Step], size: Size, jobs: int) -> float:
    """Declared."""
    of = {step: step.minutes[size] or 0 for step in chosen}
    return sum(of[step] / (1 if step.alone else jobs) for step in chosen)


def at_once(
    chosen: list[Step], document_of: Callable[[Step], store.Document], jobs: int
) -> dict[str, store.Document]:
    """Documents by name, running `jobs` steps at a time."""
    with ThreadPoolExecutor(jobs) as pool:
        try:
            found = pool.map(document_of, chosen)
            return {step.name: document for step, document in zip(chosen, found, strict=True)}
        except KeyboardInterrupt:
            interrupted.set()
            pool.shutdown(cancel_futures=True)
            raise


def on_scheduler(
    place: str, chosen: list[Step], size: Size, console: Console
) -> dict[str, store.Document]:
    from minkref.reports.evidence.framework.on_workers import on_workers

    def tell(document: store.Document) -> None:
        console.print(f"{document['step']}: {document['status']}, {document['seconds']:.1f} s")

    chosen = sorted(chosen, key=lambda step: step.minutes[size] or 0, reverse=True)
    return on_workers(place, chosen, size, tell)


def end_if_interrupted() -> None:
    """Raises KeyboardInterrupt in a step's thread, so that the step's child ends too."""
    if interrupted.is_set():
        raise KeyboardInterrupt


def write_summary(every: list[Step], size: Size) -> None:
    """Writes the summary of all steps. A step without a result here, as after a fresh clone, keeps
    its present entry, and the files that the entry rests on."""
    quick = size is Size.QUICK
    path = places.FOLDER / "summary-quick.md" if quick else places.ROOM / store.SUMMARY
    before = path.read_text(encoding="utf-8") if path.exists() and not quick else ""
    documents = [
        document for step in every if (document := store.latest(step.name, min(size, Size.WHOLE)))
    ]
    entries = table.entries_of(before) | {
        d["step"]: table.entry_of(standing_now(d)) for d in documents
    }
    wanted = [step for step in every if not quick or step.minutes.quick is not None]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(table.markdown(wanted, entries, claim, quick), encoding="utf-8")
    if not quick:
        stale.write(stale.path(), resting(every, documents))


def standing_now(document: store.Document) -> store.Document:
    """The document, marked with this commit if the files that it rests on have not changed since
    the run."""
    commit = store.commit_of(document["files"]) if store.is_current(document) else ""
    return document | {"commit": commit or document["commit"]}


def resting(every: list[Step], documents: list[store.Document]) -> dict[str, set[str]]:
    """Files by row: from present results, and for other steps the files known before."""
    here = {document["step"]: document for document in documents}
    known, found = stale.read(stale.path()), dict[str, set[str]]()
    for name in {step.row for step in every}:
        own = [step.name for step in every if step.row == name]
        if known.get(name) and not set(own) <= here.keys():
            found[name] = known[name]
        for document in (here[step] for step in own if step in here):
            files = {file for file in document["files"] if not file.startswith(recorded.MODELS)}
            found.setdefault(name, set()).update(files)
    return found


def tell_stale(files: list[str]) -> int:
    if files:
        rests_on = stale.read(stale.path())
        found = dict.fromkeys(stale.resting_on(map(in_repository, files), rests_on), "")
    else:
        found = stale_rows(steps())
    for row, why in sorted(found.items()):
        print(f"{row}: {why}" if why else row)
    if not files and not os.environ.get(recorded.MODELS):
        print(f"{recorded.MODELS} is not set: whether the paper's models changed was not asked.")
    return 0


def summary_here() -> str:
    return (places.ROOM / store.SUMMARY).read_text(encoding="utf-8")


def changed_since_told(chosen: list[Step], every: list[Step]) -> list[Step]:
    """Steps that the summary omits or calls failed, and steps with a stale row."""
    told, rows = table.entries_of(summary_here()), stale_rows(every)
    well = {name for name, entry in told.items() if entry.status != "failed"}
    return [step for step in chosen if step.row in rows or step.name not in well]


def stale_rows(every: list[Step]) -> dict[str, str]:
    """The stale rows of the current SUMMARY.md, each with the reason."""
    summary = summary_here()
    rests_on = stale.read(stale.path())
    return stale.stale(summary, rests_on, {step.name: step.row for step in every})


def in_repository(file: str) -> str:
    path = Path(os.path.abspath(file))
    return str(path.relative_to(places.ROOT)) if path.is_relative_to(places.ROOT) else file


def main() -> int:
    options = arguments()
    if options.stale:
        return tell_stale(options.only)
    if os.environ.get("MINKREF_MODELS"):  # steps run commands from other folders
        os.environ["MINKREF_MODELS"] = os.path.abspath(os.environ["MINKREF_MODELS"])
    console = Console(stderr=False)
    every = steps()
    known = {name for step in every for name in (step.name, step.part)}
    unknown = [name for name in options.only if name not in known]
    if unknown:
        parts = ", ".join(dict.fromkeys(step.part for step in every))
        console.print(f"no such part or step: {', '.join(unknown)}; there are the parts {parts}")
        return 2
    if options.list:
        for part in dict.fromkeys(step.part for step in every):
            console.print(f"{part}: {claim(part)}", highlight=False)
            for step in (step for step in every if step.part == part):
                told = ", ".join("-" if m is None else f"{m:g}" for m in step.minutes)
                console.print(f"  {step.name}: {told} minutes", highlight=False)
        return 0
    size: Size = options.size
    chosen = [s for s in every if not options.only or {s.name, s.part} & set(options.only)]
    if options.changed:
        chosen = changed_since_told(chosen, every)
    absent = [step.name for step in chosen if step.minutes[size] is None]
    chosen = [step for step in chosen if step.name not in absent]
    kept = {
        step.name: document
        for step in chosen
        if not options.again and (document := store.kept(step.name, size))
    }
    to_run = [step for step in chosen if step.name not in kept]
    console.print(
        f"{len(to_run)} steps of {size} size, some {minutes(to_run, size, options.jobs):.0f} "
        f"minutes; {len(kept)} are kept",
        highlight=False,
    )

    for ends in (signal.SIGINT, signal.SIGTERM):  # in the background too, where a shell ignores it
        signal.signal(ends, signal.default_int_handler)

    def document_of(step: Step) -> store.Document:
        console.print(f"{step.name}, some {step.minutes[size]:g} minutes", highlight=False)
        document = child.run_in_child(step, size, end_if_interrupted)
        console.print(f"{step.name}: {document['status']}, {document['seconds']:.1f} s")
        return document

    beside = [step for step in to_run if not step.alone]
    if options.jobs > 1:  # the longest first, so that no core waits for another at the end
        beside.sort(key=lambda step: step.minutes[size] or 0, reverse=True)
    of_step = kept | (
        on_scheduler(options.scheduler, beside, size, console)
        if options.scheduler and beside
        else at_once(beside, document_of, options.jobs)
    )
    of_step |= at_once([step for step in to_run if step.alone], document_of, 1)
    documents = [of_step[step.name] for step in chosen]
    table.show(console, documents, absent)
    write_summary(every, size)
    failed = [document for document in documents if document["status"] == "failed"]
    for document in failed:  # last, and a line each, for those who see the end only
        line = f"failed: {document['step']}: {table.short(document)}"
        console.print(line, markup=False, highlight=False, soft_wrap=True)
    return 1 if failed else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)  # what is finished is kept
