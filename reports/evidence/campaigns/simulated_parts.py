"""Parts as 1,000 workers would send them, of results that follow a formula: four versions of five
targets on the same cases, so that each question has an answer that is known without a ledger."""

from __future__ import annotations

import random
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache
from multiprocessing import get_context
from typing import Any

import duckdb
from minkref.fuzz.ledgers.file import Chunk, columns, file_of

VERSIONS = ("1.2.0", "1.9.1", "1.10.0", "2.0.0")
TARGETS = ("alpha", "beta", "gamma", "delta", "epsilon")
FAMILIES = 40
WORKERS = 1000
AT_ONCE = 100  # parts in memory
FINDING = (
    '{"number":1,"name":{"text":"x","group":"x"},"outcomes":[{"target":"x","verdict":"wrong",'
    '"reasons":["missing"],"witness":{"point":["1","2"],"in_truth":true}}],"P":"'
    + "POLYGON ((0 0, 1 0, 1 1, 0 0))" * 15
    + '","Q":"'
    + "POLYGON ((0 0, 1 0, 1 1, 0 0))" * 15
    + '"}'
)

# A case by number n, a target t, a version v, all from 0. One case in 1,000 is hard for a target:
# it was wrong in the first versions (mended in version n % 5), or is wrong since (n odd).
RESULTS = f"""
SELECT n, t, v, 'family' || lpad(((n // $size) % {FAMILIES})::VARCHAR, 2, '0') AS family,
    CASE WHEN (n * 7 + t * 13) % 10 = 0 THEN 'skipped'
         WHEN (n * 104729 + t * 1299709) % 1000 = 0
              AND ((n % 2 = 0 AND v < n % 5) OR (n % 2 = 1 AND v >= n % 5)) THEN 'wrong'
         WHEN n % 3 = 0 THEN 'pass-within'
         ELSE 'pass' END AS verdict,
    CASE n % 3 WHEN 0 THEN '' WHEN 1 THEN 'holes' ELSE 'holes non-convex' END AS flags
FROM (SELECT n, t, v FROM range($first, $last) AS cases(n), range({len(TARGETS)}) AS targets(t),
      range($low, $high) AS versions(v))
"""

ROWS = f"""
SELECT 'c' || v || '-' || family || '-' || lpad((n // ($size * {FAMILIES}))::VARCHAR, 6, '0')
    AS chunk, 'c' || v AS campaign, (n % $size)::UINTEGER AS number,
    epoch_ms(1700000000000 + v * 86400000 + n // 100) AS judged_at,
    family || ':7:' || (n // ($size * {FAMILIES}) * $size + n % $size) AS "case",
    'plane' AS setting, 'at' AS question, family, family AS class,
    CASE WHEN n % 4 = 0 THEN 'at' ELSE 'between' END AS position, flags, '3/2' AS scale,
    NULL AS coverage, 2::UTINYINT AS dimension, ({list(TARGETS)!r})[t + 1] AS target,
    ({list(VERSIONS)!r})[v + 1] AS version, verdict, NULL AS was,
    CASE WHEN verdict = 'wrong' THEN 'missing' ELSE verdict END AS kind,
    ((n * 31 + t) % 977 / 1000)::FLOAT AS seconds,
    CASE WHEN verdict = 'skipped' THEN 'does not declare holes' END AS message,
    CASE WHEN verdict = 'pass' THEN md5(n::VARCHAR) || md5((-n)::VARCHAR) END AS digest,
    CASE WHEN verdict = 'wrong' THEN $finding END AS finding
FROM ({RESULTS}) ORDER BY n, t
"""


@dataclass(frozen=True)
class Simulation:
    """`cases` in each of the four versions, `size` of them in a chunk."""

    cases: int
    size: int

    @property
    def rows(self) -> int:
        return self.cases * len(TARGETS) * len(VERSIONS)

    def parts(self, seed: int) -> Iterator[tuple[str, bytes]]:
        """Names and bytes of all parts, version by version, made by two processes. As they come
        from many workers, not in order: any of the next 1,000 may be the next one."""
        chunks = self.cases // self.size
        dice = random.Random(seed)
        with ProcessPoolExecutor(2, get_context("spawn")) as pool:
            for v in range(len(VERSIONS)):
                for begin in range(0, chunks, WORKERS):
                    waiting = list(range(begin, min(begin + WORKERS, chunks)))
                    dice.shuffle(waiting)
                    for first in range(0, len(waiting), AT_ONCE):
                        some = waiting[first : first + AT_ONCE]
                        yield from pool.map(_part, [self] * len(some), [v] * len(some), some)

    def part(self, con: Any, v: int, k: int) -> tuple[str, bytes]:
        """Name and bytes of a part: chunk k of version v."""
        first = k * self.size
        table = con.sql(ROWS, params=self._values(v, first, first + self.size)).to_arrow_table()
        table = table.select(columns().names).cast(columns())
        name = table["chunk"][0].as_py()
        return name, file_of(table, {name: Chunk(table.num_rows, self.size, 0, 0)})

    def _values(self, v: int, first: int, last: int) -> dict[str, Any]:
        bounds = {"first": first, "last": last, "low": v, "high": v + 1, "size": self.size}
        return {**bounds, "finding": FINDING}

    def known(self, con: Any, query: str) -> list[tuple[Any, ...]]:
        """An answer from the formula alone: `query` over the table `truth`."""
        values = {"first": 0, "last": self.cases, "low": 0, "high": len(VERSIONS)}
        values["size"] = self.size
        text = f"WITH truth AS ({RESULTS}) {query}"
        return con.sql(text, params=values).fetchall()  # type: ignore[no-any-return]


@cache
def _connection() -> Any:
    return duckdb.connect(":memory:", config={"threads": 1})


def _part(simulation: Simulation, v: int, k: int) -> tuple[str, bytes]:
    return simulation.part(_connection(), v, k)
