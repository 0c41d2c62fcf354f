"""A folder's cases, prepared for the pages."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import jsonschema
from minkref.degeneracies import lint
from minkref.errors import Refusal, cut, message_of
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.case_file import is_in_space, read_space_case, scalings_in
from minkref.plane.operand import read_operand

SIBLINGS = 3  # scales at least: one, one below, one above


def cases_in(paths: Iterable[Path]) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Yields cases one at a time. Refuses files that are not cases, or lack parts for the pages."""
    validator = _validator()
    for path in paths:
        value = _read(path)
        error = next(iter(validator.iter_errors(value)), None)
        if error is not None:
            code = "missing-member" if error.validator == "required" else "wrong-type"
            raise unfit(path, cut(f"{error.json_path}: {error.message}"), code)
        scales = (
            scalings_in(value, str(path))
            if is_in_space(value)
            else [str(scale) for scale in value["scales"]]
        )
        yield path, {**value, "scales": scales}


def cases_of_schema(paths: Iterable[Path], schema: str) -> Iterator[tuple[Path, dict[str, Any]]]:
    """Yields cases in a format of their own, one at a time. Refuses files that are not a family's
    cases."""
    for path in paths:
        try:
            value = json.loads(path.read_text(encoding="utf-8"))
        except (ValueError, RecursionError) as error:
            raise unfit(path, f"this is no JSON: {message_of(error)}", "syntax") from error
        wrong = next(iter(lint.validator(schema).iter_errors(value)), None)
        if wrong is not None:
            raise unfit(path, cut(f"{wrong.json_path}: {wrong.message}"), "wrong-type")
        if not {"title", "expected", "degeneracy"} <= set(value):
            raise unfit(path, "this is a case of no family", "wrong-type")
        yield path, value


def _read(path: Path) -> Any:
    """Reads the case and checks its operands."""
    value = _json_of(path)
    if is_in_space(value):
        space_case(path)
    else:
        _read_operands(path)
    return value


def _json_of(path: Path) -> Any:
    """The file's JSON; None if malformed: the operand reader reports the fault."""
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (ValueError, RecursionError):
        return None


def space_case(path: Path) -> SpaceCase:
    return read_space_case(CaseName(str(path), "report"), path, "1")


def _read_operands(path: Path) -> None:
    try:
        for part in ("#P", "#Q"):
            read_operand(f"{path}{part}")
    except Refusal as refusal:
        if refusal.code != "not-a-case":
            raise
        raise unfit(path, "this is no case (case-v1)", refusal.code) from refusal


def _validator() -> jsonschema.Draft202012Validator:
    """A validator for the parts that pages show: the case schema, with degeneracy and siblings
    required. The operand reader has checked P and Q; hidden parts may be large."""
    schema = json.loads((lint.ROOM / "schema" / "case-v1.json").read_text(encoding="utf-8"))
    schema["required"] += ["scales", "degeneracy"]
    kinds = schema["$defs"]
    schema["properties"]["scales"]["minItems"] = SIBLINGS
    for members in (schema, schema["then"], schema["else"]):
        members["properties"] |= dict.fromkeys(("P", "Q", "expected"), True)
    parts, others = (kinds[n]["properties"] for n in ("degeneracy", "degeneracy_in_space"))
    parts["floats"]["minItems"] = others["floats"]["minItems"] = others["facets"]["minItems"] = 1
    parts |= dict.fromkeys(("events", "topology"), True)
    return jsonschema.Draft202012Validator(schema)


def unfit(path: Path, what: str, code: str) -> Refusal:
    mend = "make it again with `minkref generate`, or take it out of the folder"
    return Refusal(what, str(path), mend, code)
