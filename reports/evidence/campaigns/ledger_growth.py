"""A ledger as 1,000 workers fill it: 10^8 rows in full. How fast parts go in, what the named
questions take, and whether their answers are those of the formula that made the rows."""

from __future__ import annotations

import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from minkref.fuzz.ledgers.compaction import DUE
from minkref.fuzz.ledgers.part import store_part
from minkref.fuzz.ledgers.place import look
from minkref.fuzz.ledgers.questions import QUESTIONS, named
from minkref.fuzz.ledgers.views import connection, opened
from minkref.reports.evidence.campaigns.simulated_parts import TARGETS, VERSIONS, Simulation
from minkref.reports.evidence.framework.command import COMMAND, cost
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import FOLDER

MINUTES = Minutes(None, 1.5, 20)
ALONE = True
SEED = 20261130
SIMULATIONS = Counts(
    Simulation(5_000, 500), Simulation(50_000, 1_000), Simulation(5_000_000, 5_000)
)
COMPACTIONS = Counts(2, 4, 25)  # while parts come in; the engine compacts when some hundred wait
KILLS = Counts(2, 6, 3)
MOST_SECONDS = 2.0  # of the processor for a named question, with the start of the command
MOST_MIB = 4096.0
MOST_BYTES = 20 << 30
COMPACT = (
    sys.executable, "-c",
    "import sys; from pathlib import Path; from minkref.fuzz.ledgers.compaction import compact; "
    "compact(Path(sys.argv[1]))",
)  # fmt: skip

TRUE_VERDICTS = """SELECT t, v, verdict, count(*) FROM truth GROUP BY ALL ORDER BY ALL"""
TRUE_FLAGS = """SELECT flag, count(*) FILTER (WHERE verdict = 'wrong')
    FROM (SELECT *, unnest(string_split(flags, ' ')) AS flag FROM truth WHERE flags != '')
    GROUP BY flag ORDER BY flag"""
TRUE_CHANGES = """SELECT t, v, verdict = 'wrong' AS broken, count(*) FROM (
    SELECT *, lag(verdict) OVER (PARTITION BY n, t ORDER BY v) AS earlier FROM truth
    WHERE (n * 104729 + t * 1299709) % 1000 = 0 AND verdict != 'skipped')
    WHERE earlier IS NOT NULL AND (earlier = 'wrong') != (verdict = 'wrong')
    GROUP BY ALL ORDER BY ALL"""


def run(findings: Findings, size: Size) -> None:
    simulation = size.of(SIMULATIONS)
    FOLDER.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=FOLDER) as folder, connection() as con:
        ledger = Path(folder) / "campaign"
        _fill(findings, ledger, simulation, size.of(COMPACTIONS))
        _kill(findings, Path(folder), size.of(KILLS))
        _finish(findings, ledger)
        _ask(findings, ledger)
        _hold(findings, ledger, con, simulation)


def _fill(findings: Findings, ledger: Path, simulation: Simulation, compactions: int) -> None:
    """Stores all parts, with a compaction now and then; figures of its rates."""
    storing = compacting = worked_storing = worked_compacting = mib = 0.0
    parts = waiting = 0
    most = simulation.cases // simulation.size * len(VERSIONS) // compactions
    for name, part in simulation.parts(SEED):
        began, worked = time.perf_counter(), time.process_time()
        store_part(ledger, name, part)
        storing += time.perf_counter() - began
        worked_storing += time.process_time() - worked
        parts, waiting = parts + 1, waiting + 1
        # The last ones wait for the compactions that are killed.
        if waiting == most and parts + most <= simulation.cases // simulation.size * len(VERSIONS):
            began = time.perf_counter()
            of = cost([*COMPACT, str(ledger)])
            mib, worked_compacting = max(mib, of.mib), worked_compacting + of.seconds
            compacting += time.perf_counter() - began
            print(f"{parts:,} parts, {mib:,.0f} MiB", flush=True)
            waiting = 0
    done = simulation.rows * (parts - waiting) / parts
    findings.figures |= {
        "rows": simulation.rows,
        "parts": parts,
        "rows_stored_per_second": round(simulation.rows / storing),
        "rows_compacted_per_second": round(done / compacting),
        "rows_in_per_second": round(1 / (storing / simulation.rows + compacting / done)),
        "rows_stored_per_processor_second": round(simulation.rows / worked_storing),
        "rows_compacted_per_processor_second": round(done / worked_compacting),
        "compaction_mib": round(mib),
    }
    findings.law("memory of a compaction, MiB", mib < MOST_MIB, f"< {MOST_MIB:,.0f}", f"{mib:,.0f}")


