"""Checks the cases with a disc: schema, canonical form, ids, no case twice; and compares each with
its source's result. `python -m minkref.degeneracies.disc.case_faults [FOLDER]`: a line for each
fault, exit code 1 on any fault."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
from minkref import _core
from minkref.degeneracies.catalogue import DISC_FAMILIES
from minkref.degeneracies.disc.case_document import DegenerateWithDisc
from minkref.degeneracies.plane.case_document import set_content
from minkref.degeneracies.plane.case_faults import of_place
from minkref.degeneracies.plane.case_texts import canonical_text

ROOM = Path(__file__).parents[1]
CORPUS = Path(__file__).parent / "corpus"
GENERATE = "minkref generate"


def case_validator() -> jsonschema.Draft202012Validator:
    schema = json.loads((ROOM / "schema" / "disc-case-v1.json").read_text(encoding="utf-8"))
    return jsonschema.Draft202012Validator(schema)


def faults(folder: Path = CORPUS, again: bool = True) -> Iterator[str]:
    """Yields a line for each fault. `again`: makes each case again from its source, to compare."""
    validator = case_validator()
    seen: dict[str, Path] = {}
    for path in sorted(folder.rglob("*.json")):
        text = path.read_text(encoding="utf-8")
        try:
            value = json.loads(text)
        except ValueError as error:
            yield f"{path}: {error}"
            continue
        errors = [f"{e.json_path}: {e.message}" for e in validator.iter_errors(value)]
        if errors:
            yield from (f"{path}: {error}" for error in errors)
            continue
        if text != canonical_text(value):
            yield f"{path}: not in canonical form"
        yield from _of_content(path, value, seen)
        if again:
            yield from _differences(path, value)


def _of_content(path: Path, value: dict[str, Any], seen: dict[str, Path]) -> Iterator[str]:
    try:
        P = _core.PolygonSet.from_json(json.dumps(value["P"]))
        P.validate("P")
    except _core.BadInput as error:
        yield f"{path}: {error}"
        return
    squares = value["squared_radii"]
    yield from of_place(path, value, json.dumps(set_content(P)), squares, seen)
    if [row["squared_radius"] for row in value["expected"]] != squares:
        yield f"{path}: not each radius has its expected result"


def _differences(path: Path, value: dict[str, Any]) -> Iterator[str]:
    """Yields differences between a case and its source's result."""
    words = str(value["source"]).removeprefix(GENERATE).split()
    try:
        family = DISC_FAMILIES[words[0]]
        options = {words[i]: int(words[i + 1]) for i in range(1, len(words), 2)}
        numbers = (options["--seed"], options["--index"], options.get("--size"))
    except (IndexError, KeyError, ValueError):
        yield f"{path}: the source {value['source']!r} makes nothing"
        return
    document = json.loads(DegenerateWithDisc.of(family, *numbers).case_text)
    for name in sorted(set(document) | set(value)):
        if document.get(name) != value.get(name):
            yield f"{path}: {name} is not what the source makes"


def main(arguments: list[str]) -> int:
    folder = Path(arguments[0]) if arguments else CORPUS
    found = list(faults(folder))
    for fault in found:
        print(fault)
    print(f"{folder}: {len(list(folder.rglob('*.json')))} cases, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
