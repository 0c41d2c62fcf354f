"""JUnit, SARIF, Markdown and JSON lines of a run made by hand."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ElementTree
from typing import Any

import pytest
from minkref.fuzz.isolation.isolation import Isolation
from minkref.fuzz.verdicts.verdict import BROKEN, Reason, Verdict
from minkref.reports.conformance.junit import junit
from minkref.reports.conformance.lines import json_lines
from minkref.reports.conformance.markdown import markdown
from minkref.reports.conformance.sarif import sarif
from minkref.reports.conformance.words import REASONS, SIGNS, VERDICTS, ending, meaning


def test_every_verdict_and_reason_has_words_and_a_sign() -> None:
    assert set(VERDICTS) == set(SIGNS) == set(Verdict)
    assert set(REASONS) == set(Reason)
    assert len(set(SIGNS.values())) == len(SIGNS)
    assert all(meaning(str(kind)) != str(kind) for kind in (*Reason, *BROKEN))
    assert len({ending(code) for code in range(5)}) == 5


def test_junit_counts_and_tells_each_kind_where_it_was_found(made: Any) -> None:
    root = ElementTree.fromstring(junit(made.run, made.groups))
    suites = {suite.get("name"): suite for suite in root}
    assert len(suites) == 6
    counts = {
        name: [suite.get(key) for key in ("tests", "failures", "errors", "skipped")]
        for name, suite in suites.items()
    }
    assert counts["minkref:paper"] == ["2", "0", "0", "0"]
    assert counts["pysfcgal"] == ["2", "2", "0", "0"]
    assert counts["cgal-reduced"] == ["1", "0", "0", "0"]
    assert [root.get(key) for key in ("tests", "failures", "errors")] == [
        str(sum(int(row[k] or 0) for row in counts.values())) for k in range(3)
    ]
    assert float(suites["minkref:paper"].get("time") or 0) == 0.5
    (hostile,) = (suite for name, suite in suites.items() if name and "script" in name)
    assert "\\x1b" in (hostile.get("name") or "")
    (failure,) = (e for e in suites["pysfcgal"].iter("failure") if "hole-lost" in (e.text or ""))
    assert "--case" in (failure.text or "")


COUNTS = {"name", "time", "tests", "failures", "errors"}
# For each element, after junit-10.xsd: all attributes, required attributes, allowed children.
JUNIT: dict[str, tuple[set[str], set[str], set[str]]] = {
    "testsuites": (COUNTS, set(), {"testsuite"}),
    "testsuite": (
        {*COUNTS, "skipped", "timestamp", "hostname", "id", "package", "file"},
        {"name", "tests", "failures", "errors"},
        {"testsuite", "properties", "testcase", "system-out", "system-err"},
    ),
    "properties": (set(), set(), {"property"}),
    "property": ({"name", "value"}, {"name", "value"}, set()),
    "testcase": (
        {"name", "time", "classname", "group"},
        {"name"},
        {"skipped", "error", "failure", "system-out", "system-err"},
    ),
    **{name: ({"type", "message"}, set(), set()) for name in ("failure", "error", "skipped")},
    "system-out": (set(), set(), set()),
}


def test_junit_has_nothing_that_its_schema_forbids(made: Any) -> None:
    walls = Isolation("none", "bubblewrap is not installed", passed=("LICENCE", "DISPLAY"))
    root = ElementTree.fromstring(junit(made.run, made.groups, walls))
    said = {one.get("name"): one.get("value") for one in root.iter("property")}
    assert (said["isolation.kind"], said["isolation.passed"]) == ("none", "LICENCE, DISPLAY")
    assert root.tag == "testsuites"
    for element in root.iter():
        may, must, inside = JUNIT[element.tag]
        assert must <= set(element.attrib) <= may, element.tag
        assert {child.tag for child in element} <= inside
        assert re.fullmatch(r"\d*(\.\d*)?", element.get("time", "0"))


def required(value: dict[str, Any], fields: dict[str, type]) -> None:
    for name, kind in fields.items():
        assert isinstance(value[name], kind), name


def test_sarif_has_what_its_schema_demands(made: Any) -> None:
    document = json.loads(sarif(made.groups, made.value))
    required(document, {"version": str, "runs": list, "$schema": str})
    assert document["version"] == "2.1.0"
    (run,) = document["runs"]
    required(run, {"tool": dict, "results": list, "invocations": list})
    driver = run["tool"]["driver"]
    required(driver, {"name": str, "version": str, "rules": list})
    ids = [rule["id"] for rule in driver["rules"]]
    assert len(ids) == len(set(ids)) == 4
    for rule in driver["rules"]:
        assert set(rule) <= {"id", "shortDescription", "fullDescription"}
        required(rule["shortDescription"], {"text": str})
    for invocation in run["invocations"]:
        required(invocation, {"executionSuccessful": bool, "exitCode": int})
    assert len(run["results"]) == 5
    for result in run["results"]:
        required(result, {"ruleId": str, "ruleIndex": int, "message": dict, "locations": list})
        assert ids[result["ruleIndex"]] == result["ruleId"]
        assert result["level"] in ("none", "note", "warning", "error")
        assert result["message"]["text"]
        for location in result["locations"]:
            for logical in location["logicalLocations"]:
                required(logical, {"name": str, "kind": str})
        assert all(isinstance(text, str) for text in result["partialFingerprints"].values())
        assert "\x1b" not in json.dumps(result, ensure_ascii=False).replace("\\u001b", "\x1b") or (
            "script" in result["properties"]["reproduce"]
        )
    levels = {r["locations"][0]["logicalLocations"][0]["name"]: r["level"] for r in run["results"]}
    assert (levels["pysfcgal"], levels["cgal-reduced"]) == ("error", "note")
    (known,) = (result for result in run["results"] if "suppressions" in result)
    assert known["suppressions"] == [{"kind": "external", "justification": "CGAL issue 5830 <b>"}]


def test_markdown_is_a_table_in_which_nothing_is_markup(made: Any) -> None:
    made.run.targets.append("py:a|b`c*d")
    text = markdown(made.run, made.groups, made.value)
    table = [line for line in text.splitlines() if line.startswith("|")]
    assert len(table) == 2 + 7
    bars = {line.replace("\\|", "").count("|") for line in table}
    assert bars == {4}
    assert "| 7/7<br>2 within<br>2 skipped |" in text
    assert "3/7<br>4 wrong<br>1 skipped<br>1 not asked" in text
    outside = [line for line in text.splitlines() if not line.startswith("    ")]
    assert not any("<script" in line or "\x1b" in line for line in outside)
    assert "- minkref:paper: 2 skipped: does not declare &lt;space&gt;" in outside
    assert "- openscad is absent: not &lt;installed&gt;" in outside


def test_json_lines_are_one_document_each(made: Any) -> None:
    text = json_lines(made.value)
    rows = [json.loads(line) for line in text.splitlines()]
    assert [row["is"] for row in rows] == ["run", *["finding"] * 5, "shrunk", "end"]
    assert (rows[0]["seed"], rows[-1]["exit_code"], rows[-1]["findings"]) == (7, 1, 5)
    assert text.isascii()


@pytest.mark.parametrize("code", [0, 1, 2, 3, 4])
def test_the_end_is_told(made: Any, code: int) -> None:
    made.value["exit_code"] = code
    assert ending(code).rstrip(".")[:20] in markdown(made.run, [], made.value)