def _kill(findings: Findings, folder: Path, kills: int) -> None:
    """Compactions of a copy, ended by signal 9 at seeded moments: every question keeps its
    answer."""
    copy, ledger, dice = folder / "copy", folder / "campaign", random.Random(SEED)
    kept = look(ledger).loose[: 2 * DUE]
    _copy(kept, copy)
    before = _answer(copy, "verdicts")
    began = time.perf_counter()
    subprocess.run([*COMPACT, str(copy)], check=True)
    whole = time.perf_counter() - began
    other, ended = [], 0
    for _ in range(kills):
        if not look(copy).loose:
            _copy(kept, copy)
        with subprocess.Popen([*COMPACT, str(copy)]) as child:
            time.sleep(dice.uniform(0.4, 1.0) * whole)
            child.send_signal(signal.SIGKILL)
        ended += child.returncode == -signal.SIGKILL
        if _answer(copy, "verdicts") != before:
            other.append("another answer after a kill")
    subprocess.run([*COMPACT, str(copy)], check=True)
    if _answer(copy, "verdicts") != before or look(copy).loose:
        other.append("another answer at the end")
    findings.figures |= {"compactions_killed": ended, "compactions_to_kill": kills}
    findings.none("answers that a killed compaction changed", other)
    shutil.rmtree(copy)


def _copy(parts: Sequence[Path], copy: Path) -> None:
    """A ledger of these parts alone."""
    shutil.rmtree(copy, ignore_errors=True)
    (copy / "ledger" / "parts").mkdir(parents=True)
    for path in parts:
        (copy / "ledger" / "parts" / path.name).hardlink_to(path)


def _answer(ledger: Path, question: str) -> list[dict[str, Any]]:
    """Without sums of seconds, which are rounded."""
    with opened(ledger) as con:
        rows = con.sql(named(question).sql).to_arrow_table().to_pylist()
    return [{name: row[name] for name in row if name != "seconds"} for row in rows]


def _finish(findings: Findings, ledger: Path) -> None:
    began = time.perf_counter()
    subprocess.run([*COMPACT, str(ledger)], check=True)
    findings.figures["last_compaction_seconds"] = round(time.perf_counter() - began, 1)
    findings.equal("loose parts at the end", 0, len(look(ledger).loose))
    total = sum(path.stat().st_size for path in ledger.rglob("*") if path.is_file())
    rows = findings.figures["rows"]
    findings.figures |= {"bytes": total, "bytes_per_row": round(total / rows, 2)}
    limit = f"< {MOST_BYTES >> 30} GiB"
    findings.law("disc", total < MOST_BYTES, limit, f"{total / 2**20:,.0f} MiB")


def _ask(findings: Findings, ledger: Path) -> None:
    """Each named question, as a user asks it: seconds of the processor, at least those of the clock
    on an idle machine."""
    taken: dict[str, float] = {}
    mib = 0.0
    query = [*COMMAND, "campaign", "query", str(ledger)]
    for name in QUESTIONS:
        of = cost([*query, "--question", name, "--json"])
        taken[name], mib = round(of.seconds, 2), max(mib, of.mib)
    slowest = max(taken, key=lambda name: taken[name])
    findings.figures |= {"question_processor_seconds": taken, "question_mib": round(mib)}
    reached = f"{taken[slowest]} ({slowest})"
    findings.target(
        "seconds of the processor for the slowest named question, with the start of the command",
        taken[slowest] < MOST_SECONDS, f"< {MOST_SECONDS}", reached,
    )  # fmt: skip
    findings.law("memory of a question, MiB", mib < MOST_MIB, f"< {MOST_MIB:,.0f}", f"{mib:,.0f}")
    sql = "SELECT family, count(*) FROM results WHERE verdict = 'wrong' GROUP BY family"
    findings.figures["all_rows_processor_seconds"] = round(cost([*query, sql]).seconds, 2)
    with tempfile.TemporaryDirectory(dir=FOLDER) as site:
        of = cost([*COMMAND, "campaign", "site", str(ledger), "-o", site])
    findings.figures["site_processor_seconds"] = round(of.seconds, 2)


def _hold(findings: Findings, ledger: Path, con: Any, simulation: Simulation) -> None:
    """The answers against the formula."""
    counts = {(TARGETS[t], VERSIONS[v], verdict): n for t, v, verdict, n in
              simulation.known(con, TRUE_VERDICTS)}  # fmt: skip
    asked = {
        (row["subject"], row["version"], row["verdict"]): row["cases"]
        for row in _answer(ledger, "verdicts")
    }
    findings.law("verdicts by target and version", asked == counts, "the formula's", _told(asked))
    flags = dict(simulation.known(con, TRUE_FLAGS))
    of_flags: dict[str, int] = {}
    for row in _answer(ledger, "flags"):
        of_flags[row["flag"]] = of_flags.get(row["flag"], 0) + row["amiss"]
    findings.equal("wrong answers by flag", flags, of_flags)
    changes = {(TARGETS[t], VERSIONS[v], "broken" if broken else "mended"): n for t, v, broken, n in
               simulation.known(con, TRUE_CHANGES)}  # fmt: skip
    found = {
        (row["subject"], row["version"], row["change"]): row["cases"]
        for row in _answer(ledger, "regressions")
    }
    findings.law("cases mended and broken", found == changes, "the formula's", _told(found))
    findings.figures["changed_cases"] = sum(changes.values())


def _told(counts: dict[Any, int]) -> str:
    return f"{len(counts)} numbers, {sum(counts.values()):,} in all"
