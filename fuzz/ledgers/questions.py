"""Questions to a ledger: SQL of a reader, and questions that have a name."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from minkref.errors import Refusal, choice, cut
from minkref.fuzz.ledgers.heard import heard, heard_batches
from minkref.fuzz.ledgers.views import AMISS, GOOD

LONGEST_LIST = 50  # rows of `slowest`


@dataclass(frozen=True)
class Question:
    """`title`: what its answer shows, for people; `sql`: over the views of views.py."""

    title: str
    sql: str


def _where(condition: str) -> str:
    return f"coalesce(sum(cases) FILTER (WHERE {condition}), 0)::BIGINT"


def _by(column: str) -> str:
    """Counts by subject, version and one column."""
    return f"""SELECT subject, version, {column}, sum(cases)::BIGINT AS asked,
    {_where(f"verdict IN {GOOD}")} AS "right",
    {_where(AMISS)} AS amiss,
    {_where("verdict = 'skipped'")} AS skipped,
    sum(seconds) AS seconds
    FROM counts JOIN versions USING (subject, version)
    GROUP BY subject, version, place, {column} ORDER BY subject, place, {column}"""


# Cases that a version got right or wrong, each once: wrong if it ever was. `rank`: counts versions
# that were asked about the case.
JUDGED = f"""SELECT subject, version, place, "case", any_value(family) AS family,
    bool_or({AMISS}) AS amiss, arg_max(kind, {AMISS}) AS kind
    FROM disputed JOIN versions USING (subject, version)
    WHERE verdict NOT IN ('skipped', 'undecided', 'gave-up')
    GROUP BY subject, version, place, "case\""""
STEPS = f"""SELECT *, lag(version) OVER w AS earlier, lag(amiss) OVER w AS was_amiss,
    lag(kind) OVER w AS earlier_kind
    FROM ({JUDGED}) WINDOW w AS (PARTITION BY subject, "case" ORDER BY place)"""
CHANGES = f"""SELECT subject, earlier, version, family,
    CASE WHEN amiss THEN 'broken' ELSE 'mended' END AS change,
    CASE WHEN amiss THEN kind ELSE earlier_kind END AS kind, place, "case"
    FROM ({STEPS}) WHERE earlier IS NOT NULL AND amiss != was_amiss"""

QUESTIONS = {
    "verdicts": Question(
        "Verdicts of each target in each version",
        """SELECT subject, version, verdict, sum(cases)::BIGINT AS cases, sum(seconds) AS seconds
        FROM counts JOIN versions USING (subject, version)
        GROUP BY subject, version, place, verdict ORDER BY subject, place, verdict""",
    ),
    "families": Question("Right and amiss by family", _by("family")),
    "flags": Question(
        "Right and amiss by flag; a case counts once for each of its flags",
        _by("flag").replace(
            "FROM counts",
            "FROM (SELECT *, unnest(string_split(flags, ' ')) AS flag FROM counts "
            "WHERE flags != '') AS flagged",
        ),
    ),
    "positions": Question("Right and amiss by the position of the scale", _by("position")),
    "first-seen": Question(
        "Kinds of faults: when and in which versions each was seen first and last",
        f"""SELECT subject, verdict, kind, sum(cases)::BIGINT AS cases,
        arg_min(version, place) AS first_version, arg_max(version, place) AS last_version,
        min(first_at) AS first_at, max(last_at) AS last_at,
        arg_min(example, {{'size': length(example), 'name': example}}) AS example
        FROM counts JOIN versions USING (subject, version) WHERE {AMISS}
        GROUP BY subject, verdict, kind ORDER BY subject, verdict, kind""",
    ),
    "regressions": Question(
        "Cases that one version got right and the next one wrong (broken), or the other way "
        "(mended)",
        f"""SELECT subject, earlier, version, change, kind, count(*) AS cases,
        arg_min("case", {{'size': length("case"), 'name': "case"}}) AS example
        FROM ({CHANGES}) GROUP BY subject, earlier, version, place, change, kind
        ORDER BY subject, place, change, kind""",
    ),
    "slowest": Question(
        "The slowest answers, one of each family and target",
        f"""SELECT subject, version, family, max(most_seconds) AS seconds,
        arg_max(slowest, most_seconds) AS "case" FROM counts WHERE verdict != 'skipped'
        GROUP BY subject, version, family ORDER BY seconds DESC, subject, version, family
        LIMIT {LONGEST_LIST}""",
    ),
    "campaigns": Question("The campaigns in the ledger", "FROM campaigns ORDER BY first_at"),
}


def named(name: str) -> Question:
    """The question of this name. Refuses another name."""
    if name not in QUESTIONS:
        where = f"--question {cut(name)}"
        raise Refusal("there is no such question", where, choice(name, QUESTIONS))
    return QUESTIONS[name]


def ask(con: Any, sql: str, where: str = "SQL") -> Any:
    """The answer as record batches of Arrow, which are read as they come. Refuses anything but one
    SELECT, and what DuckDB refuses."""
    import duckdb

    try:
        statements = con.extract_statements(sql)
    except duckdb.Error as error:
        raise _refused(error, where) from error
    if len(statements) != 1 or statements[0].type != duckdb.StatementType.SELECT:
        mend = "write one SELECT over results, findings, counts, disputed, versions or campaigns"
        raise Refusal("this is no single question", where, mend, "bad-sql")
    try:
        return heard(con, lambda: con.sql(sql).to_arrow_reader(1 << 16))
    except duckdb.Error as error:
        raise _refused(error, where) from error


def batches(con: Any, sql: str, where: str = "SQL") -> Any:
    """The schema of the answer, and an iterator of its record batches."""
    import duckdb

    reader = ask(con, sql, where)

    def read() -> Any:
        try:
            yield from heard_batches(con, reader)
        except (duckdb.Error, OSError) as error:  # Arrow turns errors of DuckDB into its own
            raise _refused(error, where) from error

    return reader.schema, read()


def _refused(error: Exception, where: str) -> Refusal:
    text = cut(str(error))
    mend = "see docs/campaigns-ledger.md for the tables and their columns"
    if "Out of Memory" in text:
        return Refusal(text, where, "ask for less at once, or give more --memory", "memory-limit")
    return Refusal(text, where, mend, "bad-sql")
