"""Checks the cases of paths and traps: schema, canonical form, ids, no case twice, a certificate
for each expected answer; and compares each case with its source's result. `python -m
minkref.degeneracies.motion.case_faults [FOLDER]`: a line for each fault, exit code 1 on any
fault."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
from minkref import _core
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.degeneracies.catalogue import PATH_FAMILIES
from minkref.degeneracies.motion.case_document import DegeneratePath, path_case_id
from minkref.degeneracies.plane.case_texts import canonical_text

ROOM = Path(__file__).parents[1]
CORPUS = Path(__file__).parent / "corpus"
GENERATE = "minkref generate"


def case_validator() -> jsonschema.Draft202012Validator:
    schema = json.loads((ROOM / "schema" / "path-case-v1.json").read_text(encoding="utf-8"))
    return jsonschema.Draft202012Validator(schema)


def case_paths(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*.json") if not path.name.endswith(".cert.json"))


def faults(folder: Path = CORPUS, again: bool = True) -> Iterator[str]:
    """Yields a line for each fault. `again`: makes each case again from its source, to compare."""
    validator = case_validator()
    seen: dict[str, Path] = {}
    for path in case_paths(folder):
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
    sets = []
    for name in "RO":
        try:
            sets.append(_core.PolygonSet.from_json(json.dumps(value[name])))
            sets[-1].validate(name)
        except _core.BadInput as error:
            yield f"{path}: {error}"
            return
    family = value["tags"][0]
    if (
        value["id"] != path_case_id(family, sets[0], sets[1], value["path"])
        or path.stem != value["id"]
    ):
        yield f"{path}: the id is not that of the content"
    if path.parent.name != family:
        yield f"{path}: not in the folder of its family"
    if value["id"] in seen:
        yield f"{path}: the case is that of {seen[value['id']]}"
    seen[value["id"]] = path
    file = path.with_name(value["certificate"])
    if not file.exists():
        yield f"{path}: the certificate {file.name} is missing"
        return
    certificate = json.loads(file.read_text(encoding="utf-8"))
    digest = PathCertificate(sets[0], sets[1], value["path"]).case_digest()
    if certificate["case"] != {"path": path.name, "sha256": digest}:
        yield f"{file}: the certificate of another case"
    ((asked, expected),) = value["expected"].items()
    for contact, ranges in expected.items():
        told = [
            claim[asked]
            for claim in certificate["claims"]
            if asked in claim and claim["contact"] == contact
        ]
        if told != [ranges]:
            yield f"{file}: the scales are not claimed, contact {contact}"


def _differences(path: Path, value: dict[str, Any]) -> Iterator[str]:
    """Yields differences between a case with its certificate and its source's result."""
    words = str(value["source"]).removeprefix(GENERATE).split()
    try:
        family = PATH_FAMILIES[words[0]]
        options = {words[i]: int(words[i + 1]) for i in range(1, len(words), 2)}
        numbers = (options["--seed"], options["--index"])
    except (IndexError, KeyError, ValueError):
        yield f"{path}: the source {value['source']!r} makes nothing"
        return
    made = DegeneratePath.of(family, *numbers)
    document = json.loads(made.case_text)
    for name in sorted(set(document) | set(value)):
        if document.get(name) != value.get(name):
            yield f"{path}: {name} is not what the source makes"
    file = path.with_name(value["certificate"])
    if file.exists() and file.read_text(encoding="utf-8") != made.certificate_text:
        yield f"{file}: not what the source makes"


def main(arguments: list[str]) -> int:
    folder = Path(arguments[0]) if arguments else CORPUS
    found = list(faults(folder))
    for fault in found:
        print(fault)
    print(f"{folder}: {len(case_paths(folder))} cases, {len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
