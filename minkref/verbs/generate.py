"""`minkref generate FAMILY...|all`: degenerate cases, each with its certificate."""

from __future__ import annotations

import os
import shlex
import signal
import sys
import time
from collections import deque
from collections.abc import Generator, Iterable
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import closing
from dataclasses import dataclass, field
from multiprocessing import active_children, get_context
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Annotated

import typer
from minkref import _core
from minkref.cli.options import Json
from minkref.cli.output import plain_table
from minkref.cli.progress import progress
from minkref.cli.verb import Verb, command_anywhere
from minkref.degeneracies.catalogue import GROUP_OF, GROUPS
from minkref.degeneracies.files import FileRow, Made
from minkref.errors import Refusal, nearest, refusal_of
from minkref.fuzz.run import child
from minkref.output.documents import Stopwatch, document, listing
from minkref.output.output_folder import folder_to_write
from minkref.output.signals import ending_in_order
from minkref.output.terminal import console, counted, escaped
from minkref.verbs.verify_limits import MOST_JOBS

EXAMPLES = """Examples:

minkref generate hole-to-segment --count 100 -o cases

minkref generate fits-hole --seed 7 --index 42

minkref generate rings-touching --size 200 --count 5 -o large

minkref generate all --seed 7 -o cases && minkref check cases

minkref generate space --count 3 -o bodies && minkref check bodies

minkref generate solids --count 2 -o solids

minkref generate disc --count 2 -o discs && minkref check discs

minkref generate paths --count 2 -o paths && minkref check paths

minkref generate unions --count 2 -o unions && minkref check unions

minkref generate invalid --count 3 -o bad

minkref verify cgal-reduced --suite corpus --corpus cases"""

WORDS = [group.word for group in GROUPS]
DEFAULT_FOLDER = "degenerate-cases"
DEFAULT_COUNT = 10
MOST_CASES = 10_000_000  # of a family
LEAST_SIZE, MOST_SIZE = 8, 2000
AHEAD = 4  # members for each process that are being made, or wait for one before them
Task = tuple[str, int, int, int | None]  # family, seed, index, size


TOLD = """\
Make hundreds of degenerate cases (docs/degeneracies.md): files with operands, scales, the
expected result at each, and why good code gets it wrong, each with a certificate, but those of
polyhedra of any shape. The same family, seed, number and size give the same bytes on every
machine."""

Families = Annotated[
    list[str],
    typer.Argument(
        help="Families (`minkref families`). all: the families in the plane with "
        "certificates; space: those of convex bodies in space; solids: of polyhedra of any "
        "shape, without certificates; disc: of a polygon set and a disc; paths: of parts "
        "on paths, and traps; unions: of sets to unite; invalid, invalid-mesh: input that must be "
        "refused.",
        metavar="|".join(["FAMILY", *WORDS]),
    ),
]
Count = Annotated[
    int | None,
    typer.Option(
        "--count",
        help="Cases of each family.",
        min=1,
        max=MOST_CASES,
        show_default=str(DEFAULT_COUNT),
    ),
]
Index = Annotated[
    int | None,
    typer.Option(
        "--index", help="Make only the case with this number, from 0, instead of --count.", min=0
    ),
]
Seed = Annotated[int, typer.Option("--seed", help="Another seed gives other cases.")]
SizeOfCases = Annotated[
    int | None,
    typer.Option(
        "--size",
        help="About how many vertices both operands have together, for families that can be "
        "large (combs and spirals up to 96: their sums grow with the fourth power).",
        min=LEAST_SIZE,
        max=MOST_SIZE,
        show_default="drawn for each case, 8 to 24",
    ),
]
Output = Annotated[
    str,
    typer.Option(
        "-o",
        help="Folder for FAMILY/ID.json and its certificate, FAMILY/ID.cert.json.",
        metavar="DIR",
    ),
]
Jobs = Annotated[
    int, typer.Option("--jobs", help="Processes; 0: one per core.", min=0, max=MOST_JOBS)
]


@dataclass(frozen=True)
class Generate:
    families: Families
    count: Count = None
    index: Index = None
    seed: Seed = 1
    size: SizeOfCases = None
    output: Output = DEFAULT_FOLDER
    jobs: Jobs = 0
    json: Json = False


command = command_anywhere(TOLD, Verb(Generate, "minkref.verbs.generate:run"))


