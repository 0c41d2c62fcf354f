"""The published schema of cases says what the reader says, as far as a schema can."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import jsonschema
import pytest

SCHEMA = Path(__file__).resolve().parents[2] / "degeneracies" / "schema" / "case-v1.json"


@pytest.fixture(scope="module")
def validator() -> jsonschema.protocols.Validator:
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def case(**changes: Any) -> dict[str, Any]:
    triangle = {"polygons": [{"outer": [["0", 0], ["3/7", "0"], ["0", "-30.7428e-2"]]}]}
    members: dict[str, Any] = {
        "schema": "case-v1",
        "id": "a",
        "dimension": 2,
        "P": triangle,
        "Q": {"polygons": []},
        "scales": ["1/3", 2, "1.5", ".5e-3"],
    }
    members.update(changes)
    return {name: value for name, value in members.items() if value is not None}


GOOD = [
    case(),
    case(scales=None, interval={"from": "1/10"}),
    case(scales=None, interval={}),
    case(tags=["hole"], flags=[], source="s", licence="Apache-2.0", certificate="a.cert.json"),
    case(expected=[{"scale": "1", "digest": "0" * 64, "holes": 0, "area": "1/9"}]),
]
BAD = {
    "no scales": case(scales=None),
    "scales and interval": case(interval={}),
    "no scale": case(scales=[]),
    "scale zero": case(scales=["0"]),
    "scale zero as a decimal": case(scales=["0.00e5"]),
    "scale zero as a fraction": case(scales=["0/7"]),
    "negative scale": case(scales=["-1"]),
    "number that is no integer": case(scales=[0.5]),
    "unknown member": case(scale="1"),
    "other version": case(schema="case-v2"),
    "dimension": case(dimension=3),
    "empty id": case(id=""),
    "zero denominator": case(P={"polygons": [{"outer": [["1/0", "0"]]}]}),
    "third coordinate": case(P={"polygons": [{"outer": [["1", "0", "0"]]}]}),
    "NaN": case(P={"polygons": [{"outer": [["NaN", "0"]]}]}),
    "misspelt holes": case(P={"polygons": [{"outer": [["1", "0"]], "hole": []}]}),
    "digest": case(expected=[{"scale": "1", "digest": "ABC"}]),
}


@pytest.mark.parametrize("document", GOOD)
def test_a_good_case_passes_the_schema(
    validator: jsonschema.protocols.Validator, document: dict[str, Any]
) -> None:
    validator.validate(document)


@pytest.mark.parametrize("name", BAD)
def test_a_bad_case_fails_the_schema(validator: jsonschema.protocols.Validator, name: str) -> None:
    assert not validator.is_valid(BAD[name])


def read_fails(document: dict[str, Any]) -> bool:
    core = pytest.importorskip("minkref._core")
    try:
        core.read_text(json.dumps(document), "case", "case.json")
    except core.BadInput:
        return True
    return False


@pytest.mark.parametrize("document", GOOD)
def test_the_reader_accepts_what_the_schema_accepts(document: dict[str, Any]) -> None:
    assert not read_fails(document)


@pytest.mark.parametrize("name", BAD)
def test_the_reader_refuses_what_the_schema_refuses(name: str) -> None:
    assert read_fails(BAD[name])
