"""`minkref campaign query`, `compact` and `site`, as users call them."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import jsonschema
import pytest
from minkref.cli import cli
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.ledgers.part import write_part
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict
from minkref.schemas import schema

pytest.importorskip("duckdb")


@pytest.fixture
def ledger(tmp_path: Path) -> Path:
    folder = tmp_path / "<nightly>"
    for campaign, version, wrong in (("a", "1.0", 1), ("b", "1.1", 2)):
        results = []
        for number in range(3):
            verdict, reasons = Verdict.PASS, ()
            if number == wrong:
                verdict, reasons = Verdict.WRONG, (Reason.EXTRA,)
            outcome = Outcome("my <lib>", verdict, reasons)
            name = CaseName(f"random:1:{number}", "random")
            results.append(CaseResult(number, name, "1", [outcome], "P", "Q", (3, 3, "")))
        write_part(folder, f"{campaign}-random-0", results, {"versions": {"my <lib>": version}})
    (folder / "campaigns").mkdir()
    (folder / "campaigns" / "a.json").write_text('{"name": "first & <b>", "seed": 7}')
    return folder


def test_documents_follow_their_schemas(ledger: Path, capsys: pytest.CaptureFixture[str]) -> None:
    calls = {
        "query": ["--question", "regressions"],
        "compact": [],
        "site": ["-o", str(ledger / "site")],
    }
    for command, more in calls.items():
        assert cli.run(["campaign", command, str(ledger), *more, "--json"]) == 0
        value = json.loads(capsys.readouterr().out)
        jsonschema.validate(value, schema(f"campaign_{command}"))
    assert value["subjects"] == ["my <lib>"]


def test_an_answer_is_written_in_each_form(ledger: Path, tmp_path: Path) -> None:
    """Law: all forms have the same rows."""
    parquet = pytest.importorskip("pyarrow.parquet")
    sql = 'SELECT "case", version, number, verdict FROM results ORDER BY ALL'
    for form in ("json", "jsonl", "csv", "parquet"):
        path = str(tmp_path / f"x.{form}")
        assert cli.run(["campaign", "query", str(ledger), sql, "-o", path]) == 0
    rows = json.loads((tmp_path / "x.json").read_text())["rows"]
    assert len(rows) == 6 and rows[0] == ["random:1:0", "1.0", 0, "pass"]
    lines = (tmp_path / "x.jsonl").read_text().splitlines()
    assert [list(json.loads(line).values()) for line in lines] == rows
    with (tmp_path / "x.csv").open() as file:
        assert list(csv.reader(file))[1:] == [[str(each) for each in row] for row in rows]
    table = parquet.read_table(tmp_path / "x.parquet").to_pylist()
    assert [list(row.values()) for row in table] == rows


@pytest.mark.parametrize(
    "words",
    [[], ["SELECT 1", "--question", "verdicts"], ["--question", "nope"], ["SELEC"],
     ["SELECT 1", "-o", "x.xls"],
     ["SELECT 1 AS x, 2 AS x", "-o", "x.jsonl"], ["SELECT 1", "--memory", "1"]],
)  # fmt: skip
def test_bad_questions_are_refused(
    ledger: Path, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.run(["campaign", "query", str(ledger), *words]) == 2
    assert "fix: " in capsys.readouterr().err


def test_a_folder_without_ledger_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for words in (["compact"], ["query", "--question", "verdicts"], ["site", "-o", "s"]):
        assert cli.run(["campaign", words[0], str(tmp_path), *words[1:]]) == 2
        assert "no ledger" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_pages_tell_what_a_release_changed(ledger: Path) -> None:
    """Texts of targets and campaigns are escaped."""
    site = ledger / "site"
    assert cli.run(["campaign", "site", str(ledger), "-o", str(site), "--live"]) == 0
    front = (site / "index.html").read_text()
    (page,) = site.glob("history-*.html")
    text = page.read_text()
    assert "my &lt;lib&gt;" in front and "first &amp; &lt;b&gt;" in front and "<lib>" not in text
    assert page.name in front and "location.reload" in front
    for word in ("mended", "broken", "random:1:1", "random:1:2", "2/3"):
        assert word in text