def run(request: Generate) -> None:
    watch = Stopwatch()
    names = _chosen(request.families)
    numbers = _numbers(request.count, request.index)
    _check_size(request.size, names)
    folder = folder_to_write(request.output, names)
    total = len(names) * len(numbers)
    tasks = ((name, request.seed, number, request.size) for name in names for number in numbers)
    tallies = {name: _Tally() for name in names}
    rows: list[FileRow] = []
    began = time.perf_counter()
    with (
        ending_in_order(),
        progress(total) as line,
        closing(_made(tasks, min(request.jobs or os.cpu_count() or 1, total))) as members,
    ):
        line.now(names[0])
        for made in members:
            line.now(made.family)
            row = tallies[made.family].add(made, folder)
            if request.json:
                rows.append(row)
            line.done()
    value = document(
        "generate",
        watch,
        output=request.output,
        seed=request.seed,
        cases_per_second=round(total / (time.perf_counter() - began), 3),
        different=sum(tally.different for tally in tallies.values()),
        bytes=sum(tally.bytes for tally in tallies.values()),
    )
    if request.json:
        sys.stdout.writelines(listing(value, "cases", rows))
        return
    _print_table(tallies)
    sys.stdout.write(
        f"{counted(total, 'case')}, {value['different']:,} different, {value['bytes']:,} bytes, "
        f"{value['cases_per_second']:.1f} a second\n"
    )
    if any(GROUP_OF[name].certified for name in names):
        sys.stdout.write(f"check them: minkref check {_quoted(request.output)}\n")


@dataclass
class _Tally:
    """The tally of a family."""

    cases: int = 0
    _bytes: dict[str, int] = field(default_factory=dict)  # by id

    @property
    def different(self) -> int:
        return len(self._bytes)

    @property
    def bytes(self) -> int:
        return sum(self._bytes.values())

    def add(self, made: Made, folder: Path) -> FileRow:
        """Writes the files, unless an earlier member was the same case."""
        self.cases += 1
        row = made.row(folder) if made.id in self._bytes else made.write(folder)
        row["bytes"] = self._bytes.setdefault(made.id, row["bytes"])
        return row


def _chosen(families: list[str]) -> list[str]:
    known = {group.word: list(group.families) for group in GROUPS}
    known |= {name: [name] for name in GROUP_OF}
    unknown = [name for name in families if name not in known]
    if unknown:
        mend = (
            f"{nearest(unknown[0], known)}`minkref families` lists all families: name some that it "
            f"says `generate` makes, {', '.join(WORDS[:-1])} or {WORDS[-1]}"
        )
        raise Refusal("there is no such family", escaped(unknown[0]), mend, "unknown-family")
    return list(dict.fromkeys(name for word in families for name in known[word]))


def _numbers(count: int | None, index: int | None) -> range:
    if index is None:
        return range(DEFAULT_COUNT if count is None else count)
    if count is not None:
        raise Refusal(
            "the cases are chosen twice",
            f"--count {count} and --index {index}",
            "leave out --index to make the first cases, or --count to make one",
        )
    return range(index, index + 1)


def _check_size(size: int | None, names: list[str]) -> None:
    sizeless = next((name for name in names if GROUP_OF[name].sizeless), None)
    if size is not None and sizeless is not None:
        what = f"{sizeless} is a family of {GROUP_OF[sizeless].sizeless}, which has no size"
        raise Refusal(what, f"--size {size}", "leave out --size, or this family")


def _made(tasks: Iterable[Task], jobs: int) -> Generator[Made, None, None]:
    """In the order of the tasks. Processes make members and write nothing, so that they can be
    killed, and files do not depend on which is faster."""
    if jobs == 1:
        yield from map(_make, tasks)
        return
    before = set(active_children())
    pool = ProcessPoolExecutor(jobs, get_context("spawn"), initializer=child.begin)
    waiting: deque[Future[Made]] = deque()
    try:
        for task in tasks:
            waiting.append(_submitted(pool, task))
            if len(waiting) >= AHEAD * jobs:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()
    except BaseException:
        _kill(pool, set(active_children()) - before)
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _kill(pool: ProcessPoolExecutor, processes: Iterable[BaseProcess]) -> None:
    """Kills the pool's processes. The pool would wait for the rest of a half-written result: with
    its own end of the pipe closed the pool reads the end instead (CPython has no public way)."""
    for process in processes:
        process.kill()
    pool._result_queue._writer.close()  # type: ignore[attr-defined]


def _submitted(pool: ProcessPoolExecutor, task: Task) -> Future[Made]:
    """Submits the task; a process that starts is deaf to Ctrl-C from its first instruction on."""
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, (signal.SIGINT,))
    try:
        return pool.submit(_make, task)
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)


def _make(task: Task) -> Made:
    name, seed, index, size = task
    member = f"{name} --seed {seed} --index {index}"
    try:
        group = GROUP_OF[name]
        return group.made(group.families[name], seed, index, size)
    except Refusal:
        raise
    except Exception as error:
        if size is not None and isinstance(error, _core.BadInput):  # a limit of the readers
            raise refusal_of(error, f"{member} --size {size}") from error
        raise RuntimeError(f"member {member}: {error}") from error


def _print_table(tallies: dict[str, _Tally]) -> None:
    counts = ("cases", "different", "bytes")
    table = plain_table("family", *counts, right=counts)
    for name, tally in tallies.items():
        table.add_row(name, f"{tally.cases:,}", f"{tally.different:,}", f"{tally.bytes:,}")
    console().print(table)


def _quoted(folder: str) -> str:
    """As a word of a shell that is no option."""
    return escaped(shlex.quote(f"./{folder}" if folder.startswith("-") else folder))
